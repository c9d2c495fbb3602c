import { VolumeViewError } from '../errors.ts';
import { substepTableSize } from '../optics/substep-table.ts';
import type { SubstepTable } from '../optics/substep-table.ts';
import type { PreintegrationTable } from '../optics/preintegration-table.ts';
import type { ShaderFeatures } from './features.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { atlasLayout, packAtlas } from '../volume/mosaic.ts';
import type { AtlasLayout } from '../volume/mosaic.ts';
import type { Samples, Volume } from '../volume/volume.ts';
import { isWebGl2 } from './device.ts';
import type { Device, Gl } from './device.ts';
import { allocatePlane, allocateTexture3d, fillPlane, fillTexture3d, prepareUpload, uploadPlane } from './fill-texture.ts';
import type { Upload } from './fill-texture.ts';
import type { Uniforms } from './uniforms.ts';
import type { TextureUnit } from './texture-unit.ts';

/** A volume on the GPU, and what the shader has to know to read it. */
export interface VolumeTexture {
  readonly unit: TextureUnit;
  readonly features: Pick<ShaderFeatures, 'webgl2' | 'texture3d' | 'polar' | 'radialElevations' | 'twoBytes' | 'noData' | 'filterInShader'>;
  /** Stored sample = what `decodeTexel` returns, times this. */
  readonly storedScale: number;
  /** Present for volumes in a 2D texture. */
  readonly atlas: AtlasLayout | null;
  /** Present for volumes on a polar grid: how the shader samples it, and what else it reads for that. */
  readonly polar?: { readonly sampling: string; readonly unit: TextureUnit; readonly uniforms: Uniforms };
  /** Bytes on the GPU. */
  readonly bytes: number;
}

/** No data are stored as this, as GLSL ES need not know NaN. The shader takes all below -3e38 for no data. */
const noDataSentinel = -3.4028234e38;

/** GPUs take floats below 2^-126 for 0; with this as the largest, 24 bits are left of each. */
const smallestMagnitude = 2 ** -100;

/** Sums and differences of floats up to this stay far from the largest float, and from the sentinel. */
const largestMagnitude = 2 ** 100;

/**
 * Upload samples at their own precision: one channel for 8 bit and float, two 8-bit channels for 16 bit.
 * @throws {VolumeViewError} `format/too-large` where the texture does not fit the device
 */
export function* uploadVolume(gl: Gl, volume: Volume, device: Device): Upload<VolumeTexture> {
  const { samples } = volume;
  const { dimensions } = volume.grid;
  const texture3d = isWebGl2(gl);
  const twoBytes = samples instanceof Uint16Array;
  const float = samples instanceof Float32Array;
  const deviceFilters = twoBytes ? device.twoByteLinear : !float || device.floatLinear;
  const filterInShader = volume.hasNoData || !deviceFilters;
  const atlas = texture3d ? null : atlasLayout(dimensions, device.maxTextureSize);
  if (texture3d ? Math.max(...dimensions) > device.max3dTextureSize : !atlas) throw tooLarge(volume, device);

  const filter = filterInShader ? gl.NEAREST : gl.LINEAR;
  const type = texture3d ? gl.TEXTURE_3D : gl.TEXTURE_2D;
  const floatScale = float ? chooseFloatScale(volume) : 1;
  const changes = volume.hasNoData || floatScale !== 1;
  const prepare = (some: Samples): Samples => (some instanceof Float32Array && changes ? prepareFloats(some, floatScale) : some);
  const texture = gl.createTexture();
  let isWhole = false;
  try {
    gl.bindTexture(type, texture);
    if (isWebGl2(gl)) allocateTexture3d(gl, samples, dimensions);
    else allocatePlane(gl, samples, atlas!);
    if (gl.getError() === gl.OUT_OF_MEMORY) throw tooLarge(volume, device);
    if (isWebGl2(gl)) yield* fillTexture3d(gl, texture, { samples, dimensions }, prepare);
    else yield* fillPlane(gl, texture, { like: samples, ...atlas! }, (first, count) => prepare(packAtlas(samples, dimensions, atlas!, { first, count })));
    if (gl.getError() === gl.OUT_OF_MEMORY) throw tooLarge(volume, device);
    isWhole = true;
  } finally {
    if (!isWhole) gl.deleteTexture(texture);
  }
  return {
    unit: textureUnit(gl, { type, texture, filter, samplerName: 'uVolume' }),
    features: { webgl2: texture3d, texture3d, polar: false, radialElevations: false, twoBytes, noData: volume.hasNoData, filterInShader },
    storedScale: float ? floatScale : twoBytes ? 65535 : 255,
    atlas,
    bytes: (atlas ? atlas.width * atlas.height : samples.length) * samples.BYTES_PER_ELEMENT,
  };
}

