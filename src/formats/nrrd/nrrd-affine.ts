import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { millimetresOf } from '../base/length-units.ts';
import { completeAxes } from '../grid-files/complete-axes.ts';
import { quoted, readVector, splitVectors } from './nrrd-axes.ts';
import type { NrrdAxis } from './nrrd-axes.ts';
import { what } from './nrrd-header.ts';
import type { NrrdFields } from './nrrd-header.ts';

/**
 * Signs that convert a space's x and y to ours, x to the right and y to the front. Spaces that give no direction are
 * treated as LPS, as in ITK.
 */
const spaces = new Map<string, readonly [number, number]>([
  ['ras', [1, 1]],
  ['rast', [1, 1]],
  ['rightanteriorsuperior', [1, 1]],
  ['rightanteriorsuperiortime', [1, 1]],
  ['las', [-1, 1]],
  ['last', [-1, 1]],
  ['leftanteriorsuperior', [-1, 1]],
  ['leftanteriorsuperiortime', [-1, 1]],
]);

/** Whether the header says that its space is a patient's. */
export function isAnatomical(fields: NrrdFields): boolean {
  return /^((right|left)(anterior|posterior)superior|[rl][ap]s)(t|time)?$/.test(nameSpace(fields));
}

const nameSpace = (fields: NrrdFields): string => (fields.get('space') ?? '').toLowerCase().replace(/[-\s]/g, '');

/**
 * Voxel index to world (RAS, mm). A sample lies at the centre of its cell, whatever `centers` says: `space origin` is
 * the position of the first sample.
 */
export function readAffine(fields: NrrdFields, axes: readonly NrrdAxis[]): Matrix4 {
  const [x, y] = spaces.get(nameSpace(fields)) ?? [-1, -1];
  const units = quoted(fields.get('spaceunits') ?? '').map(millimetresPer);
  const toWorld = (v: Vector3): Vector3 => [
    x * v[0] * (units[0] ?? 1),
    y * v[1] * (units[1] ?? 1),
    v[2] * (units[2] ?? 1),
  ];
  const steps = axes.map((axis, i) => toWorld(stepOf(axis, i)));
  const [origin] = splitVectors(fields.get('spaceorigin') ?? '');
  return completeAxes(
    what,
    steps,
    toWorld(origin === undefined || /^none$/i.test(origin) ? firstOf(axes) : readVector(origin)),
  );
}

function stepOf({ direction, spacing, unit }: NrrdAxis, axis: number): Vector3 {
  if (direction && direction !== 'none') return direction;
  const length = spacing * millimetresPer(unit);
  return [axis === 0 ? length : 0, axis === 1 ? length : 0, axis === 2 ? length : 0];
}

/** The position of the first sample, from the ranges of axes that have no direction. */
function firstOf(axes: readonly NrrdAxis[]): Vector3 {
  const [x = 0, y = 0, z = 0] = axes.map(({ direction, first, unit }) =>
    direction ? 0 : first * millimetresPer(unit),
  );
  return [x, y, z];
}

/** Millimetres in a unit of length, in upper or lower case; 1 if the unit is unknown. */
const millimetresPer = (unit: string): number => millimetresOf(unit.toLowerCase()) ?? 1;
