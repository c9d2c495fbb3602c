/** The cost and the error of a picture in which pixels get their own rays only where its curvature is above a limit. */
export interface SamplingOutcome {
  /** Pixels are interpolated if the second difference between every second pixel is at most this, in 1/255; 0 if all get a ray. */
  readonly maxCurvature: number;
  /** Number of rays cast, as a share of those of the whole picture; above 1 if the tests cost more than they save. */
  readonly share: number;
  /** The time they take, as a share of that of all rays, if it was measured: graphics processors differ. If absent, it equals the share. */
  readonly cost?: number;
  /** The error of interpolation, RMS, 1/255. */
  readonly error: number;
}

/** Every pixel has its ray; none is interpolated. */
export const allRays: SamplingOutcome = { maxCurvature: 0, share: 1, error: 0 };
