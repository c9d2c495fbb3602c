import { NeedsMainThread } from '../formats/base/needs-main-thread.ts';

// In place of all modules that are imported as `#rare/…`, in the worker for usual files: importing them fails, and the page starts the
// worker that has all readers.
throw new NeedsMainThread({ cause: 'left out of this worker' });
