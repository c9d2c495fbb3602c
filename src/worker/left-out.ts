// In place of all modules that are imported as `#rare/…`, in the worker for usual files, and of large libraries in all workers but one:
// importing them fails, and the page starts the next worker, or does the work itself.
throw new Error('left out of this worker');
