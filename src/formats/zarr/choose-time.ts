import { VolumeViewError } from '../../core/errors.ts';
import { chooseScan } from '../base/choose-scan.ts';
import type { DecodeSettings } from '../base/decoded-volume.ts';
import type { ScansListener } from '../base/load-request.ts';
import { timeAt } from '../series/scan-times.ts';
import type { OmeImage } from './open-image.ts';
import { secondsOf } from './time-units.ts';

/** Times that a page can have as scans. */
const maxTimes = 10_000;

/** The time that is read, from 0, and the number of times; the page hears of them as scans where it asks for one. */
export function chooseTime(
  { axes, levels }: OmeImage,
  { scan }: DecodeSettings,
  { onScans }: { readonly onScans?: ScansListener },
): { readonly time: number; readonly times: number } {
  const [{ array, scale, translation }] = levels;
  const times = axes.time === null ? 1 : array.shape[axes.time];
  if (axes.time === null || times === 1 || !scan) return { time: 0, times };
  if (times > maxTimes)
    throw new VolumeViewError(
      'format/too-large',
      `the Zarr has ${times.toLocaleString('en')} times; expected at most ${maxTimes.toLocaleString('en')}`,
    );
  const seconds = secondsOf(axes.timeUnit);
  const step = scale[axes.time] * (seconds ?? NaN);
  const steps = step > 0 ? { first: translation[axes.time] * seconds!, step, unit: 's' } : null;
  const known = Array.from({ length: times }, (_, index) => timeAt(index, steps));
  onScans?.(known);
  return { time: chooseScan(known, scan).index, times };
}
