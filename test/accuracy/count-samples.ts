// In float64: how many samples of a picture at rest have to be taken so that its error is kept and nothing small is lost.
import { contributionOf } from '../../src/optics/cells/empty-space-distance.ts';
import { findDetail, readCode } from '../../src/optics/cells/cell-detail.ts';
import type { SeenVolume } from '../../src/optics/cells/cell-detail.ts';
import { findSeenCells } from '../../src/optics/cells/seen-cells.ts';
import { cartesianField } from '../../src/optics/rays/ray-field.ts';
import { crossVolume, rayThrough, setUpRays } from '../../src/optics/rays/rays.ts';
import type { Ray } from '../../src/optics/rays/rays.ts';
import { attenuate, composite } from '../../src/optics/rays/segment.ts';
import { exactMeans } from '../../src/optics/transfer/exact-means.ts';
import type { Premultiplied, TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { finestSpacing } from '../../src/volume/grid.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Matrix4, Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { ErrorSum } from '../helpers/covered-error.ts';

/** Rays along each side. */
const side = 48;

/** Samples of the truth, for each voxel. */
const trueSamples = 8;

/** Lengths of steps, in samples of the truth, the longest first: from eight voxels on. */
const lengths = [64, 32, 16, 8, 4, 2, 1] as const;

/** A ray ends where less of the light is left, as in the shader. */
const lastLight = 0.25 / 255;

/** A step may be off by so much, 1/255: with each a whole picture is made. */
const tried: readonly number[] = Array.from({ length: 14 }, (_, i) => 2 ** (i - 7));

/** Steps are cut for so many times `max-error`, see quality/levels.ts; from this error on they may be longer than a voxel. */
const [lostPerError, longFrom] = [10, 2];

/** A pixel may be off by so many times `max-error`: of a thing that stands out by eight, a quarter has to be left. */
const mostPerError = 6;

/** Voxels along each edge of the cells, as volumes have them that are large and that are not. */
const [largeCell, smallCell] = [8, 4];

/** Where less light is left, more may be lost: in this many halves of it. */
const halves = 10;

export interface SamplesResult {
  readonly name: string;
  readonly maxError: number;
  /** Samples as a share of one for each voxel in which something may be visible, up to the end of the ray: by the bounds of cells of eight voxels along each edge, as `detail="keep"` has them in a large volume. */
  readonly byLargeCells: number;
  /** The same, where bounds count for the light that is left. */
  readonly byLargeCellsAndLight: number;
  /** The same, by the bounds of cells of four voxels along each edge, and with the light that is left, too. */
  readonly bySmallCells: number;
  readonly bySmallCellsAndLight: number;
  /** About as few as can be: found with the truth at hand, steps from the eye on as long as each may be. null where none of the pictures that were tried is good enough. */
  readonly needed: number | null;
}

/** What a ray meets, by many samples a voxel, up to its end. */
interface Walk {
  /** At each sample. */
  readonly values: Float64Array;
  /** Light and opacity gathered up to each sample: four numbers each. */
  readonly gathered: Float64Array;
  /** The large cell of each voxel's step; -1 where nothing is visible. */
  readonly largeCells: readonly number[];
  /** The same of small cells. */
  readonly smallCells: readonly number[];
}

export interface CountedView {
  readonly name: string;
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  readonly referenceLength: number;
  readonly view: Matrix4;
  readonly projection: Matrix4;
}

export function countSamples(shown: CountedView, errors: readonly number[]): SamplesResult[] {
  const { name, volume, transferFunction, referenceLength } = shown;
  const [seenLarge, seenSmall] = [largeCell, smallCell].map((size): SeenVolume => {
    const macrocells = buildMacrocells(volume.samples, volume.grid.dimensions, size);
    return {
      volume: { ...volume, macrocells },
      cells: findSeenCells(macrocells, [contributionOf(transferFunction)], volume),
      transferFunction,
      opticalScale: 1 / referenceLength,
    };
  });
  const { walks, attenuateSpan } = walkRays(shown, seenLarge, seenSmall);
  const all = walks.reduce((sum, walk) => sum + countBy(walk, 'largeCells', () => 1), 0);
  const pictures = tried.map((allowed) => takeFewest(walks, attenuateSpan, allowed));
  return errors.map((maxError) => {
    const codesOf = (of: SeenVolume): Uint8Array[] =>
      Array.from({ length: halves + 1 }, (_, i) =>
        findDetail(of, Math.min(1, (2 ** i * lostPerError * maxError) / 255), maxError >= longFrom),
      );
    const count = (kind: CellKind, codes: readonly Uint8Array[]): { all: number; byLight: number } => {
      const by = (choose: (light: number) => Uint8Array): number =>
        walks.reduce((sum, walk) => sum + countBy(walk, kind, (cell, light) => samplesOf(choose(light)[cell])), 0) /
        all;
      return {
        all: by(() => codes[0]),
        byLight: by((light) => codes[Math.min(halves, Math.max(0, Math.floor(-Math.log2(light))))]),
      };
    };
    const large = count('largeCells', codesOf(seenLarge));
    const small = count('smallCells', codesOf(seenSmall));
    const kept = pictures.filter(({ e, max }) => e <= maxError && max <= mostPerError * maxError);
    return {
      name,
      maxError,
      byLargeCells: large.all,
      byLargeCellsAndLight: large.byLight,
      bySmallCells: small.all,
      bySmallCellsAndLight: small.byLight,
      needed: kept.length > 0 ? Math.min(...kept.map(({ samples }) => samples)) / all : null,
    };
  });
}

function samplesOf(code: number): number {
  const { samples, longer } = readCode(code);
  return samples / longer;
}

/** Light left at a sample. */
const lightAt = ({ gathered }: Walk, sample: number): number => 1 - gathered[4 * sample + 3];

type CellKind = 'largeCells' | 'smallCells';

function countBy(walk: Walk, kind: CellKind, samples: (cell: number, light: number) => number): number {
  return walk[kind].reduce(
    (sum, cell, step) => sum + (cell < 0 ? 0 : samples(cell, lightAt(walk, step * trueSamples))),
    0,
  );
}

type Span = (from: number, to: number, voxels: number) => Premultiplied;

function walkRays(
  { volume, transferFunction, referenceLength, view, projection }: CountedView,
  seenLarge: SeenVolume,
  seenSmall: SeenVolume,
): { walks: Walk[]; attenuateSpan: Span } {
  const { grid } = volume;
  const setup = setUpRays(grid, view, projection)!;
  const field = cartesianField({ ...volume, dimensions: grid.dimensions });
  const means = exactMeans(transferFunction);
  const voxel = finestSpacing(grid);
  const attenuateSpan: Span = (from, to, voxels) => attenuate(means.mean(from, to), (voxels * voxel) / referenceLength);
  const cellAt = (place: Vector3, { volume: { macrocells }, cells }: SeenVolume): number => {
    const at = place.map((x, axis) => {
      const index = Math.min(grid.dimensions[axis] - 1, Math.max(0, x * grid.dimensions[axis] - 0.5));
      return Math.min(macrocells.dimensions[axis] - 1, Math.floor(index / macrocells.size));
    });
    const cell = at[0] + macrocells.dimensions[0] * (at[1] + macrocells.dimensions[1] * at[2]);
    return cells[cell] ? cell : -1;
  };
  const walks: Walk[] = [];
  for (let row = 0; row < side; row++) {
    for (let column = 0; column < side; column++) {
      const ray = rayThrough(setup, ((column + 0.5) / side) * 2 - 1, ((row + 0.5) / side) * 2 - 1);
      const [entry, exit] = crossVolume(setup, ray);
      const begin = Math.max(entry, setup.eyeT);
      const stepT = voxel / setup.diameter / ray.lengthPerT;
      const steps = Math.floor((exit - begin) / stepT);
      if (steps < 1) continue;
      const placeAt = (t: number): Vector3 => placeOn(ray, t);
      const [values, gathered] = [[field.sampleAt(placeAt(begin)).value], [0, 0, 0, 0]];
      const [largeCells, smallCells]: number[][] = [[], []];
      for (let step = 0; step < steps && 1 - gathered[gathered.length - 1] > lastLight; step++) {
        const middle = placeAt(begin + (step + 0.5) * stepT);
        const cell = cellAt(middle, seenLarge);
        largeCells.push(cell);
        smallCells.push(cellAt(middle, seenSmall));
        for (let i = 1; i <= trueSamples; i++) {
          const { value } = field.sampleAt(placeAt(begin + (step + i / trueSamples) * stepT));
          const sum = gathered.slice(-4) as Premultiplied;
          if (cell >= 0) composite(sum, attenuateSpan(values[values.length - 1], value, 1 / trueSamples));
          values.push(value);
          gathered.push(...sum);
        }
      }
      walks.push({ values: Float64Array.from(values), gathered: Float64Array.from(gathered), largeCells, smallCells });
    }
  }
  return { walks, attenuateSpan };
}

function placeOn({ point, direction }: Ray, t: number): Vector3 {
  return point.map((x, axis) => x + t * direction[axis]) as unknown as Vector3;
}

/** A picture with steps as long as each may be without being off by more than is allowed. */
function takeFewest(
  walks: readonly Walk[],
  attenuateSpan: Span,
  allowed: number,
): { samples: number; e: number; max: number } {
  const errors = new ErrorSum(4);
  let samples = 0;
  for (const walk of walks) {
    const { values, gathered, largeCells: cells } = walk;
    const last = cells.length * trueSamples;
    const shown: Premultiplied = [0, 0, 0, 0];
    for (let from = 0; from < last;) {
      if (cells[Math.floor(from / trueSamples)] < 0) {
        from = (Math.floor(from / trueSamples) + 1) * trueSamples;
        continue;
      }
      const light = lightAt(walk, from);
      const seenOf = (length: number): Premultiplied =>
        attenuateSpan(values[from], values[from + length], length / trueSamples);
      const offBy = (length: number): number =>
        Math.max(
          ...seenOf(length).map((x, c) =>
            Math.abs(light * x - (gathered[4 * (from + length) + c] - gathered[4 * from + c])),
          ),
        );
      const length = lengths.find((one) => from + one <= last && (one === 1 || 255 * offBy(one) <= allowed))!;
      composite(shown, seenOf(length));
      samples++;
      from += length;
    }
    const full = gathered.slice(-4);
    const off = shown.map((x, c) => 255 * Math.abs(x - full[c]));
    if (full[3] > 0.5 / 255 || shown[3] > 0.5 / 255)
      errors.add({ max: Math.max(...off), squares: off.reduce((sum, x) => sum + x * x, 0) });
  }
  const { e, max } = errors.result();
  return { samples, e, max };
}
