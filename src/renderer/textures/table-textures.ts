import type { PreintegrationTable } from '../../optics/transfer/preintegration-table.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import { prepareUpload } from './fill-texture.ts';
import { textureUnit } from '../device/texture-unit.ts';
import type { TextureUnit } from '../device/texture-unit.ts';

/** Upload the transfer function's table, for devices that filter floats. When the table changes, the same texture is filled again. */
export function uploadTable(gl: Gl, table: PreintegrationTable, previous: WebGLTexture | null): TextureUnit {
  const texture = previous ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  const format = isWebGl2(gl) ? gl.RGBA32F : gl.RGBA;
  gl.texImage2D(gl.TEXTURE_2D, 0, format, table.columns, table.rows, 0, gl.RGBA, gl.FLOAT, table.texels);
  return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.LINEAR, samplerName: 'uTransferFunction' });
}
