import decode from '../../../../shaders/chunks/field/decode.glsl?raw';
import sampleVolume from '../../../../shaders/chunks/field/sample-volume.glsl?raw';
import volume3d from '../../../../shaders/chunks/field/volume-3d.glsl?raw';
import { VolumeViewError } from '../../../core/errors.ts';
import { atlasLayout, packAtlas } from '../../../volume/atlas.ts';
import type { AtlasLayout } from '../../../volume/atlas.ts';
import type { Samples, VolumeData } from '../../../volume/volume.ts';
import { isWebGl2 } from '../../device/device.ts';
import type { Device, Gl } from '../../device/device.ts';
import { allocateTexture3d, fillTexture3d, slowBytes, texelsOf } from '../../textures/fill-texture.ts';
import type { Texels, Upload } from '../../textures/fill-texture.ts';
import type { Uniforms } from '../../device/inputs.ts';
import { textureUnit } from '../../device/texture-unit.ts';
import { loadPart } from '../../../core/load-part.ts';
import type { FieldModule, FieldProvider, RayText } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';
import type * as Chunks from './cartesian-chunks.ts';

/** How voxels are stored on the GPU and how shaders read them. */
export interface CartesianOptions {
  /** True: in a 3D texture (WebGL 2 only); false: as a mosaic in a 2D texture. */
  readonly texture3d: boolean;
  /** 16-bit samples in two 8-bit channels. */
  readonly twoBytes: boolean;
  /** Samples are floats, and some voxels have no data. */
  readonly noData: boolean;
  /** The shader interpolates tri-linearly with eight fetches, because the device's filter is absent, too coarse, or can't skip missing data. */
  readonly filterInShader: boolean;
}

let chunks: typeof Chunks | null = null;

/** Load the code for mosaics, floats and filtering in the shader; await it before the upload. @throws {VolumeViewError} `format/unsupported` */
export async function loadCartesianChunks(): Promise<void> {
  chunks ??= await loadPart(import('./cartesian-chunks.ts'), 'reads volumes');
}

/** The same, but only if the volume needs this code. */
export async function prepareCartesian(volume: VolumeData, device: Device): Promise<void> {
  if (!device.webgl2 || volume.samples instanceof Float32Array || !isFiltered(volume, device))
    await loadCartesianChunks();
}

/** Whether the device's own filter interpolates a volume. */
export function isFiltered(
  { samples, hasNoData }: Pick<VolumeData, 'samples' | 'hasNoData'>,
  { twoByteLinear, floatLinear }: Device,
): boolean {
  if (samples instanceof Uint16Array) return twoByteLinear === true;
  return !hasNoData && (samples instanceof Uint8Array || floatLinear);
}

/** Await `prepareCartesian` first, unless the volume is a 3D texture that the device filters. */
export function cartesianText({ texture3d, twoBytes, noData, filterInShader }: CartesianOptions): RayText {
  return {
    name: 'cartesian',
    stage: 'field',
    defines: {
      TEXTURE_3D: Number(texture3d),
      TWO_BYTES: Number(twoBytes),
      NO_DATA: Number(noData),
      FILTER_IN_SHADER: Number(filterInShader),
      FOLDS: 0,
    },
    chunks: [
      decode,
      texture3d ? volume3d : chunks!.volumeMosaic,
      ...(filterInShader ? [chunks!.interpolateVoxels] : []),
      sampleVolume,
    ],
    samplers: ['uVolume'],
  };
}

export const cartesianTwin = twinOf(usualTwins, ({ cartesianField }, { volume }) => ({
  field: cartesianField({ ...volume, dimensions: volume.grid.dimensions }),
}));

/** Samples on a cartesian grid. */
interface Block extends Pick<VolumeData, 'samples' | 'hasNoData'> {
  readonly grid: Pick<VolumeData['grid'], 'dimensions'>;
}

/** Uploads volumes on cartesian grids to the GPU. */
export const cartesianProvider: FieldProvider = { upload: uploadCartesian };

function* uploadCartesian(gl: Gl, volume: VolumeData, device: Device): Upload<FieldModule> {
  const { samples, hasNoData: noData } = volume;
  const filterInShader = !isFiltered(volume, device);
  const block = yield* uploadBlock(gl, volume, { device, filterInShader });
  return {
    ...block,
    ...cartesianText({ texture3d: isWebGl2(gl), twoBytes: samples instanceof Uint16Array, noData, filterInShader }),
    stage: 'field',
    sparesRays: true,
    order: 2,
    twin: cartesianTwin,
  };
}

/** The members of a field module that a texture of samples provides: how samples are stored, and how shaders read them. */
export type BlockTexture = Pick<FieldModule, 'storedScale' | 'bytes' | 'inputs' | 'dispose'>;

