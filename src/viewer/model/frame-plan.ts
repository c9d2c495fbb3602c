import type { Camera } from '../../optics/rays/camera.ts';
import type { FrameQuality } from '../../quality/frame-quality.ts';
import { stepLengthOf } from '../../quality/steps.ts';
import type { GroundMap } from '../../radar/ground-map.ts';
import type { Slice } from '../../radar/slices.ts';
import type { RayCut } from '../../renderer/ray/ray-module.ts';
import type { RayPlan } from '../../renderer/ray/ray-plan.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { PictureSize } from './picture-size.ts';

/** Lines in world coordinates, each from point to point. */
export type Lines = readonly (readonly Vector3[])[];

/** Lines around the volume, and the map below them. */
export interface Ground {
  readonly lines: Lines;
  readonly map?: GroundMap;
}

/** Everything that one picture of a scene's volume is drawn with. It is never changed: another picture has another plan. */
export interface FramePlan extends RayPlan {
  /** Device pixels. */
  readonly picture: PictureSize;
  /** null leaves the author's viewpoint where the author put it. */
  readonly camera: Camera | null;
  readonly slices: readonly Slice[];
  /** null for none. */
  readonly ground: Ground | null;
}

/** What a plan is made from. */
export interface PlannedFrame {
  readonly shown: {
    /** The visible part: steps are counted along its diagonal. */
    readonly grid: GridFrame;
    readonly cuts: {
      readonly region: GridFrame | null;
      readonly slices: readonly Slice[];
      readonly cuts: readonly RayCut[];
      readonly rings: Ground | null;
    };
  };
  readonly quality: FrameQuality;
  /** Device pixels of the picture at a scale of 1. */
  readonly size: PictureSize;
  readonly camera: Camera | null;
}

/** The plan of a frame. The same shown volume, quality, size and camera give the same plan, whatever was drawn before. */
export function planFrame({ shown: { grid, cuts }, quality, size, camera }: PlannedFrame): FramePlan {
  const { scale, steps, substeps, sampling, edgeCurvature = Infinity } = quality;
  const pixels = (full: number): number => Math.max(1, Math.round(full * scale));
  return {
    picture: { width: pixels(size.width), height: pixels(size.height) },
    camera,
    stepLength: stepLengthOf(grid, steps),
    substeps,
    maxCurvature: sampling.maxCurvature,
    edgeCurvature,
    region: cuts.region,
    slices: cuts.slices,
    cuts: cuts.cuts,
    ground: cuts.rings,
  };
}
