import { boxAround, boxDimensions, groundReach } from '../../radar/polar-box.ts';
import { boxIndexToWorld, standardEarthRadius } from '../../radar/polar-geometry.ts';
import { spacingOf } from '../../volume/grid.ts';
import { nearestOnly } from '../../volume/polar-grid.ts';
import type { PolarGrid, Sweep, SweepGeometry } from '../../volume/polar-grid.ts';
import type { Samples } from '../../volume/volume.ts';
import { buildPolarMacrocells } from '../../radar/polar-macrocells.ts';
import { Budget } from '../base/budget.ts';
import type { DecodedPolarVolume } from '../base/decoded-volume.ts';
import { arrangeElevations } from './arrange-elevations.ts';
import { checkBeamWidth } from './beam-width.ts';
import { arrangeRadials } from './arrange-radials.ts';
import type { RadialOrder } from './arrange-radials.ts';
import { chooseMoment, chooseSweeps, describeChoice } from './choose-sweeps.ts';
import type { ChosenSweep } from './choose-sweeps.ts';
import { joinSamples } from './join-samples.ts';
import type { JoinedSamples } from './join-samples.ts';
import { isFolding } from './moment-kind.ts';
import type { RadarFile, RadarMoment } from './radar-file.ts';
import { anyFileBytes, refuseShown } from './radar-limits.ts';
import type { PolarSettings } from '../base/radar-settings.ts';

/**
 * The weather is a few kilometres high and hundreds wide: true to scale, a weather radar's scan is as flat as a coin.
 * Cloud radars, which look at clouds from near by, need no exaggeration.
 */
const commonExaggeration = { from: 50_000, is: 5 } as const;

/** Going through so many gates counts as one step; sorting in a radial counts as so many steps. */
const gatesPerStep = 16;
const stepsPerRadial = 16;

/** Memory for a radial in a volume's grid, in addition to its gates, bytes. */
const bytesPerRadial = 64;

/**
 * Converts one moment of a radar file to a volume on its own polar grid: sweeps by elevation, radials by azimuth, with
 * one type and scale for all.
 * @returns world coordinates: metres east, north and up (times the exaggeration) of the antenna
 * @throws {VolumeViewError} `attribute/invalid` for a moment that the file lacks, `format/unsupported` if there is
 * nothing to show, `format/too-large`
 * @param budget - of the load; macrocells, which are made later, take from it too
 */
export function buildPolarVolume(
  file: RadarFile,
  settings: PolarSettings,
  budget = Budget.ofFile(anyFileBytes),
): DecodedPolarVolume {
  const moment = chooseMoment(file, settings.moment);
  const beamWidth = checkBeamWidth(file.beamWidth);
  const { chosen, left, details } = chooseSweeps(file, moment.name, beamWidth, budget);
  left.push(...(file.left ?? []), ...new Set(chosen.flatMap(({ sweep }) => sweep.left ?? [])));
  details.push(
    ...(settings.moment === undefined ? describeChoice(file, moment) : []),
    ...(file.details ?? []),
    ...describeInvalid(chosen),
  );
  const radials = chosen.reduce((sum, { sweep }) => sum + sweep.azimuths.length, 0);
  budget.take(radials * bytesPerRadial, 'the radials of the radar file');
  budget.step(radials * stepsPerRadial, 'the radials of the radar file');
  const orders = chosen.map(({ sweep }) => arrangeRadials(sweep.azimuths, beamWidth));
  const sweeps = placeSweeps(chosen, orders);
  const joined = joinSamples(
    chosen.map(({ data }) => data),
    countGates(sweeps),
    budget,
  );
  orders.forEach(({ radials }, i) => copyRadials(joined, chosen[i], radials, sweeps[i]));
  const { samples, slope, intercept } = joined;
  budget.giveBack(chosen.reduce((sum, { data }) => sum + data.samples.byteLength, 0));
  const earthRadius = settings.beamModel === 'straight' ? Infinity : standardEarthRadius;
  const foldFrom = chooseFold(moment, chosen, joined);
  const open = { sweeps, beamWidth, earthRadius, ...(foldFrom === undefined ? {} : { foldFrom }) };
  const grid = frameSweeps(open, samples, settings.verticalExaggeration);
  return {
    grid,
    samples,
    slope,
    intercept,
    unit: moment.unit,
    ...(moment.numbers && { kinds: moment.numbers }),
    makeMacrocells: () =>
      buildPolarMacrocells(samples, grid, (gates) => budget.step(gates / gatesPerStep, 'the radar file')),
    format: file.format,
    radar: {
      moment: moment.name,
      moments: file.moments.map(({ name }) => name),
      site: file.site,
      sweeps: chosen.map(({ sweep: { elevation, azimuths }, data: { gates, firstGate, gateLength } }) => ({
        elevation,
        radials: azimuths.length,
        gates,
        firstGate,
        gateLength,
      })),
      left: file.partial === undefined ? left : [file.partial, ...left],
      details,
      ...(file.time === undefined ? {} : { time: file.time }),
      ...(file.partial === undefined ? {} : { partial: file.partial }),
    },
  };
}

