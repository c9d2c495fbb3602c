import { VolumeViewError } from '../../core/errors.ts';
import type { DataArray, DataGroup } from '../base/data-tree.ts';
import { readValues } from './cf-packing.ts';
import { measureRange, metresOf, readRange } from './cfradial-parts.ts';
import type { GatePlace } from './cfradial-parts.ts';
import { corrupt } from './cfradial-problem.ts';

// Where the gates of CfRadial 1 lie: one variable for all radials, one row or two numbers for each radial.

/** Radials of a sweep in the file. */
interface Radials {
  readonly from: number;
  readonly count: number;
}

/** Of a gate: by what share radials of a sweep may begin apart, and their gates be longer, which adds up over a thousand of them. */
const shares = { first: 0.1, length: 1e-3 } as const;

/**
 * Middle of the first gate and gate length of a sweep.
 * @throws {VolumeViewError} `format/corrupt`; `format/unsupported` where its radials differ
 * Source: CfRadial data file format 1.4, 4.4 and 5.4 (`ray_start_range`, `ray_gate_spacing`)
 */
export function readGatePlace(root: DataGroup, radials: Radials): GatePlace {
  const range = root.array('range');
  const own = [root.array('ray_start_range'), root.array('ray_gate_spacing')];
  const of = own.map((array) => (array?.shape.length === 1 ? readValues(array, radials.from, radials.count) : null));
  const [starts, lengths] = of;
  if (starts && lengths && lengths[0] > 0 && Number.isFinite(starts[0])) {
    const scales = own.map((array) => metresOf(array!));
    const places = Array.from(starts, (start, i): GatePlace => {
      return { firstGate: scales[0] * start, gateLength: scales[1] * lengths[i] };
    });
    return settlePlace(places, own[0]!);
  }
  if (!range) throw corrupt('has no variable range');
  if (range.shape.length !== 2) return readRange(range);
  const gates = range.shape[1];
  const numbers = readValues(range, radials.from, radials.count);
  const places = Array.from({ length: radials.count }, (_, i) =>
    measureRange(range, numbers.subarray(i * gates, (i + 1) * gates)),
  );
  return settlePlace(places, range);
}

/** The place of all radials. Those that do not say theirs are where the others are. */
function settlePlace(places: readonly GatePlace[], { path }: DataArray): GatePlace {
  const [first] = places;
  // One that does not say where it lies is not apart.
  const isApart = (key: keyof GatePlace, one: GatePlace, share: number): boolean =>
    Math.abs(one[key] - first[key]) > share * first.gateLength;
  const other = places.find(
    (one) => isApart('firstGate', one, shares.first) || isApart('gateLength', one, shares.length),
  );
  if (!other) return first;
  const [got, expected] = [other, first].map(
    ({ firstGate, gateLength }) => `gates of ${gateLength} m from ${firstGate} m on`,
  );
  throw new VolumeViewError(
    'format/unsupported',
    `${path} got radials of one sweep with ${got} and others with ${expected}; expected one range for all radials of a sweep; resample the file to even gates`,
  );
}
