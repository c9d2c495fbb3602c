import type { Volume } from '../../volume/volume.ts';
import { isPolar } from '../../volume/volume.ts';
import { VolumeViewError } from '../../errors.ts';
import type { Device, Gl } from '../../renderer/device.ts';
import { allocatePlane, fillPlane } from '../../renderer/fill-plane.ts';
import type { Upload } from '../../renderer/fill-texture.ts';
import { prepareFloats } from '../../renderer/prepare-floats.ts';
import type { SecondField } from '../../renderer/ray/ray-module.ts';
import { secondMomentText } from '../../renderer/ray/modules/overlay.ts';
import { textureUnit } from '../../renderer/texture-unit.ts';
import { layOutRadials, packRows } from '../polar-layout.ts';

/** No velocities fold farther apart. */
const noFold = 3e38;

/**
 * Upload another moment of a radar's gates, as data values: where the first one has a gate, it has the same.
 * @throws {VolumeViewError} `format/too-large` where it does not fit the device
 */
export function* uploadSecondMoment(gl: Gl, volume: Volume, device: Device): Upload<SecondField> {
  if (!isPolar(volume)) throw new TypeError('uploadSecondMoment got a cartesian grid; expected a polar one');
  const { grid, samples, slope, intercept } = volume;
  const layout = layOutRadials(grid, device.maxTextureSize);
  const refuse = (): VolumeViewError => new VolumeViewError('format/too-large', 'This device has no room for a second moment of the radar. Use a file with fewer sweeps, or leave color-moment out.');
  if (!layout) throw refuse();
  const isNone = samples instanceof Float32Array ? (x: number) => !Number.isFinite(x) : (x: number) => x === 0;
  const texture = gl.createTexture();
  let isWhole = false;
  try {
    gl.bindTexture(gl.TEXTURE_2D, texture);
    allocatePlane(gl, new Float32Array(0), layout);
    if (gl.getError() === gl.OUT_OF_MEMORY) throw refuse();
    yield* fillPlane(gl, texture, { like: new Float32Array(0), ...layout }, (first, count) =>
      prepareFloats(Float32Array.from(packRows(samples, grid, layout, { first, count }), (x) => (isNone(x) ? NaN : slope * x + intercept)), 1));
    if (gl.getError() === gl.OUT_OF_MEMORY) throw refuse();
    isWhole = true;
  } finally {
    if (!isWhole) gl.deleteTexture(texture);
  }
  const unit = textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uOverlay' });
  const fold = grid.foldFrom === undefined ? noFold : grid.foldFrom * Math.abs(slope);
  return {
    text: secondMomentText,
    stored: { slope: 1, intercept: 0, storedScale: 1 },
    foldFrom: fold,
    inputs: () => ({ uniforms: { uOverlayFoldFrom: fold }, units: [unit] }),
    dispose: () => gl.deleteTexture(texture),
  };
}