function describeInvalid(chosen: readonly ChosenSweep[]): string[] {
  const invalid = chosen.reduce((sum, { data }) => sum + (data.invalid ?? 0), 0);
  return invalid > 0
    ? [
        `${invalid.toLocaleString('en')} gates hold no data: their values are outside of what the file calls valid (valid_min, valid_max, valid_range)`,
      ]
    : [];
}

/** Sweeps with the box around them. */
function frameSweeps(
  open: SweepGeometry,
  samples: Samples,
  verticalExaggeration = chooseExaggeration(open),
): PolarGrid {
  const box = boxAround(open, samples);
  const dimensions = boxDimensions(box, Math.min(...open.sweeps.map(({ gateLength }) => gateLength)));
  const indexToWorld = boxIndexToWorld(box, dimensions, verticalExaggeration);
  return { kind: 'polar', dimensions, indexToWorld, spacing: spacingOf(indexToWorld), ...open, box };
}

function chooseExaggeration(grid: SweepGeometry): number {
  return groundReach(grid) < commonExaggeration.from ? 1 : commonExaggeration.is;
}

function placeSweeps(chosen: readonly ChosenSweep[], orders: readonly RadialOrder[]): Sweep[] {
  let offset = 0;
  return chosen.map(({ sweep, data: { firstGate, gateLength, gates } }, i) => {
    const { azimuths, radials } = orders[i];
    const elevations = arrangeElevations(sweep, radials, [
      chosen[i - 1]?.sweep.elevation ?? -90,
      chosen[i + 1]?.sweep.elevation ?? 90,
    ]);
    const placed: Sweep = {
      elevation: sweep.elevation,
      azimuths,
      ...(elevations ? { elevations } : {}),
      firstGate,
      gateLength,
      gates,
      offset,
    };
    offset += azimuths.length * gates;
    return placed;
  });
}

/** Gates of all sweeps, including those of the inserted radials without data. */
function countGates(sweeps: readonly Sweep[]): number {
  const last = sweeps.at(-1)!;
  const gates = last.offset + last.azimuths.length * last.gates;
  const radials = sweeps.reduce((max, { azimuths }) => Math.max(max, azimuths.length), 0);
  refuseShown({ sweeps: sweeps.length, radials, gates });
  return gates;
}

function copyRadials(
  joined: JoinedSamples,
  { data }: ChosenSweep,
  radials: Int32Array,
  { offset, gates }: Sweep,
): void {
  radials.forEach((radial, i) => {
    if (radial >= 0) joined.copyRadial(data, radial, offset + i * gates);
  });
}

/**
 * Velocities wrap around at the Nyquist velocity: two neighbours on both sides of a fold differ by nearly twice that,
 * so a difference of more than once that is treated as a fold. If sweeps differ, the smallest Nyquist velocity is used
 * for all. Kinds of echo are never mixed.
 * @returns difference of stored values; half way between whole numbers for integers, so that rounding can't separate
 * equal numbers
 */
function chooseFold(
  moment: RadarMoment,
  chosen: readonly ChosenSweep[],
  { samples, slope }: JoinedSamples,
): number | undefined {
  if (moment.kind === 'kinds') return nearestOnly;
  const limits = chosen.map(({ sweep }) => sweep.nyquist ?? Infinity).filter((nyquist) => nyquist > 0);
  const nyquist = Math.min(...limits);
  if (!isFolding(moment) || !Number.isFinite(nyquist)) return undefined;
  const stored = nyquist / Math.abs(slope);
  // A fold beyond all values is not needed.
  if (!(stored < 3e38)) return undefined;
  return samples instanceof Float32Array ? stored : Math.floor(stored) + 0.5;
}
