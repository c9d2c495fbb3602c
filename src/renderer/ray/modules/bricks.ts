// A volume with bricks of finer levels over it. The first such volume loads this file.
import bricks3d from '../../../../shaders/chunks/field/bricks-3d.glsl?raw';
import type { ResidentBricks } from '../../../bricks/resident-bricks.ts';
import type { VolumeData } from '../../../volume/volume.ts';
import type { Device, Gl } from '../../device/device.ts';
import { joinInputs } from '../../device/inputs.ts';
import { BrickTextures, brickDefines } from '../../textures/brick-textures.ts';
import { texelsOf } from '../../textures/fill-texture.ts';
import type { Upload } from '../../textures/fill-texture.ts';
import type { FieldModule, RayText } from '../ray-module.ts';
import { cartesianProvider, cartesianText, cartesianTwin, isFiltered } from './cartesian-field.ts';
import type { CartesianOptions } from './cartesian-field.ts';
import volume3d from '../../../../shaders/chunks/field/volume-3d.glsl?raw';

/** A float that interpolate.glsl reads as no data. */
const lacksData = -3.4e38;

/** The text of a field with bricks; only in WebGL 2. */
export function bricksText(options: Omit<CartesianOptions, 'texture3d'>): RayText {
  const whole = cartesianText({ ...options, texture3d: true });
  return {
    ...whole,
    name: 'bricks',
    defines: { ...whole.defines, ...brickDefines },
    chunks: whole.chunks.map((chunk) => (chunk === volume3d ? bricks3d : chunk)),
    samplers: [...whole.samplers, 'uBricks', 'uBrickPages', 'uBrickLevels'],
  };
}

/** Uploads volumes that have `ResidentBricks` as their finer voxels; only in WebGL 2. */
export function* uploadBricks(gl: Gl, volume: VolumeData, device: Device): Upload<FieldModule> {
  const whole = yield* cartesianProvider.upload(gl, volume, device);
  const { samples, hasNoData: noData } = volume;
  const filterInShader = !isFiltered(volume, device);
  const textures = new BrickTextures(gl as WebGL2RenderingContext, volume.finer as ResidentBricks, {
    texels: texelsOf(gl, samples),
    filter: filterInShader ? gl.NEAREST : gl.LINEAR,
    pack: (some) =>
      some instanceof Float32Array
        ? some.map((value) => (Number.isFinite(value) ? value / whole.storedScale : lacksData))
        : some,
  });
  return {
    ...whole,
    ...bricksText({ twoBytes: samples instanceof Uint16Array, noData, filterInShader }),
    stage: 'field',
    twin: cartesianTwin,
    get bytes() {
      return whole.bytes + textures.bytes;
    },
    inputs: () => joinInputs(whole.inputs(), textures.inputs()),
    dispose() {
      whole.dispose();
      textures.dispose();
    },
  };
}
