import count from '../../../shaders/chunks/classify/count-substeps.glsl?raw';
import walk from '../../../shaders/chunks/walk/walk-substeps.glsl?raw';
import { integrateForTable } from '../../optics/transfer/preintegration-table.ts';
import type { RunningIntegral } from '../../optics/transfer/running-integral.ts';
import { substepsPerRoot, substepTableDomain, substepTableSize } from '../../optics/transfer/substep-limits.ts';
import { buildSubstepTable } from '../../optics/transfer/substep-table.ts';
import type { SubstepTable } from '../../optics/transfer/substep-table.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { Gl } from '../device/device.ts';
import { prepareUpload, uploadPlane } from '../textures/fill-texture.ts';
import { textureUnit } from '../device/texture-unit.ts';
import type { TextureUnit } from '../device/texture-unit.ts';
import type { SubstepPart } from './substep-provider.ts';

/** Upload the table that says into how many substeps a step is cut. When the table changes, the same texture is filled again. */
export function uploadSubstepTable(gl: Gl, { texels }: SubstepTable, previous: WebGLTexture | null): TextureUnit {
  const texture = previous ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  uploadPlane(gl, texels, { width: substepTableSize.columns, height: substepTableSize.rows });
  return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uSubstepTable' });
}

/** Integrals by transfer function: another opacity factor changes the table, but not its integral. */
const integrals = new WeakMap<TransferFunction, RunningIntegral>();

function integralOf(transferFunction: TransferFunction): RunningIntegral {
  const integral = integrals.get(transferFunction) ?? integrateForTable(transferFunction);
  integrals.set(transferFunction, integral);
  return integral;
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
  makeTable: (gl, transferFunction, voxelRatio, previous) =>
    uploadSubstepTable(gl, buildSubstepTable(integralOf(transferFunction), voxelRatio), previous),
};
