import { countUpTo, widestGap } from '../../radar/sweep-elevations.ts';
import { nearestOnly } from '../../volume/polar-grid.ts';
import type { Samples } from '../../volume/volume.ts';
import type { Budget } from '../base/budget.ts';
import { takeDuring } from '../base/take-during.ts';
import { allocateLike, emptyOf } from './gate-samples.ts';
import { joinSamples } from './join-samples.ts';
import type { JoinedSamples } from './join-samples.ts';
import type { Mixing } from './moment-kind.ts';
import type { RadarSweep, SweepData, SweepGates } from './radar-file.ts';
import { refuseShown } from './radar-limits.ts';
import { skipRadials } from './skip-radials.ts';

// A range-height scan (RHI) keeps its azimuth and turns in elevation. The grid of a volume has sweeps of about one elevation: the radials of
// all range-height scans at one elevation are such a sweep. Each radial keeps its gates, azimuth and elevation. Where scans have radials at
// different elevations, a sweep also has what is between two radials of a scan, as the picture of this scan alone would have it there.

const what = 'the range-height scans';

/** Maximum bytes of a gate, when it is read. */
const maxBytesPerGate = 4;

/** Radials nearer than this share of a beam see the same air: one of them is enough. */
const nearestShare = 0.2;

/** Maximum number of elevations: more would be refused when they are shown. */
const maxElevations = 500;

/** Scans that are farther apart than this many beams stand alone: nobody has measured what is between them. */
const widestShare = 3;

/** Sweeps that are shown, and what has to be known of them and of the others. */
export interface ArrangedSweeps {
  readonly sweeps: readonly RadarSweep[];
  readonly left: readonly string[];
  readonly details: readonly string[];
}

/** What is the same for all scans. */
export interface RangeHeightSettings {
  /** Degrees. */
  readonly beamWidth: number;
  /** How values of a moment are mixed. */
  mixingOf(moment: string): Mixing;
}

/** A direction, degrees. */
interface Direction {
  readonly azimuth: number;
  readonly elevation: number;
}

/** A radial of a scan. */
interface Beam extends Direction {
  readonly scan: number;
  readonly radial: number;
  /** The next radial of the scan, and how near this place is to it, 0..1; absent where the place is that of a radial. */
  readonly next?: { readonly radial: number; readonly along: number };
}

/** Radials of one elevation, of each side of a scan at most one. */
interface Level {
  readonly elevation: number;
  readonly beams: Beam[];
}

/**
 * The radials of range-height scans, sorted into sweeps. Where an antenna goes on over the zenith, its radials lie on the other side.
 * @param scans - as in the file; each has the elevations of its radials
 * @param budget - of the load: the gates of all scans are kept until the last sweep is read
 * @throws {VolumeViewError} `format/too-large`
 */
export function arrangeRangeHeight(
  scans: readonly RadarSweep[],
  settings: RangeHeightSettings,
  budget: Budget,
): ArrangedSweeps {
  const { beamWidth } = settings;
  const withElevations = scans.filter(({ elevations }) => elevations);
  const kept = chooseRanges(withElevations).map((scan) => skipRadials(scan, scan.transitions ?? []));
  const sides = kept.flatMap((scan, i) => sidesOf(scan, i)).filter((side) => side.length > 0);
  const apart = chooseDistance(sides, beamWidth);
  const thin = sides.map((side) => thinOut(side, apart));
  thin.sort((a, b) => b.length - a.length);
  const levels = sortIntoLevels(thin, apart);
  const drawn = levels.reduce((sum, { beams }) => sum + beams.length, 0);
  refuseShown({ sweeps: levels.length, radials: thin.length, gates: 0 });
  budget.step(levels.length * thin.length, what);
  const levelOf = new Map(levels.flatMap((level) => level.beams.map((beam) => [beam, level] as const)));
  for (const side of thin) fillBetween(side, levels, levelOf, widestGap(beamWidth));
  const read = readOnce(kept, budget);
  const unused = sides.reduce((sum, { length }) => sum + length, 0) - drawn;
  const say = (count: number, words: string): string[] => (count > 0 ? [`${count} ${words}`] : []);
  return {
    sweeps: levels.map((level) => toSweep(level, kept, read, settings)),
    left: [
      ...say(scans.length - withElevations.length, 'range-height scans are left out: they do not say their elevations'),
      ...say(
        withElevations.length - kept.length,
        'range-height scans are left out: their gates lie at other ranges than those of the scan that reaches farthest',
      ),
    ],
    details: [
      `range-height scans: each is drawn as wide as its beam, ${Number(beamWidth.toFixed(2))}°`,
      ...say(unused, 'radials are left out: others of their scan see the same air'),
    ],
  };
}

