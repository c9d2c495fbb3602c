import cutOut from '../../../shaders/chunks/cut-out.glsl?raw';
import slicesChunk from '../../../shaders/chunks/slices.glsl?raw';
import { brighten } from '../../optics/brighten.ts';
import type { Gl } from '../../renderer/device.ts';
import { Kept } from '../../renderer/kept.ts';
import type { RayText, SliceModule } from '../../renderer/ray/ray-module.ts';
import { isPolar } from '../../volume/volume.ts';
import { minSliceOpacity } from '../../optics/plane-slices.ts';
import { coneSearch, maxSlices } from '../slices.ts';
import type { Slice } from '../slices.ts';
import { sliceUniforms, uploadStops } from './slice-textures.ts';
import type { StopsTexture } from './slice-textures.ts';

export { sliceInterval as twin } from '../slices.ts';

export const slicesText: RayText = {
  name: 'slices',
  stage: 'interval',
  defines: {
    MAX_SLICES: maxSlices,
    CONE_INTERVALS: coneSearch.intervals,
    CONE_HALVINGS: coneSearch.halvings,
    MIN_SLICE_OPACITY: minSliceOpacity.toExponential(1),
  },
  chunks: [cutOut, slicesChunk],
  samplers: ['uStops'],
};

/** Slices through a radar volume end rays, and stand behind what is before them. At most `maxSlices`. */
export function createSlices(gl: Gl): SliceModule<Slice> {
  const stops = new Kept<StopsTexture>();
  return {
    ...slicesText,
    stage: 'interval',
    slices: [],
    sparesRays: false,
    order: Infinity,
    inputs({ volume, optics: { transferFunction, lightFactor }, domain }) {
      const { unit, uniforms } = stops.get([transferFunction, lightFactor], (last) =>
        uploadStops(gl, brighten(transferFunction, lightFactor), domain, last?.unit.texture ?? null));
      return { uniforms: { ...uniforms, ...(isPolar(volume) ? sliceUniforms(this.slices, volume.grid.sweeps) : {}) }, units: [unit] };
    },
    dispose: () => gl.deleteTexture(stops.last?.unit.texture ?? null),
  };
}
