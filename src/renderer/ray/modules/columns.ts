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

/** Rounds of the search among columns if bins can't separate them: 2 to this power is more than the possible number of columns. */
const maxSearches = 18;

/** Finds each sample's column, and its place in it. @param bins - whether the shader finds columns by bins, else by search */
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

/** Computes means over a segment from the columns of its two samples. */
export const columnMeansText: Pick<Means, 'name' | 'defines' | 'chunks' | 'samplers'> = {
  name: 'columnMeans',
  defines: {},
  chunks: [columnMeans],
  samplers: [],
};

/**
 * Any transfer function with the precision of float32: jumps, narrow pieces, and stops at any place.
 * @returns `modulesFor`, which makes the two modules: the columns of samples, and the colours of segments
 */
export function createColumns(gl: Gl): {
  readonly modulesFor: (frame: ColumnsFrame) => readonly RayModule[];
  readonly dispose: () => void;
} {
  const { get, dispose } = keepColumns(gl);
  const classify = createClassify(gl, {
    ...columnMeansText,
    inputs: () => ({ uniforms: {}, units: [] }),
    dispose: () => {},
  });
  const column: Omit<RayModule, keyof RayText> = {
    sparesRays: true,
    order: 2,
    inputs: (frame) => get(frame).inputs,
    twin: null,
  };
  return {
    modulesFor: (frame) => [
      ...fetchEach(gl, frame.field),
      { ...columnsText(get(frame).hasBins), ...column, stage: 'field' },
      classify,
    ],
    dispose() {
      dispose();
      classify.dispose?.();
    },
  };
}

/** Fetches each voxel of a mosaic: the device's filter may mix in a little of the neighbouring tile, which is visible next to a jump. */
export function fetchEach(gl: Gl, field: FieldModule): readonly RayModule[] {
  const { TEXTURE_3D, TWO_BYTES, NO_DATA, FILTER_IN_SHADER, WEIGHED } = field.defines;
  if (TEXTURE_3D !== 0 || FILTER_IN_SHADER !== 0) return [];
  const inputs = (): ProgramInputs => {
    const { uniforms, units } = field.inputs();
    return { uniforms, units: units.map((unit) => ({ ...unit, minFilter: gl.NEAREST, magFilter: gl.NEAREST })) };
  };
  const text = WEIGHED
    ? { ...field, defines: { ...field.defines, FILTER_IN_SHADER: 1 } }
    : cartesianText({ texture3d: false, twoBytes: TWO_BYTES === 1, noData: NO_DATA === 1, filterInShader: true });
  return [{ ...field, ...text, stage: 'field', inputs }];
}
