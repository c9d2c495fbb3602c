import type { PictureError } from '../../quality/error-estimate.ts';

/** Facts about one drawn frame. */
export interface RenderStats {
  /** From the call until the GPU has finished, ms. */
  readonly frameMs: number;
  /** Steps along the longest ray. Each takes one sample, or several where something may be visible. */
  readonly steps: number;
  /** The largest number of substeps in one step. */
  readonly substeps: number;
  /** World length between samples. */
  readonly stepLength: number;
  /** Share of the pixels that got a ray, approximately; the pixels between rays are interpolated where the picture is smooth. */
  readonly rays: number;
  /** Largest curvature at which pixels were interpolated instead of getting rays, 1/255, see docs/develop/maths.md; 0 where every pixel got a ray. */
  readonly maxCurvature: number;
  /** Steps of all rays of the picture, including steps through empty space and behind opaque things; estimated from 1,024 rays. */
  readonly samples: number;
  /** Device pixels. */
  readonly width: number;
  readonly height: number;
  /** Whether this picture has its full number of steps, and no change of it is pending. */
  readonly converged: boolean;
  /**
   * How far the pixels that the volume covers differ from a picture with infinitely many steps, in 1/255: estimated on the GPU
   * from this same view. What a video lost is in it, where its manifest says that, and what bricks hide that are not there. null while moving, and where the device can't measure it.
   */
  readonly error: PictureError | null;
  /**
   * Whether that error is within `max-error`. Where it is not, more steps would not help: `max-error` is smaller than 8 bits show,
   * or would need more than 4,096 steps; or the author gives `steps`; or a video lost more than that; or no pixel of the volume shows anything, see
   * `picture-blank`. null where `error` is null.
   */
  readonly keepsMaxError: boolean | null;
  /** Of a pyramid in bricks: those that are on the GPU, and all bytes there. */
  readonly bricks?: { readonly count: number; readonly bytes: number };
}
