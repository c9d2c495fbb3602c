// A child process: it does one job after another, so that a file that takes all memory, or hangs, ends this process and not the program.
import type { Job } from './job.ts';
import { runJob } from './run-job.ts';

// Readers may warn of a mosaic without spacing, and so on; the program's output is its own.
console.warn = console.info = console.log = () => undefined;

process.on('message', (job: Job) => {
  void runJob(job).then((result) => process.send!(result));
});
process.on('disconnect', () => process.exit());
