import { VolumeViewError } from '../errors.ts';
import type { DeviceLimits } from '../volume/reduce.ts';
import { probeTwoByteFilter } from './probe-filter.ts';

export type Gl = WebGLRenderingContext | WebGL2RenderingContext;

/** What this page's WebGL can do, as far as volumes are concerned. */
export interface Device {
  readonly webgl2: boolean;
  readonly maxTextureSize: number;
  /** 0 in WebGL 1. */
  readonly max3dTextureSize: number;
  /** Float textures can be filtered by the device. */
  readonly floatLinear: boolean;
  /** Vertex shaders read textures, and points of 2 x 2 pixels are drawn: what thinning the rays takes. */
  readonly quadPoints: boolean;
  /** Filtering 16 bits in two 8-bit channels keeps 16 bits. */
  readonly twoByteLinear: boolean;
}

let probed: Device | null = null;

/**
 * Ask a throw-away context, once a page.
 * @throws {VolumeViewError} `webgl/unavailable` or `webgl/unsupported`
 */
export function probeDevice(): Device {
  if (probed) return probed;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 1;
  const gl = getContext(canvas);
  if (!gl) {
    throw new VolumeViewError(
      'webgl/unavailable',
      'This browser can not draw 3D pictures here: it offers no WebGL. Switch on hardware acceleration in its settings, or use another browser or device.',
    );
  }
  try {
    probed = describe(gl);
    return probed;
  } finally {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}

/** As x3dom asks: on Apple's systems it takes WebGL 1. */
function getContext(canvas: HTMLCanvasElement): Gl | null {
  const apple = /mac|ip(hone|od|ad)/i.test(navigator.platform);
  return (apple ? null : canvas.getContext('webgl2')) ?? canvas.getContext('webgl');
}

/** What a context can do. Enables the extensions that the textures need; call it for each context in use. */
export function describe(gl: Gl): Device {
  const webgl2 = isWebGl2(gl);
  const highp = gl.getShaderPrecisionFormat(gl.FRAGMENT_SHADER, gl.HIGH_FLOAT);
  if (!highp || highp.precision < 23) {
    throw new VolumeViewError(
      'webgl/unsupported',
      'This device computes pixels with less than 32 bits (no highp floats), which is too coarse for a correct picture. Use another browser or device.',
    );
  }
  if (!webgl2 && !gl.getExtension('OES_texture_float')) {
    throw new VolumeViewError(
      'webgl/unsupported',
      'This browser offers WebGL 1 without float textures (OES_texture_float), which a correct picture needs. Update the browser or use another device.',
    );
  }
  const floatLinear = gl.getExtension('OES_texture_float_linear') !== null;
  return {
    webgl2,
    maxTextureSize: gl.getParameter(gl.MAX_TEXTURE_SIZE) as number,
    max3dTextureSize: isWebGl2(gl) ? (gl.getParameter(gl.MAX_3D_TEXTURE_SIZE) as number) : 0,
    floatLinear,
    quadPoints: (gl.getParameter(gl.MAX_VERTEX_TEXTURE_IMAGE_UNITS) as number) > 0 && (gl.getParameter(gl.ALIASED_POINT_SIZE_RANGE) as Float32Array)[1] >= 2,
    twoByteLinear: isWebGl2(gl) && probeTwoByteFilter(gl),
  };
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
