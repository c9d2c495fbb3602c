/**
 * Runs in the page before all else: counts what WebGL calls allocate on the GPU, independently of what the product says
 * of itself, and how many contexts are alive. Deleted objects are taken off again, and those of lost contexts. The
 * drawing buffers are counted as colour, depth and stencil.
 */
export function countGpuBytes() {
  /** @type {Map<object, { gl: any, bytes: number, is3d?: boolean }>} */
  const objects = new Map();
  /** Of all 3D textures at once, since `gpuBytes` was last called. */
  let most3d = 0;
  const sum3d = () =>
    [...objects.values()].reduce((sum, { gl, bytes, is3d }) => sum + (is3d && !gl.isContextLost() ? bytes : 0), 0);
  /** @type {Set<WebGLRenderingContext | WebGL2RenderingContext>} */
  const contexts = new Set();
  /** @type {Record<number, number>} */
  const channels = {
    0x1903: 1,
    0x8227: 2,
    0x1907: 3,
    0x1908: 4,
    0x1909: 1,
    0x190a: 2,
    0x1902: 1,
    0x84f9: 1,
    0x1906: 1,
  };
  /** @type {Record<number, number>} */
  const sizes = { 0x1401: 1, 0x1406: 4, 0x140b: 2, 0x8d61: 2, 0x1405: 4, 0x1403: 2, 0x84fa: 4 };
  /**
   * Bytes of a texel by sized format: R8, R8UI, RG8, RGBA8, R16F, RG16F, RGBA16F, R32F, RG32F, RGBA32F.
   * @type {Record<number, number>}
   */
  const texels = {
    0x8229: 1,
    0x8232: 1,
    0x822b: 2,
    0x8058: 4,
    0x822d: 2,
    0x822f: 4,
    0x881a: 8,
    0x822e: 4,
    0x8230: 8,
    0x8814: 16,
  };
  const bindings = { 0x0de1: 0x8069, 0x806f: 0x806a };

  for (const type of [WebGLRenderingContext, globalThis.WebGL2RenderingContext].filter(Boolean)) {
    const prototype = /** @type {any} */ (type.prototype);
    wrap(prototype, 'texImage2D', (gl, args) => {
      if (args.length < 9) return;
      note(gl, args[0], args[3] * args[4] * (channels[args[6]] ?? 4) * (sizes[args[7]] ?? 1));
    });
    wrap(prototype, 'texImage3D', (gl, args) => {
      note(gl, args[0], args[3] * args[4] * args[5] * (channels[args[7]] ?? 4) * (sizes[args[8]] ?? 1));
    });
    wrap(prototype, 'texStorage2D', (gl, args) => note(gl, args[0], args[3] * args[4] * (texels[args[2]] ?? 4)));
    wrap(prototype, 'texStorage3D', (gl, args) =>
      note(gl, args[0], args[3] * args[4] * args[5] * (texels[args[2]] ?? 4)),
    );
    wrap(prototype, 'renderbufferStorage', (gl, args) => {
      const bound = gl.getParameter(gl.RENDERBUFFER_BINDING);
      if (bound) objects.set(bound, { gl, bytes: args[2] * args[3] * 4 });
    });
    for (const name of ['deleteTexture', 'deleteRenderbuffer'])
      wrap(prototype, name, (_, [object]) => objects.delete(object));
  }

  /** @param {any} gl @param {number} target @param {number} bytes */
  function note(gl, target, bytes) {
    contexts.add(gl);
    const bound = gl.getParameter(/** @type {any} */ (bindings)[target] ?? 0x8069);
    if (!bound) return;
    const is3d = target === gl.TEXTURE_3D;
    objects.set(bound, { gl, bytes, is3d });
    if (is3d) most3d = Math.max(most3d, sum3d());
  }

  /** @param {any} prototype @param {string} name @param {(gl: any, args: any[]) => void} before */
  function wrap(prototype, name, before) {
    const original = prototype[name];
    if (!original) return;
    prototype[name] = function (/** @type {any[]} */ ...args) {
      before(this, args);
      return original.apply(this, args);
    };
  }

  /** @type {any} */ (window).gpuBytes = () => {
    const held = [...objects.values()].filter(({ gl }) => !gl.isContextLost()).map(({ bytes }) => bytes);
    const textures = held.reduce((sum, bytes) => sum + bytes, 0);
    let buffers = 0;
    let living = 0;
    for (const gl of contexts) {
      if (gl.isContextLost()) continue;
      const samples = Math.max(1, gl.getParameter(gl.SAMPLES));
      buffers += gl.drawingBufferWidth * gl.drawingBufferHeight * (8 * samples + 4);
      living++;
    }
    const most = most3d;
    most3d = sum3d();
    return {
      samples: Math.max(0, ...held),
      textures,
      in3d: { now: most3d, most },
      all: textures + buffers,
      contexts: living,
    };
  };
}
