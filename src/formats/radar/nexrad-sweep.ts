import { isoTime } from './cf-time.ts';
import { corruptRadial } from './nexrad-radial.ts';
import type { NexradGates, NexradRadial } from './nexrad-radial.ts';
import type { RadarSweep, SweepData, SweepGates } from './radar-file.ts';
import { refuseSweep } from './radar-limits.ts';

/** Smaller codes are not values: 0 is below the threshold, 1 is range folded. */
const firstValid = 2;

/** CFP has no negative values; its lower codes say which filter was used. */
const firstValidOf: Readonly<Record<string, number>> = { CFP: 8 };

/** If a pattern's angle differs from the radials' by more than this, degrees, it belongs to another cut. */
const farthestPlan = 0.7;

/**
 * Makes a sweep of one cut of a volume: radials in the file's order.
 * @param radials - at least one
 * @param planned - elevation of the cut in the volume coverage pattern, degrees
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function makeNexradSweep(radials: readonly NexradRadial[], planned: number | undefined): RadarSweep {
  const moments = [...new Set(radials.flatMap((radial) => [...radial.moments.keys()]))];
  refuseSweep(`the sweep at ${radials[0].elevation.toFixed(1)}°`, radials.length, 1);
  for (const name of moments) checkGrid(radials, name);
  const elevation = radials.reduce((sum, radial) => sum + radial.elevation, 0) / radials.length;
  const time = isoTime(radials[0].time);
  const { nyquist } = radials[0];
  return {
    elevation: planned !== undefined && Math.abs(planned - elevation) < farthestPlan ? planned : elevation,
    azimuths: Float64Array.from(radials, ({ azimuth }) => azimuth % 360),
    elevations: Float64Array.from(radials, (radial) => radial.elevation),
    ...(time ? { time } : {}),
    ...(nyquist === undefined ? {} : { nyquist }),
    moments,
    gridOf: (moment) => (moments.includes(moment) ? gridOf(radials, moment) : null),
    read: (moment) => (moments.includes(moment) ? readGates(radials, moment) : null),
  };
}

/** The radials of a cut may differ only in their number of gates. */
function checkGrid(radials: readonly NexradRadial[], name: string): void {
  const all = radials.flatMap((radial) => radial.moments.get(name) ?? []);
  const [first] = all;
  for (const gates of all) {
    if (!isSameGrid(gates, first)) {
      throw corruptRadial(
        `${describeGrid(gates)} for ${name}`,
        `${describeGrid(first)}, as the first one of its sweep`,
      );
    }
  }
  refuseSweep(
    `${name} of the sweep at ${radials[0].elevation.toFixed(1)}°`,
    radials.length,
    Math.max(1, longestOf(all)),
  );
}

function isSameGrid(a: NexradGates, b: NexradGates): boolean {
  return (
    a.firstGate === b.firstGate &&
    a.gateLength === b.gateLength &&
    a.scale === b.scale &&
    a.offset === b.offset &&
    a.bits === b.bits
  );
}

/** Radials may have different numbers of gates: all are padded to the longest. */
function longestOf(all: readonly (NexradGates | undefined)[]): number {
  return all.reduce((max, gates) => (gates ? Math.max(max, countGates(gates)) : max), 0);
}

function describeGrid({ firstGate, gateLength, scale, offset, bits }: NexradGates): string {
  return `gates of ${bits} bits and ${gateLength} m from ${firstGate} m, scale ${scale}, offset ${offset}`;
}

function countGates({ codes, bits }: NexradGates): number {
  return (8 * codes.byteLength) / bits;
}

function gridOf(radials: readonly NexradRadial[], name: string): SweepGates {
  const all = radials.map((radial) => radial.moments.get(name));
  const { firstGate, gateLength } = all.find((gates) => gates !== undefined)!;
  return { firstGate, gateLength, gates: longestOf(all) };
}

function readGates(radials: readonly NexradRadial[], name: string): SweepData {
  const all = radials.map((radial) => radial.moments.get(name));
  const { scale, offset, bits } = all.find((gates) => gates !== undefined)!;
  const grid = gridOf(radials, name);
  const { gates } = grid;
  const samples = bits === 8 ? new Uint8Array(radials.length * gates) : new Uint16Array(radials.length * gates);
  const lowest = firstValidOf[name] ?? firstValid;
  all.forEach((one, radial) => {
    if (one) copyCodes(one, lowest, samples.subarray(radial * gates, (radial + 1) * gates));
  });
  return { ...grid, samples, slope: 1 / scale, intercept: -offset / scale };
}

function copyCodes({ codes, bits }: NexradGates, lowest: number, to: Uint8Array | Uint16Array): void {
  const count = (8 * codes.byteLength) / bits;
  for (let gate = 0; gate < count; gate++) {
    const code = bits === 8 ? codes.getUint8(gate) : codes.getUint16(2 * gate);
    to[gate] = code < lowest ? 0 : code;
  }
}
