// A volume with bricks of finer levels over it. The first such volume loads this file.
import bricks3d from '../../../../shaders/chunks/field/bricks-3d.glsl?raw';
import interpolate from '../../../../shaders/chunks/field/interpolate.glsl?raw';
import sampleBricks from '../../../../shaders/chunks/field/sample-bricks.glsl?raw';
import { halvingsOf } from '../../../bricks/brick-layout.ts';
import type { ResidentBricks } from '../../../bricks/resident-bricks.ts';
import type { VolumeData } from '../../../volume/volume.ts';
import type { Device, Gl } from '../../device/device.ts';
import { BrickTextures } from '../../textures/brick-textures.ts';
import { texelsOf } from '../../textures/fill-texture.ts';
import type { Upload } from '../../textures/fill-texture.ts';
import type { FieldModule, RayText } from '../ray-module.ts';
import { cartesianText, cartesianTwin, isFiltered, storedScaleOf, tooLarge } from './cartesian-field.ts';
import type { CartesianOptions } from './cartesian-field.ts';
import volume3d from '../../../../shaders/chunks/field/volume-3d.glsl?raw';

/** A float that interpolate.glsl reads as no data. */
const lacksData = -3.4e38;

export interface BricksOptions extends Omit<CartesianOptions, 'texture3d'> {
  /** Whether the page table has entries for groups of cells. */
  readonly grouped: boolean;
  /** Whether voxels of all levels are twice, four times ... as long as the finest ones. */
  readonly halved: boolean;
}

/** The text of a field with bricks; only in WebGL 2. Floats that the device filters are fetched in bricks in which voxels may lack data. */
export function bricksText({ grouped, halved, ...options }: BricksOptions): RayText {
  const whole = cartesianText({ ...options, texture3d: true });
  const chunks = whole.chunks.map((chunk) => (chunk === volume3d ? bricks3d : chunk));
  const isMixed = options.noData && !options.filterInShader;
  return {
    ...whole,
    name: 'bricks',
    defines: { ...whole.defines, BRICKS: 1, LONG: 1, GROUPED_PAGES: Number(grouped), HALVED_LEVELS: Number(halved) },
    chunks: isMixed ? [...chunks.slice(0, -1), interpolate, sampleBricks] : chunks,
    samplers: [...whole.samplers, 'uBrickPages'],
  };
}

/**
 * Uploads volumes that have `ResidentBricks` as their finer voxels; only in WebGL 2.
 * @throws {VolumeViewError} `format/too-large` if the volume itself does not fit the device
 */
export function* uploadBricks(gl: Gl, volume: VolumeData, device: Device): Upload<FieldModule> {
  const { samples, hasNoData: noData } = volume;
  // Of bricks, only those in which voxels lack data are interpolated in the shader.
  const filterInShader = !isFiltered({ samples, hasNoData: false }, device);
  const storedScale = storedScaleOf(volume);
  const bricks = volume.finer as ResidentBricks;
  const { layout } = bricks;
  const textures = new BrickTextures(gl as WebGL2RenderingContext, volume, bricks, {
    texels: texelsOf(gl, samples),
    filter: filterInShader ? gl.NEAREST : gl.LINEAR,
    pack: (some) =>
      some instanceof Float32Array
        ? some.map((value) => (Number.isFinite(value) ? value / storedScale : lacksData))
        : some,
  });
  let isWhole = false;
  try {
    if (!(yield* textures.fill())) throw tooLarge(volume, device);
    isWhole = true;
  } finally {
    if (!isWhole) textures.dispose();
  }
  return {
    ...bricksText({
      twoBytes: samples instanceof Uint16Array,
      noData,
      filterInShader,
      grouped: layout.groupSide > 1,
      halved: halvingsOf(layout, volume.grid.dimensions) !== null,
    }),
    stage: 'field',
    sparesRays: true,
    order: 2,
    storedScale,
    twin: cartesianTwin,
    get bytes() {
      return textures.bytes;
    },
    inputs: () => textures.inputs(),
    dispose: () => textures.dispose(),
  };
}
