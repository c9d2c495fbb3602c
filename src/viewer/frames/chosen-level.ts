import type { PictureError } from '../../quality/error-estimate.ts';
import type { FrameQuality } from '../../quality/frame-quality.ts';
import type { Level } from '../../quality/levels.ts';
import type { QualityTargets } from '../model/quality-targets.ts';

/** The quality required of a picture at rest. */
export type AskedQuality = Pick<QualityTargets, 'steps' | 'maxError' | 'isFree'>;

/** What was measured of a view. */
export interface QualityFinding {
  readonly error: PictureError | null;
  /** Whether that error is within the target. */
  readonly isKept: boolean;
}

/** The steps of a picture at rest. */
export interface ChosenSteps extends Level {
  /** How the picture differs from the usual one at this level, if it does. */
  readonly free?: Partial<FrameQuality>;
}

/** The level that was chosen, and what was measured of it. */
export interface ChosenLevel extends QualityFinding {
  readonly level: ChosenSteps;
}
