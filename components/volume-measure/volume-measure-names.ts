import type { Handle } from '../../src/viewer/overlays/handles.ts';
import type { VolumeInfo } from '../../src/viewer/model/volume-info.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { isRadar, writePlace } from '../internal/volume-readout-rows.ts';
import type { MeasureLocale } from './volume-measure-rows.ts';

/** Names of the handles of a measure, with their places as text. */
export function namePoints(
  { points, count, name }: { readonly points: readonly Vector3[]; readonly count: number; readonly name: string },
  info: VolumeInfo,
  locale: MeasureLocale,
): Pick<Handle, 'name' | 'place' | 'keys'>[] {
  const { language, messages } = locale;
  return points.map((point, i) => ({
    name: `${name}: ${messages.measurePoint(language.number(i + 1), language.number(count))}`,
    place: isRadar(info) ? writeRadarPlace(point, locale) : writePlace(point, info, { ...locale, coordinates: null }),
    keys: messages.handleKeys,
  }));
}

/** @param place - metres east, north and above the antenna */
function writeRadarPlace([east, north, up]: Vector3, { language, messages }: MeasureLocale): string {
  const way = (length: number, [less, more]: readonly [string, string]): string =>
    `${length < 0 ? less : more} ${language.fixed(Math.abs(length) / 1000, 2)}`;
  return `${messages.kilometres(`${way(east, [messages.west, messages.east])} ${way(north, [messages.south, messages.north])}`)}, ${messages.metres(language.fixed(up, 0))}`;
}
