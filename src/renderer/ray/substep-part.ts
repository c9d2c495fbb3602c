import count from '../../../shaders/chunks/count-substeps.glsl?raw';
import walk from '../../../shaders/chunks/walk-substeps.glsl?raw';
import { substepsPerRoot, substepTableDomain, substepTableSize } from '../../optics/substep-limits.ts';
import { buildSubstepTable } from '../../optics/substep-table.ts';
import type { SubstepTable } from '../../optics/substep-table.ts';
import type { Gl } from '../device.ts';
import { prepareUpload, uploadPlane } from '../fill-texture.ts';
import { textureUnit } from '../texture-unit.ts';
import type { TextureUnit } from '../texture-unit.ts';
import type { SubstepPart } from './substep-provider.ts';

/** What tells into how many substeps steps are cut; the same texture is filled again when it changes. */
export function uploadSubstepTable(gl: Gl, { texels }: SubstepTable, previous: WebGLTexture | null): TextureUnit {
  const texture = previous ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  uploadPlane(gl, texels, { width: substepTableSize.columns, height: substepTableSize.rows });
  return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uSubstepTable' });
}

export const cuttingSteps: SubstepPart = {
  count,
  walk,
  defines: {
    SUBSTEPS: 1,
    SUBSTEPS_PER_ROOT: substepsPerRoot.toFixed(1),
    SUBSTEP_TABLE_COLUMNS: substepTableSize.columns.toFixed(1),
    SUBSTEP_TABLE_ROWS: substepTableSize.rows.toFixed(1),
    SUBSTEP_TABLE_FROM: substepTableDomain.from.toFixed(3),
    SUBSTEP_TABLE_WIDTH: (substepTableDomain.to - substepTableDomain.from).toFixed(3),
  },
  makeTable: (gl, sums, voxelRatio, previous) => uploadSubstepTable(gl, buildSubstepTable(sums, voxelRatio), previous),
};
