import type { Gl } from './device.ts';
import { textureUnit } from './textures.ts';
import type { Uniforms } from './uniforms.ts';
import type { X3dTextureUnit } from './x3dom-types.ts';

/** A picture that is drawn piece by piece where nobody sees it, premultiplied, with 8 bits a channel as the canvas has. */
export class GatheredPicture {
  readonly framebuffer: WebGLFramebuffer;
  readonly unit: X3dTextureUnit;
  readonly #texture: WebGLTexture;
  #width = 0;
  #height = 0;

  constructor(readonly gl: Gl) {
    this.framebuffer = gl.createFramebuffer();
    this.#texture = gl.createTexture();
    this.unit = textureUnit(gl, { type: gl.TEXTURE_2D, texture: this.#texture, filter: gl.NEAREST, samplerName: 'uGathered' });
  }

  get uniforms(): Uniforms {
    return { uGatheredPixel: [1 / this.#width, 1 / this.#height] };
  }

  resize(width: number, height: number): void {
    if (width === this.#width && height === this.#height) return;
    const { gl } = this;
    this.#width = width;
    this.#height = height;
    gl.bindTexture(gl.TEXTURE_2D, this.#texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.#texture, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, bound);
  }

  dispose(): void {
    this.gl.deleteFramebuffer(this.framebuffer);
    this.gl.deleteTexture(this.#texture);
  }
}
