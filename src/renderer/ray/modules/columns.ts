import columnMeans from '../../../../shaders/chunks/classify/column-means.glsl?raw';
import columnBins from '../../../../shaders/chunks/classify/column-bins.glsl?raw';
import columnSamples from '../../../../shaders/chunks/classify/column-samples.glsl?raw';
import columnSearch from '../../../../shaders/chunks/classify/column-search.glsl?raw';
import columnsChunk from '../../../../shaders/chunks/classify/columns.glsl?raw';
import type { Gl } from '../../device/device.ts';
import type { ProgramInputs } from '../../device/inputs.ts';
import type { FieldModule, RayModule, RayText } from '../ray-module.ts';
import { cartesianText } from './cartesian-field.ts';
import { keepColumns } from './column-tables.ts';
import type { ColumnsFrame } from './column-tables.ts';
import { createClassify } from './transfer-function.ts';
import type { Means } from './transfer-function.ts';

/** Rounds of the search among columns where bins can't tell them apart: two to this power are more than there can be. */
const maxSearches = 18;

/** What is known of each sample. @param bins - columns are found by bins, else by search */
export function columnsText(bins: boolean): RayText {
  return {
    name: 'columns',
    stage: 'field',
    defines: { COLUMN_BINS: Number(bins), MAX_SEARCHES: maxSearches },
    chunks: [columnsChunk, bins ? columnBins : columnSearch, columnSamples],
    samplers: ['uColumns', ...(bins ? ['uColumnBins'] : [])],
    members: ['float stored', 'float place', 'float column', 'vec4 emission', 'vec4 sum', 'vec4 sumRest'],
  };
}

/** How means are made of it. */
export const columnMeansText: Pick<Means, 'name' | 'defines' | 'chunks' | 'samplers'> = { name: 'columnMeans', defines: {}, chunks: [columnMeans], samplers: [] };

/**
 * Any transfer function, as exact as float32 is: jumps, narrow pieces, stops wherever they are.
 * @returns the modules that take part for it: what is known of samples, and what segments show
 */
export function createColumns(gl: Gl): { readonly modulesFor: (frame: ColumnsFrame) => readonly RayModule[]; readonly dispose: () => void } {
  const { get, dispose } = keepColumns(gl);
  const classify = createClassify(gl, { ...columnMeansText, inputs: () => ({ uniforms: {}, units: [] }), dispose: () => {} });
  const column: Omit<RayModule, keyof RayText> = { sparesRays: true, order: 2, inputs: (frame) => get(frame).inputs, twin: null };
  return {
    modulesFor: (frame) => [...fetchEach(gl, frame.field), { ...columnsText(get(frame).hasBins), ...column, stage: 'field' }, classify],
    dispose() {
      dispose();
      classify.dispose?.();
    },
  };
}

/** Fetches each voxel of a mosaic: the device's filter may reach a little into the tile beside, and beside a jump that shows. */
export function fetchEach(gl: Gl, field: FieldModule): readonly RayModule[] {
  const { TEXTURE_3D, TWO_BYTES, NO_DATA, FILTER_IN_SHADER } = field.defines;
  if (TEXTURE_3D !== 0 || FILTER_IN_SHADER !== 0) return [];
  const inputs = (): ProgramInputs => {
    const { uniforms, units } = field.inputs();
    return { uniforms, units: units.map((unit) => ({ ...unit, minFilter: gl.NEAREST, magFilter: gl.NEAREST })) };
  };
  return [{ ...field, ...cartesianText({ texture3d: false, twoBytes: TWO_BYTES === 1, noData: NO_DATA === 1, filterInShader: true }), stage: 'field', inputs }];
}
