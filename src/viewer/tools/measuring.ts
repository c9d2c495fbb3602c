// What <volume-measure> measures in a volume. Points are in world units; for a radar in metres, without the exaggeration of
// heights, as in `region`.
import { stretchOf } from '../../radar/polar-geometry.ts';
import { edgesOfGate, sumUpGates } from '../../radar/gates-inside.ts';
import { invalidAttribute } from '../../core/errors.ts';
import { longest } from '../../volume/grid-limits.ts';
import { length, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import {
  measureAngle,
  measureBox,
  measureDistance,
  measureSphere,
  measureTypes,
  pointCounts,
} from '../../volume/measures.ts';
import type { EdgesAt, Measured, MeasureType } from '../../volume/measures.ts';
import { solidOf } from '../../volume/solid.ts';
import type { Statistics } from '../../volume/statistics.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { sumUpVoxels } from '../../volume/voxels-inside.ts';
import { isNumber, split } from '../model/parse-attributes.ts';
import { isInMillimetres } from '../../volume/world-axes.ts';

export { pointCounts } from '../../volume/measures.ts';
export type { MeasureType } from '../../volume/measures.ts';

/** The result of a measurement: plain data. */
export interface MeasureResult {
  readonly type: MeasureType;
  readonly points: readonly Vector3[];
  /** Unit of lengths: `mm` for medical files, `m` for a radar, '' where it is not known. Volumes use its cube. */
  readonly lengthUnit: 'mm' | 'm' | '';
  /** A length, degrees, or a volume. */
  readonly value: number;
  /** Twice its standard uncertainty, from the size of the voxels or gates at its points. */
  readonly uncertainty: number;
  /** For a box the lengths of its edges, for a sphere its radius. */
  readonly lengths: readonly number[];
  /**
   * Statistics of the values inside a box or a sphere, in the volume's unit; null for other measures, and while the values are
   * summed up.
   */
  readonly statistics: Statistics | null;
  /** Unit of the values, or ''. */
  readonly unit: string;
}

/** @throws {VolumeViewError} `attribute/invalid` */
export function readMeasureType(text: string | null): MeasureType {
  const found = measureTypes.find((one) => one === (text?.trim().toLowerCase() || 'distance'));
  if (!found) throw invalidAttribute('type of <volume-measure>', text!, measureTypes.join(', '));
  return found;
}

const examples = {
  distance: '10 0 5, 40 0 5',
  angle: '10 0 5, 40 0 5, 40 30 5',
  box: '-10 -10 0, 20 15 30',
  sphere: '10 0 5, 10 12 5',
};

/** @returns null where none are given @throws {VolumeViewError} `attribute/invalid` */
export function readMeasurePoints(text: string | null, type: MeasureType): readonly Vector3[] | null {
  if (text === null || text.trim() === '') return null;
  const name = `points of <volume-measure type="${type}">`;
  const words = split(name, text);
  const numbers = words.map(Number);
  if (words.length !== 3 * pointCounts[type] || !words.every(isNumber) || numbers.some((n) => Math.abs(n) > longest)) {
    throw invalidAttribute(name, text, `${pointCounts[type]} places, three numbers each, like "${examples[type]}"`);
  }
  return Array.from({ length: pointCounts[type] }, (_, i) => numbers.slice(3 * i, 3 * i + 3) as unknown as Vector3);
}

function lengthUnitOf(volume: Volume): 'mm' | 'm' | '' {
  if (volume.grid.kind === 'polar') return 'm';
  return isInMillimetres(volume) ? 'mm' : '';
}

const measures = {
  distance: measureDistance,
  angle: measureAngle,
  box: measureBox,
  sphere: measureSphere,
} satisfies Record<MeasureType, (points: readonly Vector3[], edgesAt: EdgesAt) => Measured>;

/** What can be measured at once: everything except the statistics. */
export function measure(volume: Volume, type: MeasureType, points: readonly Vector3[]): MeasureResult {
  const edgesAt: EdgesAt = isPolar(volume) ? (place) => edgesOfGate(volume, place) : () => edgesOfVoxel(volume);
  const [from, to] = points;
  const lengths =
    type === 'box' ? subtract(to, from).map(Math.abs) : type === 'sphere' ? [length(subtract(to, from))] : [];
  return {
    type,
    points,
    lengthUnit: lengthUnitOf(volume),
    ...measures[type](points, edgesAt),
    lengths,
    statistics: null,
    unit: volume.unit,
  };
}

function edgesOfVoxel({ grid: { indexToWorld: m } }: Volume): readonly Vector3[] {
  return [0, 1, 2].map((c): Vector3 => [m[c], m[4 + c], m[8 + c]]);
}

/** Sum up the values inside; null for a measure without an inside. */
export function sumUp(
  volume: Volume,
  type: MeasureType,
  points: readonly Vector3[],
): Generator<void, Statistics> | null {
  if (type !== 'box' && type !== 'sphere') return null;
  const solid = solidOf(type, points);
  const { grid } = volume;
  if (isPolar(volume)) return sumUpGates(volume, solid);
  return grid.kind === 'cartesian' ? sumUpVoxels({ ...volume, grid }, solid) : null;
}

/** Convert a point to the world as it is drawn. */
export function toDrawn([x, y, z]: Vector3, { grid }: Pick<Volume, 'grid'>): Vector3 {
  return [x, y, z * stretchOf(grid)];
}

/** Convert a point from the world as it is drawn. */
export function fromDrawn([x, y, z]: Vector3, { grid }: Pick<Volume, 'grid'>): Vector3 {
  return [x, y, z / stretchOf(grid)];
}
