import classify from '../../../../shaders/chunks/classify.glsl?raw';
import transferFunctionChunk from '../../../../shaders/chunks/transfer-function.glsl?raw';
import { brighten } from '../../../optics/brighten.ts';
import { contributionOf } from '../../../optics/empty-space-distance.ts';
import type { Contribution } from '../../../optics/empty-space-distance.ts';
import { averageSpans, integrateForTable } from '../../../optics/preintegration-table.ts';
import type { PreintegrationTable } from '../../../optics/preintegration-table.ts';
import type { RunningIntegral } from '../../../optics/running-integral.ts';
import { substepsPerRoot } from '../../../optics/segment.ts';
import { largestOpacity } from '../../../optics/transfer-function.ts';
import { buildSubstepTable, substepTableDomain, substepTableSize } from '../../../optics/substep-table.ts';
import { finestSpacing } from '../../../volume/grid.ts';
import type { Device, Gl } from '../../device.ts';
import { joinInputs } from '../../inputs.ts';
import type { ProgramInputs } from '../../inputs.ts';
import { Kept } from '../../kept.ts';
import { tableInShader, uploadSubstepTable, uploadTable } from '../../table-textures.ts';
import type { TextureUnit } from '../../texture-unit.ts';
import type { Optics, RayFrame, RayModule, RayText } from '../ray-module.ts';

export { transferFunctionClassify as twin } from '../../../optics/ray-classify.ts';

/** @param inShader - the pre-integration table is interpolated by four fetches, where the device can't filter float textures */
export function transferFunctionText(inShader: boolean): RayText {
  return {
    name: 'transferFunction',
    stage: 'classify',
    defines: {
      TABLE_IN_SHADER: Number(inShader),
      SUBSTEPS_PER_ROOT: substepsPerRoot.toFixed(1),
      SUBSTEP_TABLE_COLUMNS: substepTableSize.columns.toFixed(1),
      SUBSTEP_TABLE_ROWS: substepTableSize.rows.toFixed(1),
      SUBSTEP_TABLE_FROM: substepTableDomain.from.toFixed(3),
      SUBSTEP_TABLE_WIDTH: (substepTableDomain.to - substepTableDomain.from).toFixed(3),
    },
    chunks: [transferFunctionChunk, classify],
    samplers: ['uTransferFunction', 'uSubstepTable'],
  };
}

/** Factors stay below this, so that the shader's products stay numbers. */
const largestFactor = 1e30;

interface Tables {
  readonly integral: RunningIntegral;
  readonly unit: TextureUnit;
  readonly inputs: ProgramInputs;
}

/** Values look as the transfer function says: pre-integration, and substeps where much may be seen. */
export function createTransferFunction(gl: Gl, device: Device): RayModule<'classify'> {
  const tables = new Kept<Tables>();
  const substeps = new Kept<TextureUnit>();
  const contribution = new Kept<Contribution>();

  const makeTables = ({ transferFunction, lightFactor }: Optics, last: Tables | null): Tables => {
    const integral = integrateForTable(brighten(transferFunction, lightFactor));
    const table = averageSpans(integral);
    const unit = uploadTable(gl, table, last?.unit.texture ?? null, device);
    return { integral, unit, inputs: { uniforms: tableUniforms(table), units: [unit] } };
  };

  return {
    ...transferFunctionText(tableInShader(device)),
    stage: 'classify',
    sparesRays: true,
    order: 2,
    contributes: ({ transferFunction }) => contribution.get([transferFunction], () => contributionOf(transferFunction)),
    inputs({ volume, optics, rays, maxSubsteps }: RayFrame) {
      const { transferFunction, lightFactor, opacityFactor, referenceLength } = optics;
      const { integral, inputs } = tables.get([transferFunction, lightFactor], (last) => makeTables(optics, last));
      const voxelRatio = (finestSpacing(volume.grid) / referenceLength) * opacityFactor;
      const unit = substeps.get([integral, voxelRatio], (last) => uploadSubstepTable(gl, buildSubstepTable(integral, voxelRatio), last?.texture ?? null));
      const uOpticalScale = Math.min(largestFactor, (rays.diameter / referenceLength) * opacityFactor);
      const uLargestOpacity = largestOpacity(transferFunction);
      return joinInputs(inputs, { uniforms: { uOpticalScale, uLargestOpacity, uMaxSubsteps: maxSubsteps }, units: [unit] });
    },
    dispose() {
      for (const unit of [tables.last?.unit, substeps.last]) gl.deleteTexture(unit?.texture ?? null);
    },
  };
}

/** What the chunk knows of the table but its texels. */
export function tableUniforms({ columns, rows, first, last }: PreintegrationTable): ProgramInputs['uniforms'] {
  return { uTableSize: [columns, rows], uTableFirst: first, uTableLast: last };
}
