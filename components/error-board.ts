import type { VolumeViewError } from '../src/errors.ts';

/** What of an element can fail independently, in the order in which it is shown. */
export type Aspect = 'source' | 'time' | 'play' | 'optics' | 'camera' | 'steps' | 'region' | 'slices' | 'rings' | 'scene';

const aspects: readonly Aspect[] = ['source', 'time', 'play', 'optics', 'camera', 'steps', 'region', 'slices', 'rings', 'scene'];

/** What is wrong with an element at the moment: at most one error an aspect. */
export class ErrorBoard {
  readonly #errors = new Map<Aspect, VolumeViewError>();

  /** @param show - is given the error to be shown, null where all is well, whenever that may have changed */
  constructor(readonly show: (error: VolumeViewError | null) => void) {}

  report(aspect: Aspect, error: VolumeViewError): void {
    this.#errors.set(aspect, error);
    this.#showFirst();
  }

  clear(aspect: Aspect): void {
    if (this.#errors.delete(aspect)) this.#showFirst();
  }

  #showFirst(): void {
    const first = aspects.find((aspect) => this.#errors.has(aspect));
    this.show(first ? this.#errors.get(first)! : null);
  }
}
