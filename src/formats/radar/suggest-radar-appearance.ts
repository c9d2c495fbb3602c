import { stretchOf } from '../../radar/polar-geometry.ts';
import { longestEdgeShare } from '../../volume/reference-length.ts';
import { widestGap } from '../../radar/sweep-elevations.ts';
import type { Histogram } from '../../volume/histogram.ts';
import type { Sweep } from '../../volume/polar-grid.ts';
import type { PolarVolume } from '../../volume/volume.ts';

/** A radar volume without its macrocells. */
export type PolarOutline = Omit<PolarVolume, 'macrocells'>;

/** How a scan is shown if neither its author nor a manifest says it. */
type RadarAppearance = Pick<PolarVolume, 'window' | 'transferFunction' | 'referenceLength'>;

/** A preset, and approximately its opacity per reference length, for a share of the window or for a value. */
interface Scale {
  readonly preset: string;
  readonly window: readonly [number, number];
  opacityOf(value: number): number;
}

/** @param kinds - the smallest and the largest value that can occur, where values are kinds of echo */
export function suggestRadarAppearance(volume: PolarOutline, kinds?: readonly [number, number]): RadarAppearance {
  const scale = kinds ? scaleOfKinds(kinds) : chooseScale(volume);
  const isOwn = volume.transferFunction !== undefined || volume.window !== undefined;
  return {
    window: volume.window ?? scale.window,
    transferFunction: volume.transferFunction ?? scale.preset,
    ...(isOwn ? {} : { referenceLength: suggestLength(volume, scale) }),
  };
}

function chooseScale({ unit, range, histogram }: PolarOutline): Scale {
  if (!(range[1] > range[0]))
    return { preset: 'turbo', window: [range[0] - 0.5, range[0] + 0.5], opacityOf: () => 0.1 };
  if (unit === 'm/s') return velocityScale(histogram, range);
  if (unit === 'dBZ' && shareFrom(histogram, rain.from) >= rain.share) return rainScale(range);
  return ownScale(histogram);
}

/** Where a weather radar's scale begins, dBZ, and the share of the echoes above it in rain. */
const rain = { from: 5, share: 0.3 };

const rainScale = (range: readonly [number, number]): Scale => ({
  preset: 'radar-dbz',
  window: [...range],
  opacityOf: (value) => (value < 3 ? 0 : 0.015 + 0.9 * Math.min(1, (value - 3) / 72) ** 2.3),
});

/** Equally far from 0 on both sides. The few fastest gates, often noise, are cut off. */
function velocityScale(histogram: Histogram, range: readonly [number, number]): Scale {
  const fastest = Math.max(...range.map(Math.abs));
  const usual = 1.15 * Math.max(Math.abs(quantile(histogram, 0.01)), Math.abs(quantile(histogram, 0.99)));
  const limit = Math.min(fastest, usual) || fastest;
  return {
    preset: 'radar-velocity',
    window: [-limit, limit],
    opacityOf: (value) => 0.015 + 0.2 * Math.min(1, Math.abs(value) / limit) ** 1.5,
  };
}

/**
 * The scale of scans in clear air or of clouds, and of moments without a well-known scale: the colours span the
 * volume's own values.
 */
function ownScale(histogram: Histogram): Scale {
  const [low, high] = [quantile(histogram, 0.02), quantile(histogram, 0.998)];
  const window: [number, number] = high > low ? [low, high] : [histogram.low, histogram.high];
  return {
    preset: 'turbo',
    window,
    opacityOf: (value) => 0.2 * Math.min(1, Math.max(0, (value - window[0]) / (window[1] - window[0]))) ** 2,
  };
}

/** A colour for each kind, the same one in all files. It begins at 0, so that the first kind can be seen. */
const scaleOfKinds = ([low, high]: readonly [number, number]): Scale => ({
  preset: 'turbo',
  window: [Math.min(0, low), high],
  opacityOf: (value) => 0.2 * Math.min(1, Math.max(0, value / high)) ** 2,
});

function quantile({ low, high, counts }: Histogram, share: number): number {
  const total = counts.reduce((sum, count) => sum + count, 0);
  let bin = 0;
  for (let sum = counts[0]; sum < share * total; sum += counts[bin]) bin++;
  return low + ((high - low) * (bin + Number(share > 0.5))) / counts.length;
}

function shareFrom({ low, high, counts }: Histogram, value: number): number {
  const first = Math.ceil(((value - low) / (high - low)) * counts.length);
  const sum = (values: Uint32Array): number => values.reduce((total, count) => total + count, 0);
  return sum(counts.subarray(Math.max(0, first))) / sum(counts);
}

/** Number of radials and gates of a sweep that are examined. */
const lookedAt = { radials: 72, gates: 100 };

/** The optical depth of a column of usual echoes. */
const usualDepth = 1.5;

/** The minimum length as a share of the common one, which is 1 % of the longest edge. */
const minShare = 1 / 60;

/**
 * The reference length with which columns of echoes are neither hidden in haze nor opaque walls: echoes of a clear day
 * are as thin as the beam, those of a storm many kilometres high.
 */
function suggestLength(volume: PolarOutline, { opacityOf }: Scale): number {
  const { grid } = volume;
  const common = longestEdgeShare(grid);
  const depths: number[] = [];
  const [lowest] = grid.sweeps;
  for (
    let radial = 0;
    radial < lowest.azimuths.length;
    radial += Math.ceil(lowest.azimuths.length / lookedAt.radials)
  ) {
    for (let gate = 0; gate < lowest.gates; gate += Math.ceil(lowest.gates / lookedAt.gates)) {
      const depth = depthOfColumn(
        volume,
        lowest.azimuths[radial],
        lowest.firstGate + gate * lowest.gateLength,
        opacityOf,
      );
      if (depth > 0) depths.push(depth);
    }
  }
  if (depths.length === 0) return common;
  depths.sort((a, b) => a - b);
  return Math.min(common, Math.max(minShare * common, depths[Math.floor(0.7 * depths.length)] / usualDepth));
}

/** World length times extinction, from the lowest sweep up. */
function depthOfColumn(volume: PolarOutline, azimuth: number, range: number, opacityOf: Scale['opacityOf']): number {
  const {
    grid: { sweeps, beamWidth },
    samples,
    slope,
    intercept,
  } = volume;
  const stretch = stretchOf(volume.grid);
  const lowestStored = samples instanceof Float32Array ? -Infinity : 1;
  return sweeps.reduce((sum, sweep, i) => {
    const stored = samples[indexOf(sweep, azimuth, range)];
    if (!(stored >= lowestStored)) return sum;
    // Half way to the next sweeps above and below, if they are near enough.
    const width = [sweeps[i - 1], sweeps[i + 1]].reduce((sum, next) => {
      const gap = next ? Math.abs(next.elevation - sweep.elevation) : Infinity;
      return sum + (gap <= widestGap(beamWidth) ? gap : beamWidth) / 2;
    }, 0);
    const height = range * ((width * Math.PI) / 180) * stretch;
    return sum - Math.log(1 - opacityOf(slope * stored + intercept)) * height;
  }, 0);
}

/** A radial nearby, and the gate; -1 beyond the sweep. */
function indexOf({ azimuths, firstGate, gateLength, gates, offset }: Sweep, azimuth: number, range: number): number {
  const radial = Math.min(azimuths.length - 1, Math.floor((azimuth / 360) * azimuths.length));
  const gate = Math.round((range - firstGate) / gateLength);
  return gate >= 0 && gate < gates ? offset + radial * gates + gate : -1;
}
