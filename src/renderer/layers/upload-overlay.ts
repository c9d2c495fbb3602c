import { toOverlay } from '../../optics/attachments/overlay.ts';
import type { VolumeData } from '../../volume/volume.ts';
import type { Device, Gl } from '../device/device.ts';
import { isFiltered, uploadBlock } from '../ray/modules/cartesian-field.ts';
import { overlayText, overlayTwins } from '../ray/modules/overlay.ts';
import type { SecondField } from '../ray/ray-module.ts';
import type { WeighedTexels } from '../ray/modules/weighed-texels.ts';
import type { Upload } from '../textures/fill-texture.ts';

/** What an upload needs besides the volume. */
interface OverlayUpload {
  readonly device: Device;
  /** Makes texels for the device's filter where some voxels have no data; undefined where all have. */
  readonly weighTexels: ((gl: Gl, volume: VolumeData, device: Device) => Upload<WeighedTexels | null>) | undefined;
}

/** Upload a second field on a cartesian grid, which need not be that of the first. */
export function* uploadOverlay(
  gl: Gl,
  volume: VolumeData,
  { device, weighTexels }: OverlayUpload,
): Upload<SecondField> {
  const { slope, intercept, samples, grid } = volume;
  const weighing = weighTexels ? yield* weighTexels(gl, volume, device) : null;
  const channels = weighing?.channels;
  const holes = weighing !== null;
  const filter = holes || isFiltered(volume, device);
  const block = yield* uploadBlock(gl, volume, { device, filterInShader: !filter, packing: weighing });
  const {
    uniforms: { uMosaic },
    units: [unit],
  } = block.inputs();
  const uniforms = {
    uOverlayDimensions: grid.dimensions,
    ...(uMosaic && { uOverlayMosaic: uMosaic }),
    ...(channels && {
      uOverlayValues: channels.values,
      uOverlayWeights: channels.weights,
      uOverlayFrom: channels.from,
    }),
  };
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
