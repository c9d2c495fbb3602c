import { Session } from 'node:inspector';

interface Range {
  readonly startOffset: number;
  readonly endOffset: number;
  readonly count: number;
}

interface Script {
  readonly url: string;
  readonly functions: readonly { readonly ranges: readonly Range[]; readonly isBlockCoverage: boolean }[];
}

/** Which blocks of the code have been reached, as V8 itself counts them. */
class Coverage {
  readonly #session = new Session();
  readonly #seen = new Set<string>();
  #isOn = false;

  /** Whether code was reached since the last call that had never been reached before. */
  async grew(): Promise<boolean> {
    if (!this.#isOn) await this.#start();
    const { result } = await this.#ask<{ result: readonly Script[] }>('Profiler.takePreciseCoverage');
    const before = this.#seen.size;
    for (const { url, functions } of result) {
      if (!url.startsWith('file:')) continue;
      for (const { ranges } of functions) {
        for (const { startOffset, endOffset, count } of ranges)
          if (count > 0) this.#seen.add(`${startOffset} ${endOffset}`);
      }
    }
    return this.#seen.size > before;
  }

  async #start(): Promise<void> {
    this.#isOn = true;
    this.#session.connect();
    await this.#ask('Profiler.enable');
    await this.#ask('Profiler.startPreciseCoverage', { callCount: false, detailed: true });
  }

  #ask<T>(method: string, params: object = {}): Promise<T> {
    return new Promise((resolve, reject) => {
      this.#session.post(method, params, (error, result) =>
        error ? reject(new Error(error.message)) : resolve(result as T),
      );
    });
  }
}

export const coverage = new Coverage();
