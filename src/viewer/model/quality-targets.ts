/** What an author requires of pictures. */
export interface QualityTargets {
  /** Steps along the longest ray; with auto the quality control chooses them. */
  readonly steps: number | 'auto';
  /** The error that a picture at rest may have, 1/255: see `keptError` of quality/error-estimate.ts. */
  readonly maxError: number;
  /** Whether small things may be lost where `maxError` does not need them; not, if absent. */
  readonly isFree?: boolean;
  /** Frames a second while something moves. */
  readonly targetFps: number;
}

export const defaultTargets: QualityTargets = { steps: 'auto', maxError: 1, targetFps: 30 };