/** The scans whose gates lie at the ranges of the scan that reaches farthest: those of one sweep have to. */
function chooseRanges(scans: readonly RadarSweep[]): RadarSweep[] {
  const grids = scans.map(({ moments, gridOf }) => (moments.length > 0 ? gridOf(moments[0]) : null));
  const reachOf = (grid: SweepGates | null): number => (grid ? grid.firstGate + grid.gateLength * grid.gates : -1);
  const farthest = grids.reduce((a, b) => (reachOf(b) > reachOf(a) ? b : a), null);
  const isNear = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-3 * farthest!.gateLength;
  return scans.filter((_, i) => {
    const grid = grids[i];
    return grid && isNear(grid.firstGate, farthest!.firstGate) && isNear(grid.gateLength, farthest!.gateLength);
  });
}

/** The beams of a scan on the near side of the zenith, and those beyond, each by ascending elevation. */
function sidesOf({ azimuths, elevations }: RadarSweep, scan: number): Beam[][] {
  const sides: Beam[][] = [[], []];
  elevations!.forEach((elevation, radial) => {
    if (!(elevation >= -90 && elevation <= 180 && Number.isFinite(azimuths[radial]))) return;
    if (elevation <= 90) sides[0].push({ scan, radial, azimuth: azimuths[radial], elevation });
    else sides[1].push({ scan, radial, azimuth: (azimuths[radial] + 180) % 360, elevation: 180 - elevation });
  });
  for (const side of sides) side.sort((a, b) => a.elevation - b.elevation);
  return sides;
}

/** Degrees that elevations have to be apart. */
function chooseDistance(sides: readonly (readonly Beam[])[], beamWidth: number): number {
  const ends = sides.flatMap((side) => [side[0].elevation, side.at(-1)!.elevation]);
  return Math.max(nearestShare * beamWidth, (Math.max(...ends) - Math.min(...ends)) / maxElevations);
}

function thinOut(side: readonly Beam[], apart: number): Beam[] {
  const kept: Beam[] = [];
  for (const beam of side) if (!kept.length || beam.elevation - kept.at(-1)!.elevation >= apart) kept.push(beam);
  return kept;
}

/** @param sides - those with the most radials first: their elevations are those of the levels */
function sortIntoLevels(sides: readonly (readonly Beam[])[], apart: number): Level[] {
  let levels: Level[] = [];
  for (const side of sides) {
    const taken = new Set<Level>();
    const added: Level[] = [];
    for (const beam of side) {
      const nearest = nearestLevel(levels, beam.elevation);
      const distance = nearest < 0 ? Infinity : Math.abs(levels[nearest].elevation - beam.elevation);
      if (distance <= reachOf(levels, nearest, beam.elevation) && !taken.has(levels[nearest])) {
        levels[nearest].beams.push(beam);
        taken.add(levels[nearest]);
      } else if (distance >= apart) added.push({ elevation: beam.elevation, beams: [beam] });
    }
    levels = [...levels, ...added];
    levels.sort((a, b) => a.elevation - b.elevation);
  }
  return levels;
}

