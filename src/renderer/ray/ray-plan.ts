import { allSubsteps } from '../../optics/cells/substeps.ts';
import type { Substeps } from '../../optics/cells/substeps.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import type { RayCut } from './ray-module.ts';

/** How the rays of a picture are cast, and what cuts them. It is never changed: another picture has another plan. */
export interface RayPlan {
  /** Changes the inputs of the ray's program, for pictures that only measure something. */
  readonly change?: (inputs: ProgramInputs) => ProgramInputs;
  /** World length of a step. */
  readonly stepLength: number;
  /** How steps are cut. */
  readonly substeps: Substeps;
  /** Maximum curvature at which pixels are interpolated and get no rays of their own, 1/255; 0 where all pixels get rays. */
  readonly maxCurvature: number;
  /** At the edges of surfaces, pixels with more curvature than this get several rays, 1/255; Infinity where all get one. */
  readonly edgeCurvature: number;
  /** The only part of the volume that is shown, see volume/region.ts; null for the whole volume. */
  readonly region: GridFrame | null;
  /** Surfaces in the volume that end rays, of a kind that its grid knows; empty for grids that have no slices. */
  readonly slices: readonly unknown[];
  /** Other cuts of rays: half-spaces and boxes, for example. */
  readonly cuts: readonly RayCut[];
}

/** The plan of a layer that got no other yet. */
export const plainRays: RayPlan = {
  stepLength: 1,
  substeps: allSubsteps,
  maxCurvature: 0,
  edgeCurvature: Infinity,
  region: null,
  slices: [],
  cuts: [],
};
