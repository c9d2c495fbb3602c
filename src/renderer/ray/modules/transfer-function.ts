import classify from '../../../../shaders/chunks/classify/classify.glsl?raw';
import spanTable from '../../../../shaders/chunks/classify/span-table.glsl?raw';
import transferFunctionChunk from '../../../../shaders/chunks/classify/transfer-function.glsl?raw';
import { brighten } from '../../../optics/transfer/brighten.ts';
import { contributionOf } from '../../../optics/cells/empty-space-distance.ts';
import type { Contribution } from '../../../optics/cells/empty-space-distance.ts';
import { buildPreintegrationTable, preintegrationTableSize } from '../../../optics/transfer/preintegration-table.ts';
import type { PreintegrationTable } from '../../../optics/transfer/preintegration-table.ts';
import { largestOpacity } from '../../../optics/transfer/transfer-function.ts';
import { usualColumns } from '../../../optics/transfer/usual-columns.ts';
import { finestSpacing } from '../../../volume/grid.ts';
import type { Gl } from '../../device/device.ts';
import { joinInputs } from '../../device/inputs.ts';
import type { ProgramInputs, Uniforms } from '../../device/inputs.ts';
import { Kept } from '../../device/kept.ts';
import { uploadTable } from '../../textures/table-textures.ts';
import type { TextureUnit } from '../../device/texture-unit.ts';
import type { RayFrame, RayModule, RayText } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';
import { substepPart } from '../substep-provider.ts';

/** Means over spans of values: its chunks define `vec4 meanOfSamples(Sample from, Sample to)` and `vec4 emissionAt(float share)`. */
export interface Means extends Omit<RayText, 'stage' | 'members'> {
  inputs(frame: RayFrame): ProgramInputs;
  dispose(): void;
}

/** The classify stage. */
export function classifyText({
  name,
  defines,
  chunks,
  samplers,
}: Pick<Means, 'name' | 'defines' | 'chunks' | 'samplers'>): RayText {
  return {
    name,
    stage: 'classify',
    defines,
    chunks: [transferFunctionChunk, ...chunks, classify],
    samplers,
  };
}

/** The uniforms of classification, in addition to its tables. */
export function opticalUniforms({
  optics: { transferFunction, opacityFactor, referenceLength },
  rays,
  maxSubsteps,
}: RayFrame): Uniforms {
  return {
    uOpticalScale: Math.min(largestFactor, (rays.diameter / referenceLength) * opacityFactor),
    uLargestOpacity: largestOpacity(transferFunction),
    uMaxSubsteps: maxSubsteps,
  };
}

/** Factors stay below this, so that the shader's products don't overflow. */
const largestFactor = 1e30;

export const classifyTwin = twinOf(usualTwins, ({ classifyPicture }, { volume, optics, rays }, { field }) => ({
  classify: classifyPicture(optics, volume.finer?.grid ?? volume.grid, rays.diameter, field),
}));

/** The transfer function gives colour and opacity: with pre-integration, and with substeps where a step may show much. */
export function createClassify(gl: Gl, means: Means): RayModule<'classify'> {
  const substeps = new Kept<TextureUnit>();
  const contribution = new Kept<Contribution>();
  return {
    ...classifyText(means),
    stage: 'classify',
    sparesRays: true,
    twin: classifyTwin,
    order: 2,
    contributes: ({ transferFunction }) => contribution.get([transferFunction], () => contributionOf(transferFunction)),
    inputs(frame: RayFrame) {
      const { volume, optics } = frame;
      const { transferFunction, lightFactor, opacityFactor, referenceLength } = optics;
      // The shader does not read the table if only cells cut steps.
      if (frame.maxSubsteps <= 1)
        return joinInputs(means.inputs(frame), { uniforms: opticalUniforms(frame), units: [] });
      const voxelRatio = (finestSpacing(volume.finer?.grid ?? volume.grid) / referenceLength) * opacityFactor;
      const unit = substeps.get([transferFunction, lightFactor, voxelRatio], (last) =>
        substepPart().makeTable(gl, brighten(transferFunction, lightFactor), voxelRatio, last?.texture ?? null),
      );
      return joinInputs(means.inputs(frame), { uniforms: opticalUniforms(frame), units: [unit] });
    },
    dispose() {
      means.dispose();
      gl.deleteTexture(substeps.last?.texture ?? null);
    },
  };
}

const tableText = { name: 'transferFunction', defines: {}, chunks: [spanTable], samplers: ['uTransferFunction'] };

export const transferFunctionText = classifyText(tableText);

/**
 * For transfer functions that the pre-integration table represents well, on devices that filter floats: one fetch for each segment.
 * @param columns - the number of the table's columns, see optics/transfer/table-columns.ts
 */
export function createTransferFunction(gl: Gl, columns = usualColumns): RayModule<'classify'> {
  const tables = new Kept<ProgramInputs>();
  return createClassify(gl, {
    ...tableText,
    inputs: ({ optics: { transferFunction, lightFactor } }) =>
      tables.get([transferFunction, lightFactor], (last) => {
        const table = buildPreintegrationTable(brighten(transferFunction, lightFactor), {
          columns,
          rows: preintegrationTableSize.rows,
        });
        return { uniforms: tableUniforms(table), units: [uploadTable(gl, table, last?.units[0].texture ?? null)] };
      }),
    dispose: () => gl.deleteTexture(tables.last?.units[0].texture ?? null),
  });
}

/** The uniforms that describe the table; its texels are in a texture. */
export function tableUniforms({ columns, rows, first, last }: PreintegrationTable): ProgramInputs['uniforms'] {
  return { uTableSize: [columns, rows], uTableFirst: first, uTableLast: last };
}
