// Runs cases in a process of their own, and says what came of them also where it does not come back.
import { fork } from 'node:child_process';
import { fileURLToPath } from 'node:url';

/** @typedef {import('./fuzz-case.ts').FuzzCase} FuzzCase */
/** @typedef {import('./verdict.ts').Verdict} Verdict */
/** @typedef {import('./messages.ts').Order} Order */
/** @typedef {import('./messages.ts').Answer} Answer */
/** @typedef {import('node:child_process').ChildProcess} ChildProcess */
/** @typedef {{ made: FuzzCase | null, verdict: Verdict, kept: number }} Result */

export class Oracle {
  /** @type {URL} */ #script;
  /** @type {Promise<ChildProcess> | null} */ #cage = null;
  /** @type {readonly string[]} */ formats = [];
  /** @type {readonly string[]} */ named = [];

  /** @param {URL} script - of the worker */
  constructor(script) {
    this.#script = script;
  }

  /** @returns {Promise<ChildProcess>} */
  #start() {
    const cage = fork(fileURLToPath(new URL('cage.mjs', import.meta.url)), [this.#script.href], {
      serialization: 'advanced',
      stdio: ['ignore', 'inherit', 'ignore', 'ipc'],
    });
    return new Promise((resolve, reject) => {
      cage.once('exit', reject);
      cage.once('message', (/** @type {any} */ answer) => {
        if (answer.type === 'ready') [this.formats, this.named] = [answer.formats, answer.named];
        cage.off('exit', reject);
        resolve(cage);
      });
    });
  }

  async ready() {
    await (this.#cage ??= this.#start());
  }

  /** Forget what the worker has learnt: what follows depends on nothing that was before. */
  async restart() {
    const cage = await this.#cage;
    this.#cage = null;
    cage?.kill();
  }

  /**
   * A case that takes long is run again: other programs slow the processor down for all.
   * @param {Order} order
   * @returns {Promise<Result>}
   */
  async run(order) {
    const first = await this.#runOnce(order);
    if (first.verdict.finding?.kind !== 'time' || !first.made) return first;
    const second = await this.#runOnce({ type: 'given', made: first.made });
    return second.verdict.ms < first.verdict.ms ? second : first;
  }

  /**
   * @param {Order} order
   * @returns {Promise<Result>}
   */
  async #runOnce(order) {
    const cage = await (this.#cage ??= this.#start());
    /** @type {FuzzCase | null} */
    let made = null;
    return new Promise((resolve) => {
      /** @param {Verdict} verdict @param {number} kept */
      const finish = (verdict, kept) => {
        cage.off('message', hear);
        cage.off('exit', endBadly);
        resolve({ made, verdict, kept });
      };
      /** @param {any} answer */
      const hear = (answer) => {
        if (answer.type === 'made') ({ made } = answer);
        else if (answer.type === 'judged') finish(answer.verdict, answer.kept);
        // What does not go on is over: the next case begins anew.
        if (answer.type === 'judged' && ['time', 'memory', 'crash', 'no answer'].includes(answer.verdict.outcome))
          void this.restart();
      };
      /** @param {number | null} code @param {string | null} signal */
      const endBadly = (code, signal) => {
        this.#cage = null;
        // The engine ends its process where one array more does not fit into the heap.
        const finding = {
          kind: signal === 'SIGABRT' ? 'memory' : 'crash',
          detail: `the process ended with ${signal ?? code}`,
        };
        finish({ outcome: finding.kind, finding, ms: 0, peak: 0, size: 0 }, 0);
      };
      cage.on('message', hear);
      cage.on('exit', endBadly);
      cage.send(order);
    });
  }
}
