import { VolumeViewError } from '../../core/errors.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Device, Gl } from '../device/device.ts';

let probed: Device | null = null;

/**
 * Find out what the device can do, in a temporary context, once a page.
 * @throws {VolumeViewError} `webgl/unavailable` or `webgl/unsupported`
 */
export function probeDevice(): Device {
  return (probed ??= inSpareContext(describe));
}

function inSpareContext<T>(ask: (gl: Gl) => T): T {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 1;
  const gl = getContext(canvas);
  if (!gl) {
    throw new VolumeViewError(
      'webgl/unavailable',
      'this browser offers no WebGL here: switch on hardware acceleration in its settings, or use another browser or device',
    );
  }
  try {
    return ask(gl);
  } finally {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}

let twoByteLinear: Promise<boolean> | null = null;

/** Await it before drawing a volume of 16 bits; else the shader filters that volume. Loads the probe, once a page. */
export async function askTwoByteFilter(device: Device): Promise<void> {
  if (!device.webgl2) return;
  twoByteLinear ??= import('./probe-filter.ts')
    .then(({ probeTwoByteFilter }) => inSpareContext(probeTwoByteFilter))
    .catch(() => false);
  device.twoByteLinear = await twoByteLinear;
}

/** Choose the same WebGL version as x3dom: on Apple's systems x3dom takes WebGL 1. */
function getContext(canvas: HTMLCanvasElement): Gl | null {
  const apple = /mac|ip(hone|od|ad)/i.test(navigator.platform);
  return (apple ? null : canvas.getContext('webgl2')) ?? canvas.getContext('webgl');
}

/** What a context can do. It also enables the extensions that the textures need; call it for each context in use. */
export function describe(gl: Gl): Device {
  const webgl2 = isWebGl2(gl);
  const highp = gl.getShaderPrecisionFormat(gl.FRAGMENT_SHADER, gl.HIGH_FLOAT);
  const lack =
    !highp || highp.precision < 23
      ? 'no highp floats'
      : !webgl2 && !gl.getExtension('OES_texture_float')
        ? 'no float textures'
        : '';
  if (lack)
    throw new VolumeViewError(
      'webgl/unsupported',
      `WebGL has ${lack} here, which a correct picture needs. Update the browser, or use another browser or device.`,
    );
  const floatLinear = gl.getExtension('OES_texture_float_linear') !== null;
  return {
    webgl2,
    maxTextureSize: gl.getParameter(gl.MAX_TEXTURE_SIZE) as number,
    max3dTextureSize: isWebGl2(gl) ? (gl.getParameter(gl.MAX_3D_TEXTURE_SIZE) as number) : 0,
    floatLinear,
    quadPoints:
      (gl.getParameter(gl.MAX_VERTEX_TEXTURE_IMAGE_UNITS) as number) > 1 &&
      (gl.getParameter(gl.ALIASED_POINT_SIZE_RANGE) as Float32Array)[1] >= 2,
  };
}
