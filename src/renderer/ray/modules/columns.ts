import columnMeans from '../../../../shaders/chunks/column-means.glsl?raw';
import columnBins from '../../../../shaders/chunks/column-bins.glsl?raw';
import columnSamples from '../../../../shaders/chunks/column-samples.glsl?raw';
import columnSearch from '../../../../shaders/chunks/column-search.glsl?raw';
import columnsChunk from '../../../../shaders/chunks/columns.glsl?raw';
import { brighten } from '../../../optics/brighten.ts';
import { binColumns } from '../../../optics/column-bins.ts';
import type { ColumnBins } from '../../../optics/column-bins.ts';
import { cutColumns } from '../../../optics/columns.ts';
import type { Columns } from '../../../optics/columns.ts';
import { mapShares } from '../../../optics/share-map.ts';
import { placeThreshold } from '../../../optics/threshold.ts';
import { isWebGl2 } from '../../device.ts';
import type { Gl } from '../../device.ts';
import { prepareUpload } from '../../fill-texture.ts';
import type { ProgramInputs } from '../../inputs.ts';
import { Kept } from '../../kept.ts';
import { textureUnit } from '../../texture-unit.ts';
import type { TextureUnit } from '../../texture-unit.ts';
import type { FieldModule, RayFrame, RayModule, RayText } from '../ray-module.ts';
import { cartesianText } from './cartesian-field.ts';
import { createClassify } from './transfer-function.ts';
import type { Means } from './transfer-function.ts';

export { meanOverColumns as twin } from '../../../optics/columns.ts';

/** Bins in a row of their texture. */
const binsAcross = 512;

/** Rounds of the search among columns where bins can't tell them apart: two to this power are more than there can be. */
const maxSearches = 14;

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

interface Made {
  readonly bins: ColumnBins | null;
  readonly inputs: ProgramInputs;
}

/**
 * Any transfer function, as exact as float32 is: jumps, narrow pieces, stops wherever they are.
 * @returns the modules that take part for it: what is known of samples, and what segments show
 */
export function createColumns(gl: Gl): { readonly modulesFor: (frame: ColumnsFrame) => readonly RayModule[]; readonly dispose: () => void } {
  const made = new Kept<Made>();
  const make = (frame: ColumnsFrame, last: Made | null): Made => {
    const { volume: { slope, intercept, range, samples }, field: { storedScale } } = frame;
    const values = { slope, intercept, range, storedScale, whole: !(samples instanceof Float32Array) };
    const map = mapShares(values, clip(frame.domain, range));
    const { transferFunction, lightFactor } = frame.optics;
    const columns = cutColumns(brighten(transferFunction, lightFactor), (value) => placeThreshold(values, map, value));
    const bins = binColumns(columns.edges);
    const { uniforms, units } = upload(gl, columns, bins, last?.inputs.units ?? []);
    return { bins, inputs: { uniforms: { ...uniforms, uColumnDomain: [map.scale, map.from] }, units } };
  };
  const get = (frame: ColumnsFrame): Made => {
    const { volume, optics: { transferFunction, lightFactor }, field, domain } = frame;
    const key = [transferFunction, lightFactor, volume.slope, volume.intercept, ...volume.range, field.storedScale, volume.samples.constructor, ...domain];
    return made.get(key, (last) => make(frame, last));
  };
  const classify = createClassify(gl, { ...columnMeansText, inputs: () => ({ uniforms: {}, units: [] }), dispose: () => {} });
  const column: Omit<RayModule, keyof RayText> = { sparesRays: true, order: 2, inputs: (frame) => get(frame).inputs };
  return {
    modulesFor: (frame) => [...fetchEach(gl, frame.field), { ...columnsText(get(frame).bins !== null), ...column, stage: 'field' }, classify],
    dispose() {
      for (const { texture } of made.last?.inputs.units ?? []) gl.deleteTexture(texture);
      classify.dispose?.();
    },
  };
}

/** Fetches each voxel of a mosaic: the device's filter may reach a little into the tile beside, and beside a jump that shows. */
function fetchEach(gl: Gl, field: FieldModule): readonly RayModule[] {
  const { TEXTURE_3D, TWO_BYTES, NO_DATA, FILTER_IN_SHADER } = field.defines;
  if (TEXTURE_3D !== 0 || FILTER_IN_SHADER !== 0) return [];
  const inputs = (): ProgramInputs => {
    const { uniforms, units } = field.inputs();
    return { uniforms, units: units.map((unit) => ({ ...unit, minFilter: gl.NEAREST, magFilter: gl.NEAREST })) };
  };
  return [{ ...field, ...cartesianText({ texture3d: false, twoBytes: TWO_BYTES === 1, noData: NO_DATA === 1, filterInShader: true }), stage: 'field', inputs }];
}

/** What of a domain is in the data: floats tell values best near its low end, and where it is narrow. */
function clip([low, high]: readonly [number, number], [least, most]: readonly [number, number]): readonly [number, number] {
  const [from, to] = [Math.max(low, Math.min(least, high)), Math.min(high, Math.max(most, low))];
  return to > from ? [from, to] : [low, high];
}

/** What columns depend on. */
export type ColumnsFrame = Pick<RayFrame, 'volume' | 'field' | 'optics' | 'domain'>;

function upload(gl: Gl, columns: Columns, bins: ColumnBins | null, previous: readonly TextureUnit[]): ProgramInputs {
  const across = columns.edges.length - 1;
  const fill = (samplerName: string, texels: Float32Array, width: number, height: number): TextureUnit => {
    const texture = previous.find((unit) => unit.samplerName === samplerName)?.texture ?? gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    prepareUpload(gl);
    gl.texImage2D(gl.TEXTURE_2D, 0, isWebGl2(gl) ? gl.RGBA32F : gl.RGBA, width, height, 0, gl.RGBA, gl.FLOAT, texels);
    return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName });
  };
  const units = [fill('uColumns', packColumns(columns), across, 7)];
  if (!bins) {
    gl.deleteTexture(previous.find(({ samplerName }) => samplerName === 'uColumnBins')?.texture ?? null);
    return { uniforms: { uColumnTexels: [across, 1 / across] }, units };
  }
  const [width, height] = [Math.min(binsAcross, bins.count), Math.max(1, bins.count / binsAcross)];
  return {
    uniforms: { uColumnTexels: [across, 1 / across], uBinTexels: [bins.count, width, 1 / width, 1 / height] },
    units: [...units, fill('uColumnBins', bins.texels, width, height)],
  };
}

/** Rows of a texture: see shaders/chunks/columns.glsl. Sums are of two floats, which together have all digits. */
function packColumns({ edges, starts, ends, sumsAtStart, sumsAtEnd }: Columns): Float32Array {
  const row = starts.length;
  const texels = new Float32Array(row * 7);
  texels.set(starts, 0);
  texels.set(ends, row);
  [sumsAtStart, sumsAtEnd].forEach((sums, i) => {
    const high = Float32Array.from(sums);
    texels.set(high, (2 + 2 * i) * row);
    texels.set(sums.map((sum, at) => sum - high[at]), (3 + 2 * i) * row);
  });
  for (let k = 0; 4 * k < row; k++) texels.set([edges[k], edges[k + 1]], 6 * row + 4 * k);
  return texels;
}
