import decode from '../../../../shaders/chunks/field/decode.glsl?raw';
import discrete from '../../../../shaders/chunks/field/discrete-field.glsl?raw';
import volume3d from '../../../../shaders/chunks/field/volume-3d.glsl?raw';
import volumeMosaic from '../../../../shaders/chunks/field/volume-mosaic.glsl?raw';
import vote from '../../../../shaders/chunks/field/vote.glsl?raw';
import type { VolumeData } from '../../../volume/volume.ts';
import type { Device, Gl } from '../../device/device.ts';
import type { Upload } from '../../textures/fill-texture.ts';
import type { FieldModule, FieldProvider, RayText } from '../ray-module.ts';
import { cartesianTwin, uploadBlock } from './cartesian-field.ts';
import type { CartesianOptions } from './cartesian-field.ts';

/** A field of labels: each place has one of the values of the voxels around it; values are never interpolated. */
export function discreteText({ texture3d, twoBytes, noData }: Omit<CartesianOptions, 'filterInShader'>): RayText {
  return {
    name: 'discrete',
    stage: 'field',
    defines: {
      TEXTURE_3D: Number(texture3d),
      TWO_BYTES: Number(twoBytes),
      NO_DATA: Number(noData),
      FILTER_IN_SHADER: 1,
      FOLDS: 1,
    },
    chunks: [decode, texture3d ? volume3d : volumeMosaic, vote, discrete],
    samplers: ['uVolume'],
  };
}

/** Uploads volumes of labels to the GPU. */
export const discreteProvider: FieldProvider = { upload: uploadDiscrete };

function* uploadDiscrete(gl: Gl, volume: VolumeData, device: Device): Upload<FieldModule> {
  const block = yield* uploadBlock(gl, volume, { device, filterInShader: true });
  const { webgl2: texture3d } = device;
  return {
    ...block,
    ...discreteText({ texture3d, twoBytes: volume.samples instanceof Uint16Array, noData: volume.hasNoData }),
    stage: 'field',
    sparesRays: true,
    order: 1,
    twin: cartesianTwin,
  };
}
