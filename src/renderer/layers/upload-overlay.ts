import { toOverlay } from '../../optics/attachments/overlay.ts';
import type { Samples, VolumeData } from '../../volume/volume.ts';
import type { Device, Gl } from '../device/device.ts';
import { isFiltered, uploadBlock } from '../ray/modules/cartesian-field.ts';
import { overlayText, overlayTwins } from '../ray/modules/overlay.ts';
import type { SecondField } from '../ray/ray-module.ts';
import type { Upload } from '../textures/fill-texture.ts';
import { pairTexels, weighFloats } from '../textures/float-pairs.ts';

/** Upload a second field on a cartesian grid, which need not be that of the first. */
export function* uploadOverlay(gl: Gl, volume: VolumeData, device: Device): Upload<SecondField> {
  const { slope, intercept, samples, grid, hasNoData } = volume;
  // If the device filters floats, it also filters floats with holes (missing data).
  const holes = hasNoData && samples instanceof Float32Array && device.floatLinear;
  const filter = holes || isFiltered(volume, device);
  const packing = holes
    ? {
        texels: pairTexels(gl),
        pack: (some: Samples, scale: number) => weighFloats(some as Float32Array, scale),
      }
    : undefined;
  const block = yield* uploadBlock(gl, volume, { device, filterInShader: !filter, packing });
  const {
    uniforms: { uMosaic },
    units: [unit],
  } = block.inputs();
  const uniforms = { uOverlayDimensions: grid.dimensions, ...(uMosaic ? { uOverlayMosaic: uMosaic } : {}) };
  return {
    twins: overlayTwins,
    text: overlayText({ texture3d: device.webgl2, twoBytes: samples instanceof Uint16Array, filter, holes }),
    stored: { slope, intercept, storedScale: block.storedScale },
    foldFrom: Infinity,
    inputs: (over) => ({
      uniforms: { ...uniforms, uToOverlay: byColumn(toOverlay(over.grid, grid)) },
      units: [{ ...unit, samplerName: 'uOverlay' }],
    }),
    dispose: block.dispose,
  };
}

/** Column by column, as WebGL expects matrices. */
function byColumn(matrix: readonly number[] | null): readonly number[] {
  return Array.from({ length: 16 }, (_, at) => matrix?.[4 * (at % 4) + (at >> 2)] ?? 0);
}
