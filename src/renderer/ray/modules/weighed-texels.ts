// Volumes on cartesian grids in which some voxels have no data: texels for the device's filter. The first such volume loads this file.
import interpolateVoxels from '../../../../shaders/chunks/field/interpolate.glsl?raw';
import sampleWeighed from '../../../../shaders/chunks/field/sample-weighed.glsl?raw';
import weighedTexels from '../../../../shaders/chunks/field/weighed-texels.glsl?raw';
import type { Samples, VolumeData } from '../../../volume/volume.ts';
import { isWebGl2 } from '../../device/device.ts';
import type { Device, Gl } from '../../device/device.ts';
import { chooseFloatScale } from '../../device/prepare-floats.ts';
import type { FieldModule, RayText } from '../ray-module.ts';
import type { Texels, Upload } from '../../textures/fill-texture.ts';

/** The most that two bytes hold. */
const largestWhole = 65535;

/** Floats keep whole numbers up to this exactly, and their differences too. */
const largestExact = 2 ** 23;

/** Two floats take twice the bytes of a sample; more than this, in bytes, is too much for that. */
const maxPairs = 2 ** 28;

/** Numbers that are looked at in one go. */
const atOnce = 2 ** 18;

/** How shaders read texels with weights: see weighed-texels.glsl. */
export interface Channels {
  /** What each channel adds to the sum of values times their weights, and to the sum of weights. */
  readonly values: readonly number[];
  readonly weights: readonly number[];
  /** Texels store differences from this value. */
  readonly from: number;
}

/** How samples become texels that can be filtered. */
export interface WeighedTexels {
  readonly texels: Texels;
  pack(this: void, samples: Samples): Samples;
  readonly channels: Channels;
  /** A field whose texture has such texels, of one that is the same without weights. */
  read(field: FieldModule): FieldModule;
}

/**
 * Texels that hold a value times its weight, and the weight: 1, or 0 where data are missing. A linear filter then gives the weighted sum,
 * and the sum of weights. Whole numbers in a range of 16 bits take four bytes, as many as a sample; others two floats.
 * @returns null if the device can't filter them, or not so many: shaders then have to fetch each voxel
 */
export function* weighTexels(gl: Gl, volume: VolumeData, device: Device): Upload<WeighedTexels | null> {
  if (isWebGl2(gl) && device.twoByteLinear) {
    const from = yield* findWholeFrom(volume);
    if (from !== null) {
      const channels = { values: [255, 65280, 0, 0], weights: [0, 0, 1, 0], from };
      return {
        texels: { internal: gl.RGBA8, format: gl.RGBA, type: gl.UNSIGNED_BYTE, bytes: 4 },
        pack: (some) => weighWhole(some as Float32Array, from),
        channels,
        read: (field) => readWeighed(field, channels),
      };
    }
  }
  if (!device.floatLinear || 2 * volume.samples.byteLength > maxPairs) return null;
  const scale = chooseFloatScale(volume);
  const channels = { values: [1, 0, 0, 0], weights: isWebGl2(gl) ? [0, 1, 0, 0] : [0, 0, 0, 1], from: 0 };
  const [internal, format] = isWebGl2(gl) ? [gl.RG32F, gl.RG] : [gl.LUMINANCE_ALPHA, gl.LUMINANCE_ALPHA];
  return {
    texels: { internal, format, type: gl.FLOAT, bytes: 8 },
    pack: (some) => weighFloats(some as Float32Array, scale),
    channels,
    read: (field) => readWeighed(field, channels),
  };
}

function readWeighed(field: FieldModule, { values, weights, from }: Channels): FieldModule {
  return {
    ...field,
    ...weighedText(field),
    stage: 'field',
    inputs() {
      const { uniforms, units } = field.inputs();
      return {
        uniforms: { ...uniforms, uValueChannels: values, uWeightChannels: weights, uWeighedFrom: from },
        units,
      };
    },
  };
}

/**
 * The text of such a field, made of that of a field without weights. A mosaic has code to fetch each voxel too, for where
 * FILTER_IN_SHADER is set to 1: see `fetchEach` in columns.ts.
 */
export function weighedText({ defines, chunks, ...text }: RayText): RayText {
  return {
    ...text,
    defines: { ...defines, WEIGHED: 1 },
    chunks: [weighedTexels, ...chunks.slice(0, -1), ...(defines.TEXTURE_3D ? [] : [interpolateVoxels]), sampleWeighed],
  };
}

/** The smallest sample, if all are whole numbers and none is more than two bytes above it; else null. */
function* findWholeFrom(volume: VolumeData): Upload<number | null> {
  const { samples, range, slope, intercept } = volume;
  const ends = range.map((value) => Math.round((value - intercept) / slope));
  const [from, to] = [Math.min(...ends), Math.max(...ends)];
  const fits = to - from <= largestWhole && Math.max(Math.abs(from), Math.abs(to)) <= largestExact;
  if (!fits || chooseFloatScale(volume) !== 1) return null;
  for (let i = 0; i < samples.length; i++) {
    const sample = samples[i];
    if (Number.isFinite(sample) && !(Number.isInteger(sample) && sample >= from && sample <= to)) return null;
    if (i % atOnce === atOnce - 1) yield atOnce;
  }
  return from;
}

/** Low byte, high byte, and weight. */
function weighWhole(samples: Float32Array, from: number): Uint8Array<ArrayBuffer> {
  const texels = new Uint8Array(4 * samples.length);
  for (let i = 0; i < samples.length; i++) {
    if (!Number.isFinite(samples[i])) continue;
    const number = samples[i] - from;
    texels[4 * i] = number & 255;
    texels[4 * i + 1] = number >> 8;
    texels[4 * i + 2] = 255;
  }
  return texels;
}

/** Value and weight. @param scale - the divisor of values */
function weighFloats(samples: Float32Array, scale: number): Float32Array<ArrayBuffer> {
  const texels = new Float32Array(2 * samples.length);
  for (let i = 0; i < samples.length; i++) {
    if (!Number.isFinite(samples[i])) continue;
    texels[2 * i] = samples[i] / scale;
    texels[2 * i + 1] = 1;
  }
  return texels;
}
