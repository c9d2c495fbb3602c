import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from '../base/budget.ts';
import type { RadarSweep } from './radar-file.ts';
import { arrangeRangeHeight, isRangeHeight } from './range-height.ts';
import type { ArrangedSweeps, RangeHeightSettings } from './range-height.ts';

/** Modes in which the antenna does not keep its elevation, or does not look at the weather. Source: CfRadial 1.4, table 5.1 */
function isCone(mode: string | undefined): boolean {
  return !/rhi|elevation_surveillance|coplane|^\s*pointing|idle|sunscan|calibration/i.test(mode ?? '');
}

/** A sweep that is not read yet. */
interface SweepOfMode {
  readonly mode: string | undefined;
  open(): RadarSweep;
}

/**
 * The sweeps that are shown: those of constant elevation, or, where there is none, range-height scans.
 * @throws {VolumeViewError} `format/unsupported` where there is neither
 */
export function chooseByMode(
  all: readonly SweepOfMode[],
  settings: RangeHeightSettings,
  budget: Budget,
): ArrangedSweeps {
  const cones = all.filter(({ mode }) => isCone(mode));
  if (cones.length > 0)
    return { sweeps: cones.map((one) => one.open()), left: describeOthers(all, isCone), details: [] };
  const scans = all.filter(({ mode }) => isRangeHeight(mode)).map((one) => one.open());
  const arranged = arrangeRangeHeight(scans, settings, budget);
  if (arranged.sweeps.length === 0)
    throw new VolumeViewError(
      'format/unsupported',
      'the CfRadial file holds neither sweeps of constant elevation nor range-height scans; expected some',
    );
  return { ...arranged, left: [...describeOthers(all, isRangeHeight), ...arranged.left] };
}

/** What is said of sweeps of other modes. */
function describeOthers(all: readonly SweepOfMode[], isShown: (mode: string | undefined) => boolean): string[] {
  const others = all.filter(({ mode }) => !isShown(mode)).map(({ mode }) => (mode ?? '').trim().slice(0, 40));
  return others.length > 0
    ? [
        `${others.length} of ${all.length} sweeps are left out: the antenna did not keep its elevation, or did not look at the weather (sweep_mode: ${[...new Set(others)].slice(0, 8).join(', ')})`,
      ]
    : [];
}
