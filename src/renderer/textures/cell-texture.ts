import type { Macrocells } from '../../volume/macrocells.ts';
import { atlasLayout, packAtlas } from '../../volume/atlas.ts';
import type { Device, Gl } from '../device/device.ts';
import { prepareUpload, uploadPlane } from './fill-texture.ts';
import type { Uniforms } from '../device/inputs.ts';
import { textureUnit } from '../device/texture-unit.ts';
import type { TextureUnit } from '../device/texture-unit.ts';

/** A texture with a number for each macrocell of a volume, and the uniforms that say where each number is. */
export interface CellTexture {
  readonly unit: TextureUnit;
  readonly uniforms: Uniforms;
}

/**
 * @param numbers - one or two bytes for each cell, i fastest
 * @param previous - its texture is filled again
 */
export function uploadCells(
  gl: Gl,
  numbers: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>,
  { dimensions: cells, size }: Pick<Macrocells, 'dimensions' | 'size'>,
  { previous, device, samplerName }: { previous: CellTexture | null; device: Device; samplerName: string },
): CellTexture {
  const atlas = atlasLayout(cells, device.maxTextureSize)!;
  const texture = previous?.unit.texture ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  uploadPlane(gl, packAtlas(numbers, cells, atlas), atlas);
  return {
    unit: textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName }),
    uniforms: {
      uCells: [...cells, size],
      uCellMosaic: [atlas.columns, 1 / atlas.columns, 1 / atlas.width, 1 / atlas.height],
    },
  };
}