/** The transfer function's table; the same texture is filled again when it changes. */
export function uploadTable(gl: Gl, table: PreintegrationTable, previous: WebGLTexture | null, device: Device): TextureUnit {
  const texture = previous ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  const format = isWebGl2(gl) ? gl.RGBA32F : gl.RGBA;
  gl.texImage2D(gl.TEXTURE_2D, 0, format, table.columns, table.rows, 0, gl.RGBA, gl.FLOAT, table.texels);
  const filter = tableInShader(device) ? gl.NEAREST : gl.LINEAR;
  return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter, samplerName: 'uTransferFunction' });
}

/** What tells into how many parts steps are cut; the same texture is filled again when it changes. */
export function uploadSubstepTable(gl: Gl, { texels }: SubstepTable, previous: WebGLTexture | null): TextureUnit {
  const texture = previous ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  uploadPlane(gl, texels, { width: substepTableSize.columns, height: substepTableSize.rows });
  return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uSubstepTable' });
}

/** Cells of a volume and how empty they are, and where they lie in their texture. */
export interface EmptySpaceTexture {
  readonly unit: TextureUnit;
  readonly cells: Vector3;
  readonly atlas: AtlasLayout;
}

/** @param rings - one byte a cell, see optics/empty-space-distance.ts */
export function uploadEmptySpace(
  gl: Gl,
  distances: Uint8Array<ArrayBuffer>,
  cells: Vector3,
  { previous, device }: { previous: WebGLTexture | null; device: Device },
): EmptySpaceTexture {
  const atlas = atlasLayout(cells, device.maxTextureSize)!;
  const texture = previous ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  uploadPlane(gl, packAtlas(distances, cells, atlas), atlas);
  return { unit: textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uEmptySpaceDistance' }), cells, atlas };
}

/** Floats are filtered with an extension only; half floats would be, but hold 11 bits. */
export function tableInShader(device: Device): boolean {
  return !device.floatLinear;
}

/** How x3dom wants to be told of a texture. */
export function textureUnit(
  gl: Gl,
  { type, texture, filter, samplerName }: { type: number; texture: WebGLTexture; filter: number; samplerName: string },
): TextureUnit {
  const wrap = gl.CLAMP_TO_EDGE;
  if (isWebGl2(gl) && type === gl.TEXTURE_3D) {
    gl.bindTexture(type, texture);
    gl.texParameteri(type, gl.TEXTURE_WRAP_R, wrap);
  }
  return { type, texture, samplerName, wrapS: wrap, wrapT: wrap, minFilter: filter, magFilter: filter, anisotropicDegree: 1 };
}

/** What floats are divided by: a power of two that brings extreme ones where a GPU computes well; 1 for all others. */
export function chooseFloatScale({ range, slope, intercept }: Volume): number {
  const largest = Math.max(...range.map((value) => Math.abs((value - intercept) / slope)));
  if (!(largest > 0) || largest === Infinity) return 1;
  const power = 2 ** Math.floor(Math.log2(largest));
  if (largest < smallestMagnitude) return power;
  return largest > largestMagnitude ? power / largestMagnitude : 1;
}

export function prepareFloats(samples: Float32Array, scale: number): Float32Array<ArrayBuffer> {
  return Float32Array.from(samples, (value) => (Number.isFinite(value) ? value / scale : noDataSentinel));
}

function tooLarge(volume: Volume, device: Device): VolumeViewError {
  const limit = device.webgl2
    ? `${device.max3dTextureSize} voxels along each axis`
    : `one image of ${device.maxTextureSize} x ${device.maxTextureSize} pixels`;
  return new VolumeViewError(
    'format/too-large',
    `The volume has ${volume.grid.dimensions.join(' x ')} voxels; this device holds ${limit} and what its memory allows. Use a smaller version of the file.`,
  );
}