/** @returns -1 where there is none */
function nearestLevel(levels: readonly Level[], elevation: number): number {
  const above = countUpTo(levels.length, (i) => levels[i].elevation <= elevation);
  if (above === 0) return levels.length > 0 ? 0 : -1;
  if (above === levels.length) return above - 1;
  return elevation - levels[above - 1].elevation <= levels[above].elevation - elevation ? above - 1 : above;
}

/** How far from a level its radials may lie: half way to the next level on their side, or as far as on its other side. */
function reachOf(levels: readonly Level[], at: number, elevation: number): number {
  if (levels.length < 2) return levels.length - 1;
  const side = elevation < levels[at].elevation ? -1 : 1;
  const next = levels[at + side] ?? levels[at - side];
  return Math.abs(next.elevation - levels[at].elevation) / 2;
}

/** Adds to levels between the radials of a scan their values. @param widest - degrees: wider gaps stay empty */
function fillBetween(
  side: readonly Beam[],
  levels: readonly Level[],
  levelOf: ReadonlyMap<Beam, Level>,
  widest: number,
): void {
  for (let i = 1; i < side.length; i++) {
    const [low, high] = [side[i - 1], side[i]];
    const gap = high.elevation - low.elevation;
    if (gap > widest) continue;
    const first = countUpTo(levels.length, (at) => levels[at].elevation <= low.elevation);
    for (let at = first; at < levels.length && levels[at].elevation < high.elevation; at++) {
      const { beams, elevation } = levels[at];
      if (levels[at] === levelOf.get(low) || levels[at] === levelOf.get(high)) continue;
      const along = (elevation - low.elevation) / gap;
      // The shorter way around, as azimuths may pass north.
      const turn = ((high.azimuth - low.azimuth + 540) % 360) - 180;
      const azimuth = (low.azimuth + along * turn + 360) % 360;
      beams.push({ ...low, azimuth, elevation, next: { radial: high.radial, along } });
    }
  }
}

/** The gates of all scans on one scale. */
interface StoredScans extends Pick<JoinedSamples, 'samples' | 'slope' | 'intercept'> {
  /** Of each scan: where its gates begin, and how many each radial has; null where it lacks the moment. */
  readonly places: readonly ({ readonly from: number; readonly gates: number } | null)[];
}

type ReadScans = (moment: string) => StoredScans | null;

/** Reads the gates of all scans with the first sweep that asks for them, and brings them to one scale. */
function readOnce(scans: readonly RadarSweep[], budget: Budget): ReadScans {
  let [last, found]: [string | null, StoredScans | null] = [null, null];
  return (moment) => {
    if (last === moment) return found;
    const gates = scans.reduce((sum, scan) => sum + scan.azimuths.length * (scan.gridOf(moment)?.gates ?? 0), 0);
    const bytes = maxBytesPerGate * gates;
    [last, found] = [moment, takeDuring(budget, { bytes, what }, () => readAllScans(scans, moment, budget))];
    return found;
  };
}

function readAllScans(scans: readonly RadarSweep[], moment: string, budget: Budget): StoredScans | null {
  const data = scans.map((scan) => scan.read(moment));
  const some = data.filter((one) => one !== null);
  if (some.length === 0) return null;
  let length = 0;
  const places = data.map((one) => {
    const from = length;
    length += one?.samples.length ?? 0;
    return one && { from, gates: one.gates };
  });
  const joined = joinSamples(some, length, budget);
  data.forEach((one, i) => {
    if (!one) return;
    for (const radial of scans[i].azimuths.keys()) joined.copyRadial(one, radial, places[i]!.from + radial * one.gates);
  });
  return { ...joined, places };
}

