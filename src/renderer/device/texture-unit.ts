import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';

/** A texture, how it is filtered, and the sampler that reads it. The fields are those of an entry of x3dom's list of a shape's textures. */
export interface TextureUnit {
  type: number;
  texture: WebGLTexture;
  samplerName: string;
  wrapS: number;
  wrapT: number;
  minFilter: number;
  magFilter: number;
  anisotropicDegree: number;
}

/** Describe a texture in the form that x3dom expects. */
export function textureUnit(
  gl: Gl,
  { type, texture, filter, samplerName }: { type: number; texture: WebGLTexture; filter: number; samplerName: string },
): TextureUnit {
  const wrap = gl.CLAMP_TO_EDGE;
  if (isWebGl2(gl) && type === gl.TEXTURE_3D) {
    gl.bindTexture(type, texture);
    gl.texParameteri(type, gl.TEXTURE_WRAP_R, wrap);
  }
  return {
    type,
    texture,
    samplerName,
    wrapS: wrap,
    wrapT: wrap,
    minFilter: filter,
    magFilter: filter,
    anisotropicDegree: 1,
  };
}
