import { brighten } from '../../../optics/transfer/brighten.ts';
import { binColumns } from '../../../optics/transfer/column-bins.ts';
import type { ColumnBins } from '../../../optics/transfer/column-bins.ts';
import { cutColumns } from '../../../optics/transfer/columns.ts';
import type { Columns } from '../../../optics/transfer/columns.ts';
import { mapShares } from '../../../optics/transfer/share-map.ts';
import { placeThreshold } from '../../../optics/transfer/threshold.ts';
import type { TransferFunction } from '../../../optics/transfer/transfer-function.ts';
import { isWebGl2 } from '../../device/device.ts';
import type { Gl } from '../../device/device.ts';
import { prepareUpload } from '../../textures/fill-texture.ts';
import type { ProgramInputs } from '../../device/inputs.ts';
import { Kept } from '../../device/kept.ts';
import { textureUnit } from '../../device/texture-unit.ts';
import type { TextureUnit } from '../../device/texture-unit.ts';
import type { RayFrame } from '../ray-module.ts';

/** Bins in a row of their texture. */
const binsAcross = 512;

/** The maximum columns in a row of the columns' texture: every device allows this width. Label volumes have tens of thousands of columns. */
const maxAcross = 2048;

/** Texture rows for the columns of a function: see shaders/chunks/classify/columns.glsl. */
const columnRows = 7;

/** The data that columns depend on. */
export interface ColumnsFrame extends Pick<RayFrame, 'volume' | 'field' | 'optics' | 'domain'> {
  /** Transfer functions in addition to that of the optics; the domain includes theirs. */
  readonly functions?: readonly TransferFunction[];
}

/** Columns on the GPU. */
export interface ColumnTables {
  /** How the shader finds a column: true: by bins; false: by search. */
  readonly hasBins: boolean;
  readonly inputs: ProgramInputs;
}

/** Keeps the columns of transfer functions on the GPU. @param room - the number of functions that the textures hold, one below another */
export function keepColumns(
  gl: Gl,
  room = 1,
): { readonly get: (frame: ColumnsFrame) => ColumnTables; readonly dispose: () => void } {
  const made = new Kept<ColumnTables>();
  const make = (frame: ColumnsFrame, last: ColumnTables | null): ColumnTables => {
    const {
      volume: { slope, intercept, range, samples },
      field: { storedScale },
    } = frame;
    const values = { slope, intercept, range, storedScale, whole: !(samples instanceof Float32Array) };
    const map = mapShares(values, clip(frame.domain, range));
    const { transferFunction, lightFactor } = frame.optics;
    const all = [transferFunction, ...(frame.functions ?? [])].map((one) =>
      cutColumns(brighten(one, lightFactor), (value) => placeThreshold(values, map, value)),
    );
    const bins = binAll(all);
    const { uniforms, units } = upload(gl, { all, bins, room }, last?.inputs.units ?? []);
    return {
      hasBins: bins !== null,
      inputs: { uniforms: { ...uniforms, uColumnDomain: [map.scale, map.from] }, units },
    };
  };
  return {
    get: (frame) => {
      const {
        volume,
        optics: { transferFunction, lightFactor },
        field,
        domain,
        functions = [],
      } = frame;
      const key = [
        transferFunction,
        ...functions,
        lightFactor,
        volume.slope,
        volume.intercept,
        ...volume.range,
        field.storedScale,
        volume.samples.constructor,
        ...domain,
      ];
      return made.get(key, (last) => make(frame, last));
    },
    dispose() {
      for (const { texture } of made.last?.inputs.units ?? []) gl.deleteTexture(texture);
    },
  };
}

/** The same number of bins for each function; null if a function has edges that are too near to each other. */
function binAll(all: readonly Columns[]): readonly ColumnBins[] | null {
  const each = all.map(({ edges }) => binColumns(edges));
  const count = Math.max(...each.map((bins) => bins?.count ?? Infinity));
  return count === Infinity ? null : all.map(({ edges }) => binColumns(edges, count)!);
}

/** The part of a domain that is in the data: floats distinguish values best near its low end, and if it is narrow. */
function clip(
  [low, high]: readonly [number, number],
  [min, max]: readonly [number, number],
): readonly [number, number] {
  const [from, to] = [Math.max(low, Math.min(min, high)), Math.min(high, Math.max(max, low))];
  return to > from ? [from, to] : [low, high];
}

interface Tables {
  readonly all: readonly Columns[];
  readonly bins: readonly ColumnBins[] | null;
  readonly room: number;
}

function upload(gl: Gl, { all, bins, room }: Tables, previous: readonly TextureUnit[]): ProgramInputs {
  const count = Math.max(...all.map(({ edges }) => edges.length - 1));
  const across = Math.min(maxAcross, count);
  const lines = Math.ceil(count / across);
  const uColumnTexels = [count, across, 1 / across, lines];
  const fill = (samplerName: string, parts: readonly Float32Array[], width: number, height: number): TextureUnit => {
    const texture = previous.find((unit) => unit.samplerName === samplerName)?.texture ?? gl.createTexture();
    const texels = new Float32Array(4 * width * height * room);
    parts.forEach((part, i) => texels.set(part, 4 * width * height * i));
    gl.bindTexture(gl.TEXTURE_2D, texture);
    prepareUpload(gl);
    gl.texImage2D(
      gl.TEXTURE_2D,
      0,
      isWebGl2(gl) ? gl.RGBA32F : gl.RGBA,
      width,
      height * room,
      0,
      gl.RGBA,
      gl.FLOAT,
      texels,
    );
    return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName });
  };
  const units = [
    fill(
      'uColumns',
      all.map((columns) => packColumns(columns, across * lines)),
      across,
      columnRows * lines,
    ),
  ];
  if (!bins) {
    gl.deleteTexture(previous.find(({ samplerName }) => samplerName === 'uColumnBins')?.texture ?? null);
    return { uniforms: { uColumnTexels }, units };
  }
  const [{ count: binCount }] = bins;
  const [width, height] = [Math.min(binsAcross, binCount), Math.max(1, binCount / binsAcross)];
  return {
    uniforms: { uColumnTexels, uBinTexels: [binCount, width, 1 / width, 1 / (height * room)] },
    units: [
      ...units,
      fill(
        'uColumnBins',
        bins.map(({ texels }) => texels),
        width,
        height,
      ),
    ],
  };
}

/**
 * Rows of a texture, each of `across` columns. A sum is stored as two floats, which together have all digits. If a function has fewer
 * columns than another, no value falls into its unused columns.
 */
function packColumns({ edges, starts, ends, sumsAtStart, sumsAtEnd }: Columns, across: number): Float32Array {
  const row = 4 * across;
  const texels = new Float32Array(row * columnRows);
  texels.set(starts, 0);
  texels.set(ends, row);
  [sumsAtStart, sumsAtEnd].forEach((sums, i) => {
    const high = Float32Array.from(sums);
    texels.set(high, (2 + 2 * i) * row);
    texels.set(
      sums.map((sum, at) => sum - high[at]),
      (3 + 2 * i) * row,
    );
  });
  for (let k = 0; k < across; k++)
    texels.set([edges[k] ?? edges[edges.length - 1], edges[k + 1] ?? 0], 6 * row + 4 * k);
  return texels;
}
