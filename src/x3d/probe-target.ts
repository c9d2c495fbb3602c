import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';

/** A small float picture that can be read back: errors far below 1/255 are to be seen. */
export class ProbeTarget {
  readonly framebuffer: WebGLFramebuffer;
  readonly #texture: WebGLTexture;
  #width = 0;
  #height = 0;

  private constructor(readonly gl: Gl, readonly half: boolean) {
    this.framebuffer = gl.createFramebuffer();
    this.#texture = gl.createTexture();
  }

  /** null where the device can't draw into floats and blend there. */
  static create(gl: Gl): ProbeTarget | null {
    const drawable = gl.getExtension(isWebGl2(gl) ? 'EXT_color_buffer_float' : 'WEBGL_color_buffer_float') !== null;
    const blendable = gl.getExtension('EXT_float_blend') !== null;
    if (!drawable || (!blendable && !isWebGl2(gl))) return null;
    return new ProbeTarget(gl, !blendable);
  }

  resize(width: number, height: number): void {
    if (width === this.#width && height === this.#height) return;
    const { gl } = this;
    this.#width = width;
    this.#height = height;
    gl.bindTexture(gl.TEXTURE_2D, this.#texture);
    const format = isWebGl2(gl) ? (this.half ? gl.RGBA16F : gl.RGBA32F) : gl.RGBA;
    gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, gl.RGBA, gl.FLOAT, null);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.#texture, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, bound);
  }

  /** The pixels of the bound framebuffer: RGBA, premultiplied, 0..1, bottom row first. */
  read(): Float32Array<ArrayBuffer> {
    const { gl } = this;
    const pixels = new Float32Array(this.#width * this.#height * 4);
    gl.readPixels(0, 0, this.#width, this.#height, gl.RGBA, gl.FLOAT, pixels);
    return pixels;
  }

  dispose(): void {
    this.gl.deleteFramebuffer(this.framebuffer);
    this.gl.deleteTexture(this.#texture);
  }
}
