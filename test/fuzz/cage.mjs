// A process with one worker in it, whose heap is limited. It hands orders to the worker and answers back, and watches how much of
// the processor's time a case takes: that of the whole process, as nothing else runs in it.
import { Worker } from 'node:worker_threads';

/** Megabytes that the worker's heap may grow to: what the largest cases may hold. What smaller ones hold is measured in the worker. */
const heapMb = 400;
/** Milliseconds of the processor's time after which a case is ended. */
const maxCpuMs = 10_000;
/** Milliseconds after which a case that takes less than that of the processor's time waits for what never comes. */
const maxWaitMs = 60_000;
const minCpuMs = 500;

const worker = new Worker(new URL(process.argv[2]), {
  resourceLimits: { maxOldGenerationSizeMb: heapMb, maxYoungGenerationSizeMb: 32 },
});
let start = { wall: Infinity, cpu: process.cpuUsage() };

/** @param {string} outcome @param {string} detail */
function fail(outcome, detail) {
  /** @type {import('./verdict.ts').Verdict} */
  const verdict = { outcome, finding: { kind: outcome, detail }, ms: usedMs(), peak: 0, size: 0 };
  process.send?.({ type: 'judged', verdict, kept: 0 }, () => process.exit());
}

function usedMs() {
  const { user, system } = process.cpuUsage(start.cpu);
  return (user + system) / 1000;
}

process.on('message', (order) => {
  start = { wall: Date.now(), cpu: process.cpuUsage() };
  worker.postMessage(order);
});
process.once('disconnect', () => process.exit());
worker.on('message', (answer) => {
  if (answer.type === 'judged') start = { wall: Infinity, cpu: start.cpu };
  process.send?.(answer);
});
worker.on('error', (/** @type {NodeJS.ErrnoException} */ error) => {
  const isHeap = error.code === 'ERR_WORKER_OUT_OF_MEMORY';
  fail(isHeap ? 'memory' : 'crash', isHeap ? `more than ${heapMb} MB of the heap` : String(error.stack ?? error));
});
setInterval(() => {
  if (start.wall === Infinity) return;
  if (usedMs() > maxCpuMs) fail('time', `no answer in ${maxCpuMs} ms of the processor's time`);
  else if (Date.now() - start.wall > maxWaitMs && usedMs() < minCpuMs)
    fail('no answer', `nothing happens any more, for ${maxWaitMs} ms`);
}, 250);