/** How samples are converted to texels, if they are not stored as they are. */
export interface Packing {
  readonly texels: Texels;
  /** @param floatScale - the divisor of floats */
  pack(samples: Samples, floatScale: number): Samples;
}

/** How a block is uploaded. */
export interface BlockOptions {
  readonly device: Device;
  readonly filterInShader: boolean;
  readonly packing?: Packing;
}

/**
 * Upload samples at their own precision: one channel for 8 bit and float, two 8-bit channels for 16 bit.
 * @throws {VolumeViewError} `format/too-large` if the texture does not fit the device
 */
export function* uploadBlock(
  gl: Gl,
  volume: Block,
  { device, filterInShader, packing }: BlockOptions,
): Upload<BlockTexture> {
  const {
    samples,
    grid: { dimensions },
  } = volume;
  const texture3d = isWebGl2(gl);
  const float = samples instanceof Float32Array;
  const atlas = texture3d ? null : atlasLayout(dimensions, device.maxTextureSize);
  if (texture3d ? Math.max(...dimensions) > device.max3dTextureSize : !atlas) throw tooLarge(volume, device);

  const storedScale = storedScaleOf(volume);
  const floatScale = float ? storedScale : 1;
  const texture = yield* fill(gl, volume, { atlas, floatScale, packing, tooLarge: () => tooLarge(volume, device) });
  const uniforms: Uniforms = atlas ? { uMosaic: [atlas.columns, atlas.rows, atlas.width, atlas.height] } : {};
  const filter = filterInShader ? gl.NEAREST : gl.LINEAR;
  const unit = textureUnit(gl, {
    type: texture3d ? gl.TEXTURE_3D : gl.TEXTURE_2D,
    texture,
    filter,
    samplerName: 'uVolume',
  });
  return {
    storedScale,
    bytes: (atlas ? atlas.width * atlas.height : samples.length) * samples.BYTES_PER_ELEMENT,
    inputs: () => ({ uniforms, units: [unit] }),
    dispose: () => gl.deleteTexture(texture),
  };
}

/** What a value of 1 in a texel stands for. */
export function storedScaleOf(volume: Block): number {
  const { samples } = volume;
  if (samples instanceof Float32Array) return chunks!.chooseFloatScale(volume as VolumeData);
  return samples instanceof Uint16Array ? 1 : 255;
}

interface Filling {
  /** Null for a 3D texture. */
  readonly atlas: AtlasLayout | null;
  /** The divisor of floats. */
  readonly floatScale: number;
  readonly packing: Packing | undefined;
  readonly tooLarge: () => VolumeViewError;
}

/** Make a texture with all of a volume's samples. */
function* fill(gl: Gl, volume: Block, { atlas, floatScale, packing, tooLarge: refuse }: Filling): Upload<WebGLTexture> {
  const {
    samples,
    grid: { dimensions },
  } = volume;
  const changes = volume.hasNoData || floatScale !== 1;
  const prepare = (some: Samples): Samples =>
    packing
      ? packing.pack(some, floatScale)
      : some instanceof Float32Array && changes
        ? chunks!.prepareFloats(some, floatScale)
        : some;
  const texels = packing?.texels ?? texelsOf(gl, samples);
  const texture = gl.createTexture();
  let isWhole = false;
  try {
    gl.bindTexture(isWebGl2(gl) ? gl.TEXTURE_3D : gl.TEXTURE_2D, texture);
    if (isWebGl2(gl)) allocateTexture3d(gl, texels, dimensions);
    else chunks!.allocatePlane(gl, texels, atlas!);
    if (samples.byteLength > slowBytes) yield Infinity;
    if (gl.getError() === gl.OUT_OF_MEMORY) throw refuse();
    if (isWebGl2(gl)) yield* fillTexture3d(gl, texture, { samples, dimensions, texels }, prepare);
    else
      yield* chunks!.fillPlane(gl, texture, { texels, ...atlas! }, (first, count) =>
        prepare(packAtlas(samples, dimensions, atlas!, { first, count })),
      );
    if (gl.getError() === gl.OUT_OF_MEMORY) throw refuse();
    isWhole = true;
  } finally {
    if (!isWhole) gl.deleteTexture(texture);
  }
  return texture;
}

export function tooLarge(volume: Block, device: Device): VolumeViewError {
  const limit = device.webgl2
    ? `${device.max3dTextureSize} voxels along each axis`
    : `one image of ${device.maxTextureSize} x ${device.maxTextureSize} pixels`;
  return new VolumeViewError(
    'format/too-large',
    `the volume has ${volume.grid.dimensions.join(' x ')} voxels; this device holds ${limit}; use a smaller file`,
  );
}
