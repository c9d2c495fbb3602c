import { asVolumeViewError } from '../../core/errors.ts';
import type { VolumeViewError } from '../../core/errors.ts';
import type { Reading } from './settings.ts';

/** What can fail in an element independently of the rest, with the names for messages, in the order in which errors are shown. */
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
  notes: 'notes',
  scene: 'the picture',
  check: 'self-check',
} as const;

export type Aspect = keyof typeof aspects;

/** What an `ErrorState` reports to its element. */
export interface ErrorListener {
  /** The file that is shown or loaded, for messages about unexpected errors. */
  readonly file: string;
  /** The error to be shown, `first`, may have changed. */
  changed(): void;
  /** Another error happened. */
  failed(aspect: Aspect, error: VolumeViewError): void;
}

/** The present errors of an element: at most one for each aspect. */
export class ErrorState {
  readonly #errors = new Map<Aspect, VolumeViewError>();

  constructor(readonly listener: ErrorListener) {}

  /** The error to be shown; null where there is none. */
  get first(): VolumeViewError | null {
    const first = (Object.keys(aspects) as Aspect[]).find((aspect) => this.#errors.has(aspect));
    return first ? this.#errors.get(first)! : null;
  }

  /** @param thrown - any value; an error without a message for users is reported as `internal` */
  report(aspect: Aspect, thrown: unknown): void {
    const error = asVolumeViewError(thrown, `${aspects[aspect]} of "${this.listener.file}"`);
    this.#errors.set(aspect, error);
    this.listener.changed();
    this.listener.failed(aspect, error);
  }

  /** Do something for an aspect; show and report what it throws. */
  attempt(aspect: Aspect, act: () => void): void {
    try {
      act();
      this.clear(aspect);
    } catch (error) {
      this.report(aspect, error);
    }
  }

  /** Use the value of attributes; show and report the error of reading or of using them. */
  take<T>(aspect: Aspect, reading: Reading<T>, use: (value: T) => void): void {
    this.attempt(aspect, () => {
      if (reading.error) throw reading.error;
      use(reading.value);
    });
  }

  /** Run some work for an aspect; show and report what it throws, unless the work was given up. Returns whether the work succeeded. */
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
