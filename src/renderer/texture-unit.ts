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
