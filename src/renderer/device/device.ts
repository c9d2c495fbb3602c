import type { DeviceLimits } from '../../volume/reduce.ts';

export type Gl = WebGLRenderingContext | WebGL2RenderingContext;

/** What this page's WebGL can do, as far as volumes are concerned. */
export interface Device {
  readonly webgl2: boolean;
  readonly maxTextureSize: number;
  /** 0 in WebGL 1. */
  readonly max3dTextureSize: number;
  /** Float textures can be filtered by the device. */
  readonly floatLinear: boolean;
  /** Vertex shaders read textures, and points of 2 x 2 pixels are drawn: what adaptive ray sampling takes. */
  readonly quadPoints: boolean;
  /** Filtering 16 bits in two 8-bit channels keeps 16 bits; absent until `askTwoByteFilter`, and taken for no. */
  twoByteLinear?: boolean;
}

export function isWebGl2(gl: Gl): gl is WebGL2RenderingContext {
  return typeof WebGL2RenderingContext !== 'undefined' && gl instanceof WebGL2RenderingContext;
}

/** Most bytes of samples that one volume may take: what browsers let a page allocate at once on any device. */
const maxVolumeBytes = 2 ** 30;

/** The share of a device's memory that one volume may take: it is there twice, in the page and on the GPU, and more while it is decoded. */
const memoryShare = 1 / 8;

/**
 * What a volume must not exceed to be shown on a device.
 * @param maxBytes - that the GPU had memory for
 */
export function deviceLimits(device: Device, maxBytes = Infinity): DeviceLimits {
  // GiB, at most 8 and only in some browsers. Source: W3C, Device Memory.
  const { deviceMemory = Infinity } = navigator as Navigator & { deviceMemory?: number };
  return {
    maxVoxelsPerAxis: device.webgl2 ? device.max3dTextureSize : device.maxTextureSize,
    maxAtlasSize: device.webgl2 ? null : device.maxTextureSize,
    maxBytes: Math.min(maxVolumeBytes, deviceMemory * memoryShare * 2 ** 30, maxBytes),
  };
}
