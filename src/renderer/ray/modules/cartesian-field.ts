import decode from '../../../../shaders/chunks/field/decode.glsl?raw';
import sampleVolume from '../../../../shaders/chunks/field/sample-volume.glsl?raw';
import volume3d from '../../../../shaders/chunks/field/volume-3d.glsl?raw';
import { VolumeViewError } from '../../../core/errors.ts';
import { atlasLayout, packAtlas } from '../../../volume/atlas.ts';
import type { AtlasLayout } from '../../../volume/atlas.ts';
import type { Vector3 } from '../../../volume/matrix.ts';
import type { Samples, VolumeData } from '../../../volume/volume.ts';
import { isWebGl2 } from '../../device/device.ts';
import type { Device, Gl } from '../../device/device.ts';
import { allocateTexture3d, fillTexture3d, slowBytes, texelsOf } from '../../textures/fill-texture.ts';
import type { Texels, Upload } from '../../textures/fill-texture.ts';
import type { Uniforms } from '../../device/inputs.ts';
import { askTwoByteFilter } from '../../probes/probe-device.ts';
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
export async function loadCartesianChunks(): Promise<typeof Chunks> {
  return (chunks ??= await loadPart(import('./cartesian-chunks.ts'), 'reads volumes'));
}

/** Load the same, and ask the device for its filter, but only if the volume needs these. */
export async function prepareCartesian(volume: VolumeData, device: Device): Promise<void> {
  if (volume.samples instanceof Uint16Array || volume.hasNoData) await askTwoByteFilter(device);
  if (!device.webgl2 || volume.samples instanceof Float32Array || !isFiltered(volume, device))
    await loadCartesianChunks();
}

/** Whether the device's own filter interpolates a volume. */
export function isFiltered(
  { samples, hasNoData }: Pick<VolumeData, 'samples' | 'hasNoData'>,
  { twoByteLinear, floatLinear }: Device,
): boolean {
  if (samples instanceof Uint16Array) return !!twoByteLinear;
  return !hasNoData && (floatLinear || samples instanceof Uint8Array);
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
  const weighed = noData ? yield* chunks!.weighTexels(gl, volume, device) : null;
  const filterInShader = !weighed && !isFiltered(volume, device);
  const block = yield* uploadBlock(gl, volume, { device, filterInShader, packing: weighed });
  const field: FieldModule = {
    ...block,
    ...cartesianText({ texture3d: isWebGl2(gl), twoBytes: samples instanceof Uint16Array, noData, filterInShader }),
    stage: 'field',
    sparesRays: true,
    order: 2,
    twin: cartesianTwin,
  };
  return weighed?.read(field) ?? field;
}

/** The members of a field module that a texture of samples provides: how samples are stored, and how shaders read them. */
export type BlockTexture = Pick<FieldModule, 'storedScale' | 'bytes' | 'inputs' | 'dispose'>;

/** Converts samples before their upload. */
type Pack = (samples: Samples) => Samples;

/** How samples are converted to texels, if they are not stored as they are. */
export interface Packing {
  readonly texels: Texels;
  readonly pack: Pack;
}

/** How a block is uploaded. */
export interface BlockOptions {
  readonly device: Device;
  readonly filterInShader: boolean;
  readonly packing?: Packing | null;
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
  const atlas = texture3d ? null : atlasLayout(dimensions, device.maxTextureSize);
  const refuse = (): VolumeViewError => tooLarge(volume, device);
  if (texture3d ? Math.max(...dimensions) > device.max3dTextureSize : !atlas) throw refuse();

  const storedScale = storedScaleOf(volume);
  const texels = packing?.texels ?? texelsOf(gl, samples);
  const pack =
    packing?.pack ??
    (samples instanceof Float32Array ? chunks!.packFloats(volume, storedScale) : (some: Samples): Samples => some);
  const texture = yield* fill(gl, { samples, dimensions, texels, atlas, pack, refuse });
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
    bytes: (atlas ? atlas.width * atlas.height : samples.length) * texels.bytes,
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
  readonly samples: Samples;
  readonly dimensions: Vector3;
  readonly texels: Texels;
  /** Null for a 3D texture. */
  readonly atlas: AtlasLayout | null;
  readonly pack: Pack;
  /** The error if it is too large. */
  readonly refuse: () => VolumeViewError;
}

/** Make a texture with all of a volume's samples. */
function* fill(gl: Gl, { samples, dimensions, texels, atlas, pack, refuse }: Filling): Upload<WebGLTexture> {
  const texture = gl.createTexture();
  let isWhole = false;
  try {
    gl.bindTexture(isWebGl2(gl) ? gl.TEXTURE_3D : gl.TEXTURE_2D, texture);
    if (isWebGl2(gl)) allocateTexture3d(gl, texels, dimensions);
    else chunks!.allocatePlane(gl, texels, atlas!);
    if (samples.byteLength > slowBytes) yield Infinity;
    if (gl.getError() === gl.OUT_OF_MEMORY) throw refuse();
    if (isWebGl2(gl)) yield* fillTexture3d(gl, texture, { samples, dimensions, texels }, pack);
    else
      yield* chunks!.fillPlane(gl, texture, { texels, ...atlas! }, (first, count) =>
        pack(packAtlas(samples, dimensions, atlas!, { first, count })),
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
