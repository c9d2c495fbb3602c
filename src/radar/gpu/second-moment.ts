import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import type { Samples, VolumeData } from '../../volume/volume.ts';
import { isPolar } from '../../volume/volume.ts';
import { VolumeViewError } from '../../core/errors.ts';
import { isWebGl2 } from '../../renderer/device/device.ts';
import type { Device, Gl } from '../../renderer/device/device.ts';
import { allocatePlane, fillPlane } from '../../renderer/textures/fill-plane.ts';
import type { Texels, Upload } from '../../renderer/textures/fill-texture.ts';
import { chooseFloatScale, prepareFloats } from '../../renderer/device/prepare-floats.ts';
import type { SecondField } from '../../renderer/ray/ray-module.ts';
import { overlayTwins, secondMomentText } from '../../renderer/ray/modules/overlay.ts';
import { partOf } from '../../renderer/ray/part-of-twins.ts';
import { textureUnit } from '../../renderer/device/texture-unit.ts';
import { layOutRadials, packRows } from '../polar-layout.ts';
import { radarTwins } from './radar-twins.ts';

/** The field of another moment, if it is over a volume of the same gates. */
export const sameGates = partOf(radarTwins, ({ secondMoment }) => secondMoment);

/**
 * Uploads another moment of a radar's gates, as data values, together with the stored values of the first moment, so that one fetch gets
 * both. Where the first moment has a gate, the second has the same gate.
 * @throws {VolumeViewError} `format/too-large` if it does not fit the device
 */
export function* uploadSecondMoment(
  gl: Gl,
  { volume, over }: Pick<ShownOverlay, 'volume' | 'over'>,
  device: Device,
): Upload<SecondField> {
  if (!isPolar(volume) || !isPolar(over))
    throw new TypeError('uploadSecondMoment got a cartesian grid; expected a polar one');
  const { grid, slope } = volume;
  const layout = layOutRadials(grid, device.maxTextureSize);
  const refuse = (): VolumeViewError =>
    new VolumeViewError(
      'format/too-large',
      'This device has no room for a second moment of the radar. Use a file with fewer sweeps, or leave color-moment out.',
    );
  if (!layout) throw refuse();
  const texels = pairTexels(gl);
  const [storedOf, valuesOf] = [storedValues(over), dataValues(volume)];
  const texture = gl.createTexture();
  let isWhole = false;
  try {
    gl.bindTexture(gl.TEXTURE_2D, texture);
    allocatePlane(gl, texels, layout);
    if (gl.getError() === gl.OUT_OF_MEMORY) throw refuse();
    yield* fillPlane(gl, texture, { texels, ...layout }, (first, count) => {
      const [stored, values] = [over, volume].map((one) => packRows(one.samples, one.grid, layout, { first, count }));
      return pairUp(storedOf(stored), valuesOf(values));
    });
    if (gl.getError() === gl.OUT_OF_MEMORY) throw refuse();
    isWhole = true;
  } finally {
    if (!isWhole) gl.deleteTexture(texture);
  }
  const unit = textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uOverlay' });
  const folds = grid.foldFrom !== undefined;
  const foldFrom = folds ? grid.foldFrom * Math.abs(slope) : Infinity;
  return {
    twins: (overlay) => overlayTwins(overlay, sameGates),
    text: secondMomentText(folds),
    stored: { slope: 1, intercept: 0, storedScale: 1 },
    foldFrom,
    inputs: () => ({ uniforms: { uOverlayFoldFrom: Math.min(foldFrom, 3e38) }, units: [unit] }),
    dispose: () => gl.deleteTexture(texture),
  };
}

type Convert = (rows: Samples) => Float32Array;

/** Converts samples as the shader decodes the texels of the volume itself. */
function storedValues(volume: VolumeData): Convert {
  const { samples } = volume;
  if (samples instanceof Float32Array) {
    const scale = chooseFloatScale(volume);
    return (rows) => prepareFloats(rows as Float32Array, scale);
  }
  const full = samples instanceof Uint8Array ? 255 : 1;
  return (rows) => Float32Array.from(rows, (x) => x / full);
}

function dataValues({ samples, slope, intercept }: VolumeData): Convert {
  const isNone = samples instanceof Float32Array ? (x: number) => !Number.isFinite(x) : (x: number) => x === 0;
  return (rows) =>
    prepareFloats(
      Float32Array.from(rows, (x) => (isNone(x) ? NaN : slope * x + intercept)),
      1,
    );
}

/** Texels of two floats. The second float is in green (WebGL 2) or alpha (WebGL 1). */
function pairTexels(gl: Gl): Texels {
  const shared = { type: gl.FLOAT, bytes: 8 };
  return isWebGl2(gl)
    ? { internal: gl.RG32F, format: gl.RG, ...shared }
    : { internal: gl.LUMINANCE_ALPHA, format: gl.LUMINANCE_ALPHA, ...shared };
}

/** Interleave two lists of the same length: one number of each in turn. */
function pairUp(first: Float32Array, second: Float32Array): Float32Array<ArrayBuffer> {
  const pairs = new Float32Array(2 * first.length);
  for (let i = 0; i < first.length; i++) {
    pairs[2 * i] = first[i];
    pairs[2 * i + 1] = second[i];
  }
  return pairs;
}
