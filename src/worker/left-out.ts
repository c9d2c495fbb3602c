// In place of all modules that are imported as `#rare/…`, in the worker for usual files: importing them fails, and the page starts the
// worker that has all readers.
throw new Error('left out of this worker');
