/** What a picture costs and loses if pixels get their own rays only where its curvature is above a limit. */
export interface SamplingOutcome {
  /** The largest second difference between every second pixel that is interpolated over, 1/255; 0 where all get a ray. */
  readonly maxCurvature: number;
  /** Rays cast, as a share of those of the whole picture; above 1 if so little is saved that the tests cost more. */
  readonly share: number;
  /** What they take of the time of all rays, where that was measured: graphics processors differ. As the share where absent. */
  readonly cost?: number;
  /** What interpolation leaves, RMS, 1/255. */
  readonly error: number;
}

/** No pixel is interpolated. */
export const allRays: SamplingOutcome = { maxCurvature: 0, share: 1, error: 0 };