/** @param scans - whose gates lie at the same ranges */
function toSweep(
  level: Level,
  scans: readonly RadarSweep[],
  read: ReadScans,
  { beamWidth, mixingOf }: RangeHeightSettings,
): RadarSweep {
  const beams = separate(level.beams, beamWidth);
  const gridOf = (moment: string): SweepGates | null =>
    level.beams
      .map(({ scan }) => scans[scan].gridOf(moment))
      .reduce((a, b) => (a && b ? (b.gates > a.gates ? b : a) : (a ?? b)), null);
  const nyquists = level.beams.map(({ scan }) => scans[scan].nyquist).filter((one) => one !== undefined);
  const foldFrom: Readonly<Record<Mixing, number>> = {
    linear: Infinity,
    'unless-folded': Math.min(...nyquists),
    nearest: nearestOnly,
  };
  return {
    elevation: level.elevation,
    azimuths: Float64Array.from(beams, ({ azimuth }) => azimuth),
    elevations: Float64Array.from(beams, ({ elevation }) => elevation),
    ...(nyquists.length > 0 ? { nyquist: Math.min(...nyquists) } : {}),
    moments: [...new Set(level.beams.flatMap(({ scan }) => scans[scan].moments))],
    gridOf,
    read: (moment) => {
      const [grid, stored] = [gridOf(moment), read(moment)];
      return grid && stored && readBeams(beams, grid, stored, foldFrom[mixingOf(moment)]);
    },
  };
}

function readBeams(
  beams: readonly (Beam | Direction)[],
  grid: SweepGates,
  stored: StoredScans,
  foldFromValue: number,
): SweepData {
  const { samples: all, slope, intercept, places } = stored;
  const foldFrom = foldFromValue / Math.abs(slope);
  const isBetween = beams.some((beam) => 'next' in beam);
  const length = beams.length * grid.gates;
  const samples = isBetween ? new Float32Array(length) : allocateLike(all, length);
  samples.fill(emptyOf(samples));
  beams.forEach((beam, i) => {
    const place = 'scan' in beam && places[beam.scan];
    if (!place) return;
    const radialOf = (radial: number): Samples => {
      const from = place.from + radial * place.gates;
      return all.subarray(from, from + place.gates);
    };
    const own = radialOf(beam.radial);
    if (!isBetween) return samples.set(own, i * grid.gates);
    const { radial, along } = beam.next ?? { radial: beam.radial, along: 0 };
    const next = radialOf(radial);
    for (let gate = 0; gate < own.length; gate++)
      samples[i * grid.gates + gate] = blend(valueOf(own[gate], all), valueOf(next[gate], all), along, foldFrom);
  });
  return { ...grid, samples, slope, intercept };
}

/** A stored number; NaN for no data. */
function valueOf(stored: number, of: Samples): number {
  return of instanceof Float32Array || stored !== 0 ? stored : NaN;
}

/**
 * Between two gates of a scan, as in a picture: linear; where one of them has no data, the other one reaches half way.
 * @param foldFrom - if they differ by more, a velocity has folded between them, and the nearer one counts, as of kinds of echo
 */
function blend(low: number, high: number, along: number, foldFrom: number): number {
  const [nearer, other] = along <= 0.5 ? [low, high] : [high, low];
  if (Number.isNaN(nearer) || Number.isNaN(other) || Math.abs(high - low) > foldFrom) return nearer;
  return low + along * (high - low);
}

/** Beams by azimuth, with empty ones around each that has no other one near it. */
function separate(beams: readonly Beam[], beamWidth: number): (Beam | Direction)[] {
  const sorted = [...beams];
  sorted.sort((a, b) => a.azimuth - b.azimuth);
  const around = (azimuth: number): number => (azimuth + 360) % 360;
  return sorted.flatMap((beam, i) => {
    const next = sorted[(i + 1) % sorted.length];
    const gap = next === beam ? 360 : around(next.azimuth - beam.azimuth);
    if (gap <= widestShare * beamWidth) return [beam];
    return [
      beam,
      { azimuth: around(beam.azimuth + beamWidth), elevation: beam.elevation },
      { azimuth: around(next.azimuth - beamWidth), elevation: next.elevation },
    ];
  });
}
