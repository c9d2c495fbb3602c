import type { DeviceLimits } from '../../volume/reduce.ts';

export type Gl = WebGLRenderingContext | WebGL2RenderingContext;

/** The abilities of this page's WebGL that matter for volumes. */
export interface Device {
  readonly webgl2: boolean;
  readonly maxTextureSize: number;
  /** 0 in WebGL 1. */
  readonly max3dTextureSize: number;
  /** Float textures can be filtered by the device. */
  readonly floatLinear: boolean;
  /** Vertex shaders can read textures, and points of 2 x 2 pixels can be drawn: adaptive ray sampling needs both. */
  readonly quadPoints: boolean;
  /** Filtering 16 bits in two 8-bit channels keeps 16 bits; absent until `askTwoByteFilter`, which counts as false. */
  twoByteLinear?: boolean;
}

export function isWebGl2(gl: Gl): gl is WebGL2RenderingContext {
  return typeof WebGL2RenderingContext !== 'undefined' && gl instanceof WebGL2RenderingContext;
}

/** The maximum bytes of samples of one volume: browsers let a page allocate this much at once on any device. */
const maxVolumeBytes = 2 ** 30;

/** The share of a device's memory that one volume may take: memory holds it twice, in the page and on the GPU, and more during decoding. */
const memoryShare = 1 / 8;

/**
 * The limits for a volume that is to be shown on a device.
 * @param maxBytes - the bytes for which the GPU had memory
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
