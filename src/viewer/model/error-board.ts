import { asVolumeViewError } from '../../core/errors.ts';
import type { VolumeViewError } from '../../core/errors.ts';
import type { Reading } from './settings.ts';

/** What of an element can fail independently, and what it is called, in the order in which it is shown. */
const aspects = {
  source: 'the file',
  time: 'time',
  play: 'play-speed',
  optics: 'transfer-function, window and factors',
  camera: 'camera-orbit, camera-target and field-of-view',
  limits: 'min-camera-orbit, max-camera-orbit and interpolation-decay',
  rotation: 'auto-rotate-delay and rotation-per-second',
  steps: 'steps, max-error and target-fps',
  region: 'region',
  slices: 'the volume-slice elements',
  rings: 'rings',
  labels: 'labels',
  surfaces: 'surfaces',
  overlay: 'the layer',
  scene: 'the picture',
  check: 'self-check',
} as const;

export type Aspect = keyof typeof aspects;

/** What a board tells its element. */
export interface ErrorListener {
  /** The file that is shown or loaded, for errors that nobody expects. */
  readonly file: string;
  /** The error to be shown, the board's first, may be another one. */
  changed(): void;
  /** Another thing went wrong. */
  failed(aspect: Aspect, error: VolumeViewError): void;
}

/** What is wrong with an element at the moment: at most one error an aspect. */
export class ErrorBoard {
  readonly #errors = new Map<Aspect, VolumeViewError>();

  constructor(readonly listener: ErrorListener) {}

  /** The error that is shown; null where all is well. */
  get first(): VolumeViewError | null {
    const first = (Object.keys(aspects) as Aspect[]).find((aspect) => this.#errors.has(aspect));
    return first ? this.#errors.get(first)! : null;
  }

  /** @param thrown - whatever it is; what has no words of its own is told as `internal` */
  report(aspect: Aspect, thrown: unknown): void {
    const error = asVolumeViewError(thrown, `${aspects[aspect]} of "${this.listener.file}"`);
    this.#errors.set(aspect, error);
    this.listener.changed();
    this.listener.failed(aspect, error);
  }

  /** Do something of an aspect; what it throws is shown and told. */
  attempt(aspect: Aspect, act: () => void): void {
    try {
      act();
      this.clear(aspect);
    } catch (error) {
      this.report(aspect, error);
    }
  }

  /** Use what attributes say; what is wrong with them, or comes of them, is shown and told. */
  take<T>(aspect: Aspect, reading: Reading<T>, use: (value: T) => void): void {
    this.attempt(aspect, () => {
      if (reading.error) throw reading.error;
      use(reading.value);
    });
  }

  /** Run some work of an aspect; what it throws is shown and told, unless it was given up. Returns whether it was done. */
  async run(aspect: Aspect, signal: AbortSignal | null, work: () => Promise<void>): Promise<boolean> {
    try {
      await work();
      if (!signal?.aborted) this.clear(aspect);
      return true;
    } catch (error) {
      if (!signal?.aborted) this.report(aspect, error);
      return false;
    }
  }

  clear(aspect: Aspect): void {
    if (this.#errors.delete(aspect)) this.listener.changed();
  }
}
