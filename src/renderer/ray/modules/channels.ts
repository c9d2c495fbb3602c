import channels from '../../../../shaders/chunks/field/channels.glsl?raw';
import channels3d from '../../../../shaders/chunks/field/channels-3d.glsl?raw';
import channelsMosaic from '../../../../shaders/chunks/field/channels-mosaic.glsl?raw';
import channelColors from '../../../../shaders/chunks/shade/channel-colors.glsl?raw';
import type { Samples, VolumeData } from '../../../volume/volume.ts';
import type { Device, Gl } from '../../device/device.ts';
import type { ProgramInputs } from '../../device/inputs.ts';
import type { Upload } from '../../textures/fill-texture.ts';
import { cartesianProvider, uploadBlock } from './cartesian-field.ts';
import type { FieldModule, FieldProvider, RayModule, RayText } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** The text that finds the light of a volume's channels at a place. @param texture3d - false: as a mosaic in a 2D texture */
export function channelsText(texture3d: boolean): RayText {
  return {
    name: 'channels',
    stage: 'field',
    defines: { CHANNELS_3D: Number(texture3d) },
    chunks: [texture3d ? channels3d : channelsMosaic, channels],
    samplers: ['uChannels'],
    members: ['vec4 channels'],
  };
}

const shared = { sparesRays: true, order: 2 };

/** Gives segments the colours of their channels. */
export const channelColorsModule: RayModule<'shade'> = {
  name: 'channelColors',
  stage: 'shade',
  defines: {},
  chunks: [channelColors],
  samplers: [],
  ...shared,
  inputs: () => ({ uniforms: {}, units: [] }),
  twin: twinOf(usualTwins, ({ channelShade }) => ({ shades: [channelShade] })),
};

const channelsTwin = twinOf(usualTwins, ({ channelField }, { volume }) => ({
  moreFields: [channelField(volume.channels!, volume.grid.dimensions)],
}));

/** Uploads volumes of several channels to the GPU. */
export const channelsProvider: FieldProvider = { upload: uploadChannels };

function* uploadChannels(gl: Gl, volume: VolumeData, device: Device): Upload<FieldModule> {
  const { grid } = volume;
  const { colors } = volume.channels!;
  const voxels = yield* cartesianProvider.upload(gl, volume, device);
  // A texel of four bytes is moved as one number of 32 bits.
  const samples = new Uint32Array(colors.buffer, colors.byteOffset, colors.length / 4) as unknown as Samples;
  const texels = {
    internal: device.webgl2 ? (gl as WebGL2RenderingContext).RGBA8 : gl.RGBA,
    format: gl.RGBA,
    type: gl.UNSIGNED_BYTE,
    bytes: 4,
  };
  const pack = ({ buffer, byteOffset, byteLength }: Samples): Samples => new Uint8Array(buffer, byteOffset, byteLength);
  let block;
  try {
    block = yield* uploadBlock(
      gl,
      { samples, grid, hasNoData: false },
      { device, filterInShader: false, packing: { texels, pack } },
    );
  } finally {
    if (!block) voxels.dispose();
  }
  const {
    uniforms: { uMosaic },
    units: [unit],
  } = block.inputs();
  const inputs: ProgramInputs = {
    uniforms: uMosaic ? { uChannelMosaic: uMosaic } : {},
    units: [{ ...unit, samplerName: 'uChannels' }],
  };
  const field: RayModule<'field'> = {
    ...channelsText(device.webgl2),
    ...shared,
    stage: 'field',
    inputs: () => inputs,
    twin: channelsTwin,
  };
  return {
    ...voxels,
    bytes: voxels.bytes + block.bytes,
    more: [field, channelColorsModule],
    dispose() {
      voxels.dispose();
      block.dispose();
    },
  };
}
