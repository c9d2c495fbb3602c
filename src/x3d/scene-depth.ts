import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';
import { textureUnit } from './textures.ts';
import type { X3dTextureUnit } from './x3dom-types.ts';

/**
 * The depth of the scene's opaque shapes as a texture, so that rays can end at them. The page's own depth buffer can't
 * be read in WebGL, hence a second drawing of the shapes (only where there are any) into this target. 24 or more bits;
 * x3dom's own depth textures have 16.
 */
export class SceneDepth {
  readonly framebuffer: WebGLFramebuffer;
  readonly #depth: WebGLTexture;
  readonly #color: WebGLTexture;
  #width = 0;
  #height = 0;

  private constructor(readonly gl: Gl) {
    this.framebuffer = gl.createFramebuffer();
    this.#depth = gl.createTexture();
    this.#color = gl.createTexture();
  }

  /** null where the device has no depth textures (a few WebGL 1 ones): the volume then is drawn over the shapes. */
  static create(gl: Gl): SceneDepth | null {
    if (!isWebGl2(gl) && !gl.getExtension('WEBGL_depth_texture')) return null;
    return new SceneDepth(gl);
  }

  get unit(): X3dTextureUnit {
    const { gl } = this;
    return textureUnit(gl, { type: gl.TEXTURE_2D, texture: this.#depth, filter: gl.NEAREST, samplerName: 'uSceneDepth' });
  }

  /** Give the target the picture's size. */
  resize(width: number, height: number): void {
    if (width === this.#width && height === this.#height) return;
    const { gl } = this;
    this.#width = width;
    this.#height = height;
    gl.bindTexture(gl.TEXTURE_2D, this.#color);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
    this.#setNearest();
    gl.bindTexture(gl.TEXTURE_2D, this.#depth);
    const internal = isWebGl2(gl) ? gl.DEPTH_COMPONENT24 : gl.DEPTH_COMPONENT;
    gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, gl.DEPTH_COMPONENT, gl.UNSIGNED_INT, null);
    this.#setNearest();
    const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.#color, 0);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.#depth, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, bound);
  }

  dispose(): void {
    const { gl } = this;
    gl.deleteFramebuffer(this.framebuffer);
    gl.deleteTexture(this.#depth);
    gl.deleteTexture(this.#color);
  }

  #setNearest(): void {
    const { gl } = this;
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  }
}
