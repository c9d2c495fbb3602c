// In place of large libraries, in all workers that are texts but one: importing it fails, and the page starts that one, or does the work
// itself.
throw new Error('this worker has no such library');
