import cutOut from '../../../shaders/chunks/walk/cut-out.glsl?raw';
import slicesChunk from '../../../shaders/chunks/radar/slices.glsl?raw';
import slack from '../../../shaders/chunks/walk/slack.glsl?raw';
import { brighten } from '../../optics/transfer/brighten.ts';
import type { Gl } from '../../renderer/device/device.ts';
import { outlinesText, outlineUniforms } from '../../renderer/ray/outline-uniforms.ts';
import { Kept } from '../../renderer/device/kept.ts';
import type { RayText, RayTwin, SliceModule } from '../../renderer/ray/ray-module.ts';
import { twinOf } from '../../renderer/ray/ray-twin.ts';
import { isPolar } from '../../volume/volume.ts';
import { outlinesOf } from '../../optics/attachments/plane-outlines.ts';
import { minSliceOpacity } from '../../optics/attachments/plane-slices.ts';
import { coneSearch, isFlat, maxSlices, planeOfSlice } from '../slices.ts';
import type { Slice } from '../slices.ts';
import { sliceUniforms, uploadStops } from './slice-textures.ts';
import type { StopsTexture } from './slice-textures.ts';
import { radarTwins } from './radar-twins.ts';

export const slicesText: RayText = {
  name: 'slices',
  stage: 'interval',
  defines: {
    MAX_SLICES: maxSlices,
    CONE_INTERVALS: coneSearch.intervals,
    CONE_HALVINGS: coneSearch.halvings,
    MIN_SLICE_OPACITY: minSliceOpacity.toExponential(1),
  },
  chunks: [slack, cutOut, slicesChunk],
  samplers: ['uStops'],
  between: outlinesText,
};

const twin = (slices: readonly Slice[]): RayTwin =>
  twinOf(radarTwins, ({ sliceInterval, sliceMeeter }, { volume, optics }) =>
    isPolar(volume) ? { intervals: [sliceInterval(sliceMeeter(volume, slices, optics))] } : {},
  );

/** Slices through a radar volume end rays, and their colour stands behind everything in front of them. At most `maxSlices`. */
export function createSlices(gl: Gl): SliceModule<Slice> {
  const stops = new Kept<StopsTexture>();
  return {
    ...slicesText,
    stage: 'interval',
    slices: [],
    // Outlines are not known for cones, so their pictures need all rays.
    get sparesRays() {
      return this.slices.every(isFlat);
    },
    order: Infinity,
    get twin() {
      return twin(this.slices);
    },
    inputs({ volume, rays, optics: { transferFunction, lightFactor }, domain }) {
      const { unit, uniforms } = stops.get([transferFunction, lightFactor], (last) =>
        uploadStops(gl, brighten(transferFunction, lightFactor), domain, last?.unit.texture ?? null),
      );
      if (!isPolar(volume)) return { uniforms, units: [unit] };
      const { box, sweeps } = volume.grid;
      const outlines = outlinesOf(
        this.slices.filter(isFlat).map((slice) => planeOfSlice(slice, box)),
        rays,
      );
      return {
        uniforms: { ...uniforms, ...sliceUniforms(this.slices, sweeps), ...outlineUniforms(outlines) },
        units: [unit],
      };
    },
    dispose: () => gl.deleteTexture(stops.last?.unit.texture ?? null),
  };
}
