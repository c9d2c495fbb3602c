import type { Gl } from './device.ts';
import { textureUnit } from './texture-unit.ts';
import type { TextureUnit } from './texture-unit.ts';

/** One texture of a target: its attachment point, its format, and the sampler that reads it. */
export interface Attachment {
  readonly point: number;
  /** Internal format, format and type: the arguments of texImage2D. */
  readonly internal: number;
  readonly format: number;
  readonly type: number;
  readonly samplerName: string;
}

/** RGBA with 8 bits a channel, like the canvas. */
export function bytesAttachment(gl: Gl, samplerName: string): Attachment {
  return { point: gl.COLOR_ATTACHMENT0, internal: gl.RGBA, format: gl.RGBA, type: gl.UNSIGNED_BYTE, samplerName };
}

/** Textures that a program draws into, and that another program then reads pixel by pixel. */
export class DrawTarget {
  readonly framebuffer: WebGLFramebuffer;
  /** In the order of the attachments. */
  readonly units: readonly TextureUnit[];
  #width = 0;
  #height = 0;

  constructor(
    readonly gl: Gl,
    readonly attachments: readonly Attachment[],
  ) {
    this.framebuffer = gl.createFramebuffer();
    this.units = attachments.map(({ samplerName }) =>
      textureUnit(gl, { type: gl.TEXTURE_2D, texture: gl.createTexture(), filter: gl.NEAREST, samplerName }),
    );
  }

  get width(): number {
    return this.#width;
  }

  get height(): number {
    return this.#height;
  }

  /** Set the size. If it changes, the previous picture is lost. */
  resize(width: number, height: number): void {
    if (width === this.#width && height === this.#height) return;
    const { gl } = this;
    this.#width = width;
    this.#height = height;
    // The caller may be in the middle of a drawing, with its textures bound.
    const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
    const boundTexture = gl.getParameter(gl.TEXTURE_BINDING_2D) as WebGLTexture | null;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    this.attachments.forEach(({ point, internal, format, type }, i) => {
      const { texture } = this.units[i];
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, null);
      for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
        gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
      for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
        gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, point, gl.TEXTURE_2D, texture, 0);
    });
    gl.bindTexture(gl.TEXTURE_2D, boundTexture);
    gl.bindFramebuffer(gl.FRAMEBUFFER, bound);
  }

  dispose(): void {
    this.gl.deleteFramebuffer(this.framebuffer);
    for (const { texture } of this.units) this.gl.deleteTexture(texture);
  }
}
