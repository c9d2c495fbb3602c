import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from '../base/budget.ts';
import type { RadarSweep } from './radar-file.ts';
import { arrangeRangeHeight } from './range-height.ts';
import type { ArrangedSweeps, RangeHeightSettings } from './range-height.ts';

/** What an antenna does: keeps its elevation, keeps its azimuth and turns in elevation, or another thing than looking at the weather. */
type Movement = 'cone' | 'range-height' | 'other';

/** Source: CfRadial 1.4, table 5.1 */
function movementOf(mode: string): Movement {
  if (/rhi|elevation_surveillance/i.test(mode)) return 'range-height';
  return /coplane|^\s*pointing|idle|sunscan|calibration/i.test(mode) ? 'other' : 'cone';
}

/** Degrees: an antenna that moves farther in elevation, and less in azimuth, makes a range-height scan, whatever it is called. */
const [leastRise, farthestTurn] = [5, 2];

/** A sweep may begin and end with radials of another direction: so many of its radials count. */
const usualShare = 0.9;

/** Whether a sweep stays at one azimuth while it turns in elevation. Beyond the zenith it looks to the other side. */
function turnsUp({ azimuths, elevations }: RadarSweep): boolean {
  if (!elevations || riseOf(elevations) <= leastRise) return false;
  const middle = azimuths[Math.floor(azimuths.length / 2)];
  const kept = elevations.filter((_, i) => {
    const turn = (((azimuths[i] - middle) % 180) + 180) % 180;
    return Math.min(turn, 180 - turn) <= farthestTurn;
  });
  return kept.length >= usualShare * elevations.length && riseOf(kept) > leastRise;
}

/** Degrees from the lowest to the highest radial. */
function riseOf(elevations: Float64Array): number {
  let [low, high] = [Infinity, -Infinity];
  for (const one of elevations) {
    if (!(Math.abs(one) <= 180)) continue;
    low = Math.min(low, one);
    high = Math.max(high, one);
  }
  return high - low;
}

/** A sweep that is not read yet. */
interface SweepOfMode {
  readonly mode: string | undefined;
  open(): RadarSweep;
}

/** The same with what its antenna does. Sweeps that may be cones are open. */
interface SettledSweep {
  readonly mode: string;
  readonly movement: Movement;
  open(): RadarSweep;
}

function settle({ mode = '', open }: SweepOfMode): SettledSweep {
  const movement = movementOf(mode);
  if (movement !== 'cone') return { mode, movement, open };
  const sweep = open();
  return { mode, movement: turnsUp(sweep) ? 'range-height' : 'cone', open: () => sweep };
}

/**
 * The sweeps that are shown: those of constant elevation, or, where there is none, range-height scans.
 * @throws {VolumeViewError} `format/unsupported` where there is neither
 */
export function chooseByMode(
  given: readonly SweepOfMode[],
  settings: RangeHeightSettings,
  budget: Budget,
): ArrangedSweeps {
  const all = given.map(settle);
  const cones = all.filter(({ movement }) => movement === 'cone');
  if (cones.length > 0)
    return { sweeps: cones.map((one) => one.open()), left: describeOthers(all, 'cone'), details: [] };
  const scans = all.filter(({ movement }) => movement === 'range-height').map((one) => one.open());
  const arranged = arrangeRangeHeight(scans, settings, budget);
  if (arranged.sweeps.length === 0)
    throw new VolumeViewError(
      'format/unsupported',
      `the CfRadial file got ${all.length} sweeps of sweep_mode ${listModes(all)}; expected sweeps of constant elevation, or range-height scans; choose another file of this radar`,
    );
  return { ...arranged, left: [...describeOthers(all, 'range-height'), ...arranged.left] };
}

const listModes = (sweeps: readonly SettledSweep[]): string =>
  [...new Set(sweeps.map(({ mode }) => mode.trim().slice(0, 40) || 'none'))].slice(0, 8).join(', ');

/** What is said of sweeps that move in another way. */
function describeOthers(all: readonly SettledSweep[], shown: Movement): string[] {
  const others = all.filter(({ movement }) => movement !== shown);
  return others.length > 0
    ? [
        `${others.length} of ${all.length} sweeps are left out: the antenna did not keep its elevation, or did not look at the weather (sweep_mode: ${listModes(others)})`,
      ]
    : [];
}
