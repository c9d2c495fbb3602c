import type { VolumeViewError } from '../errors.ts';
import { toVolumeViewError } from './settings.ts';

/** What of an element can fail independently, in the order in which it is shown. */
export type Aspect = 'source' | 'time' | 'play' | 'optics' | 'camera' | 'steps' | 'region' | 'slices' | 'rings' | 'scene';

const aspects: readonly Aspect[] = ['source', 'time', 'play', 'optics', 'camera', 'steps', 'region', 'slices', 'rings', 'scene'];

/** What a board tells its element. */
export interface ErrorListener {
  /** The error to be shown, null where all is well, whenever that may have changed. */
  show(error: VolumeViewError | null): void;
  /** Another thing went wrong. */
  told(aspect: Aspect, error: VolumeViewError): void;
}

/** What is wrong with an element at the moment: at most one error an aspect. */
export class ErrorBoard {
  readonly #errors = new Map<Aspect, VolumeViewError>();

  constructor(readonly listener: ErrorListener) {}

  report(aspect: Aspect, error: VolumeViewError): void {
    this.#errors.set(aspect, error);
    this.#showFirst();
    this.listener.told(aspect, error);
  }

  /** Do something of an aspect; what it throws is shown and told. */
  attempt(aspect: Aspect, act: () => void): void {
    try {
      act();
      this.clear(aspect);
    } catch (error) {
      this.report(aspect, toVolumeViewError(error));
    }
  }

  /** Run some work of an aspect; what it throws is shown and told, unless it was given up. Returns whether it was done. */
  async run(aspect: Aspect, signal: AbortSignal | null, work: () => Promise<void>): Promise<boolean> {
    try {
      await work();
      if (!signal?.aborted) this.clear(aspect);
      return true;
    } catch (error) {
      if (!signal?.aborted) this.report(aspect, toVolumeViewError(error));
      return false;
    }
  }

  clear(aspect: Aspect): void {
    if (this.#errors.delete(aspect)) this.#showFirst();
  }

  #showFirst(): void {
    const first = aspects.find((aspect) => this.#errors.has(aspect));
    this.listener.show(first ? this.#errors.get(first)! : null);
  }
}
