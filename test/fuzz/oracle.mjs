// Runs cases in a worker, and says what came of them also where the worker does not come back.
import { Worker } from 'node:worker_threads';

/** @typedef {import('./fuzz-case.ts').FuzzCase} FuzzCase */
/** @typedef {import('./judge.ts').Verdict} Verdict */
/** @typedef {import('./messages.ts').Order} Order */
/** @typedef {import('./messages.ts').Answer} Answer */
/** @typedef {{ made: FuzzCase | null, verdict: Verdict, kept: number }} Result */

/** Megabytes that the worker's heap may grow to: what a case may hold, and what the runtime holds itself. */
const heapMb = 160;
/** Milliseconds of the processor's time after which a case is ended, and of any time. */
const mostCpuMs = 6000;
const mostWaitMs = 60_000;

export class Oracle {
  /** @type {URL} */ #script;
  /** @type {Promise<Worker> | null} */ #worker = null;
  /** @type {readonly string[]} */ formats = [];
  /** @type {readonly string[]} */ named = [];

  /** @param {URL} script - of the worker */
  constructor(script) {
    this.#script = script;
  }

  /** @returns {Promise<Worker>} */
  #start() {
    const worker = new Worker(this.#script, { resourceLimits: { maxOldGenerationSizeMb: heapMb, maxYoungGenerationSizeMb: 32 } });
    worker.unref();
    return new Promise((resolve, reject) => {
      worker.once('error', reject);
      worker.once('message', (/** @type {Answer} */ answer) => {
        if (answer.type === 'ready') [this.formats, this.named] = [answer.formats, answer.named];
        worker.off('error', reject);
        resolve(worker);
      });
    });
  }

  async ready() {
    await (this.#worker ??= this.#start());
  }

  /** Forget what the worker has learnt: what follows depends on nothing that was before. */
  async restart() {
    const worker = await this.#worker;
    this.#worker = null;
    await worker?.terminate();
  }

  /**
   * @param {Order} order
   * @returns {Promise<Result>}
   */
  async run(order) {
    const worker = await (this.#worker ??= this.#start());
    /** @type {FuzzCase | null} */
    let made = null;
    const start = { wall: Date.now(), cpu: process.cpuUsage() };
    return new Promise((resolve) => {
      /** @param {string} outcome @param {string} detail */
      const fail = (outcome, detail) => {
        const { user, system } = process.cpuUsage(start.cpu);
        const finding = { kind: outcome, detail };
        finish({ made, kept: 0, verdict: { outcome, finding, ms: (user + system) / 1000, peak: 0, size: 0 } });
        this.#worker = null;
        worker.on('error', () => undefined);
        void worker.terminate();
      };
      const watch = setInterval(() => {
        const { user, system } = process.cpuUsage(start.cpu);
        if ((user + system) / 1000 > mostCpuMs) fail('time', `no answer in ${mostCpuMs} ms of the processor's time`);
        else if (Date.now() - start.wall > mostWaitMs) fail('no answer', `nothing happens any more, for ${mostWaitMs} ms`);
      }, 250);
      /** @param {Result} result */
      const finish = (result) => {
        clearInterval(watch);
        worker.off('message', hear);
        worker.off('error', endBadly);
        resolve(result);
      };
      /** @param {NodeJS.ErrnoException} error */
      const endBadly = (error) => {
        const isHeap = error.code === 'ERR_WORKER_OUT_OF_MEMORY';
        fail(isHeap ? 'memory' : 'crash', isHeap ? `more than ${heapMb} MB of the heap` : String(error.stack ?? error));
      };
      /** @param {Answer} answer */
      const hear = (answer) => {
        if (answer.type === 'made') ({ made } = answer);
        else if (answer.type === 'judged') finish({ made, verdict: answer.verdict, kept: answer.kept });
      };
      worker.on('error', endBadly);
      worker.on('message', hear);
      worker.postMessage(order);
    });
  }
}
