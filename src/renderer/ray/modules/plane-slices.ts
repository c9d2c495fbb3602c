import cutOut from '../../../../shaders/chunks/walk/cut-out.glsl?raw';
import cubic from '../../../../shaders/chunks/field/cubic.glsl?raw';
import planes from '../../../../shaders/chunks/attachments/plane-slices.glsl?raw';
import slack from '../../../../shaders/chunks/walk/slack.glsl?raw';
import voxelPlanes from '../../../../shaders/chunks/walk/voxel-planes.glsl?raw';
import type { ProjectionKind } from '../../../optics/rays/ray-style.ts';
import { brighten } from '../../../optics/transfer/brighten.ts';
import { minSliceOpacity } from '../../../optics/attachments/plane-slices.ts';
import type { PlaneSlice } from '../../../optics/attachments/plane-slices.ts';
import { outlinesOf } from '../../../optics/attachments/plane-outlines.ts';
import type { Uniforms } from '../../device/inputs.ts';
import { outlinesText, outlineUniforms } from '../outline-uniforms.ts';
import type { RayText, RayTwin, SliceModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** The maximum pieces of a line through a slab: GLSL ES 1.00 needs a constant. A line through 2,048 voxels along each axis has so many. */
const maxPieces = 6144;

/** @param slabs - whether any plane is thick (a slab) */
export function planesText(slabs: boolean): RayText {
  return {
    name: 'planes',
    stage: 'interval',
    defines: { MIN_SLICE_OPACITY: minSliceOpacity.toExponential(1), SLABS: slabs ? maxPieces : 0 },
    chunks: [slack, cutOut, ...(slabs ? [cubic, voxelPlanes] : []), planes],
    samplers: [],
    between: outlinesText,
  };
}

/** The kinds in the order of their numbers in the chunk. */
const kinds: readonly ProjectionKind[] = ['average', 'max', 'min'];

/** The slope of a window without a width, which is a threshold: steeper than that of any other window. */
const steepest = 1e30;

const twin = (planes: readonly PlaneSlice[]): RayTwin =>
  twinOf(usualTwins, ({ planeInterval }, { optics }, { field }) => ({
    intervals: [planeInterval(planes, field, brighten(optics.transferFunction, optics.lightFactor))],
  }));

/** Planes through a volume end rays; the volume in front of them stays visible: grey by a window, or in the volume's colours. Four at most. */
export function createPlanes(): SliceModule<PlaneSlice> {
  const [thin, thick] = [false, true].map(planesText);
  return {
    ...thin,
    get defines() {
      return (this.slices.some(({ slab }) => slab) ? thick : thin).defines;
    },
    get chunks() {
      return (this.slices.some(({ slab }) => slab) ? thick : thin).chunks;
    },
    stage: 'interval',
    slices: [],
    sparesRays: true,
    order: Infinity,
    get twin() {
      return twin(this.slices);
    },
    inputs({ domain, rays }) {
      return {
        uniforms: { ...planeUniforms(this.slices, domain), ...outlineUniforms(outlinesOf(this.slices, rays)) },
        units: [],
      };
    },
  };
}

/** @param domain - the data values at 0 and 1 of the transfer function's domain */
function planeUniforms(planes: readonly PlaneSlice[], [low, high]: readonly [number, number]): Uniforms {
  const fill = (numbers: readonly number[]): number[] => Array.from({ length: 16 }, (_, i) => numbers[i] ?? 0);
  return {
    uPlanes: fill(planes.flatMap(({ normal, offset }) => [...normal, offset])),
    uPlanePaints: fill(
      planes.flatMap(({ window, slab }) => {
        const kind = kinds.indexOf(slab?.kind ?? 'average');
        if (!window) return [2, 0, 0, kind];
        const [black, white] = window.map((value) => (value - low) / (high - low));
        return [1, black, white > black ? 1 / (white - black) : steepest, kind];
      }),
    ),
    uSlabs: fill(planes.flatMap(({ slab }) => (slab ? [...slab.way, 1] : [0, 0, 0, 0]))),
  };
}
