import type { PictureError } from '../../quality/error-estimate.ts';

/** What one drawn frame was. */
export interface RenderStats {
  /** From the call to the GPU having finished, ms. */
  readonly frameMs: number;
  /** Steps along the longest ray, each of one sample or, where something may be seen, several. */
  readonly steps: number;
  /** The most substeps that a step was cut into. */
  readonly substeps: number;
  /** World length between samples. */
  readonly stepLength: number;
  /** Rays that were cast, as a share of the pixels, about; what lies between them is interpolated where it is smooth. */
  readonly rays: number;
  /** Largest curvature at which pixels were interpolated instead of getting rays, 1/255, see docs/maths.md; 0 where every pixel got a ray. */
  readonly maxCurvature: number;
  /** Steps of all rays of the picture, those through empty space and behind opaque things too; estimated from 1,024 rays. */
  readonly samples: number;
  /** Device pixels. */
  readonly width: number;
  readonly height: number;
  /** Whether this is the picture at its full number of steps, with nothing on its way to change it. */
  readonly converged: boolean;
  /**
   * How far the pixels that the volume covers are from what they would be with endlessly many steps, in 1/255: estimated
   * on the GPU from this very view. null while moving, and where the device can't measure it.
   */
  readonly error: PictureError | null;
  /**
   * Whether that error keeps `max-error`. Where it does not, no more steps could help: it is below what 8 bits show, or
   * beyond 4,096 steps; or `steps` are given; or no
   * pixel of the volume shows anything, see `picture-blank`. null where `error` is.
   */
  readonly keepsMaxError: boolean | null;
}
