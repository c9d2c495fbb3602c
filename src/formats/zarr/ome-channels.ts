import { VolumeViewError } from '../../core/errors.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { cleanName } from '../base/clean-name.ts';
import type { FileTree } from './file-tree.ts';
import type { OmeImage } from './open-image.ts';
import { listOf, objectOf } from './read-json.ts';
import type { Json } from './read-json.ts';

/** A channel as the file describes it. */
export interface OmeChannel {
  /** From 0. */
  readonly index: number;
  /** '' where it has none. */
  readonly name: string;
  readonly color: Vector3;
  /** Null where the file has none that can be. */
  readonly window: readonly [number, number] | null;
}

/** What is shown of an image: one channel as values, or several as colours. */
export type ShownChannels =
  | { readonly kind: 'values'; readonly index: number }
  | { readonly kind: 'colors'; readonly list: readonly OmeChannel[] };

/** Channels that are shown at once: each has its own samples in memory. */
const maxShown = 8;

/** Characters of a name. */
const longestName = 60;

/** Colours of channels whose file says none: the first ones differ for all eyes. */
const usualColors: readonly Vector3[] = [
  [0.2, 1, 0.35],
  [1, 0.25, 0.9],
  [0.25, 0.6, 1],
  [1, 0.8, 0.2],
  [1, 0.25, 0.2],
  [1, 1, 1],
];

export const countChannels = ({ axes, levels }: OmeImage): number =>
  axes.channel === null ? 1 : levels[0].array.shape[axes.channel];

/**
 * Which channels are shown: those that the address asks for, else those that the file has switched on. Source: OME-Zarr 0.5, "omero" metadata
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function chooseChannels(
  image: OmeImage,
  { channel, channels }: Pick<FileTree, 'channel' | 'channels'>,
): ShownChannels {
  const count = countChannels(image);
  if (channels) {
    const numbers = [
      ...new Set(channels.split(',').map((one) => numberOf(one, count) ?? refuse('channels', channels, count))),
    ];
    if (numbers.length > maxShown) refuse('channels', channels, count);
    return { kind: 'colors', list: numbers.map((index) => describeChannel(image.omero, index)) };
  }
  if (channel) return { kind: 'values', index: numberOf(channel, count) ?? refuse('channel', channel, count) };
  if (count === 1 || image.labels) return { kind: 'values', index: 0 };
  const said = listOf(image.omero.channels);
  const all = Array.from({ length: Math.min(count, maxShown + said.length) }, (_, index) => index);
  const active = all.filter((index) => objectOf(said[index]).active !== false);
  const list = (active.length > 0 ? active : all).slice(0, maxShown);
  return { kind: 'colors', list: list.map((index) => describeChannel(image.omero, index)) };
}

/** From 0; null for what is no number of a channel. */
function numberOf(text: string, count: number): number | null {
  const number = Number(text.trim() || NaN);
  return Number.isInteger(number) && number >= 1 && number <= count ? number - 1 : null;
}

function refuse(word: string, got: string, count: number): never {
  const expected =
    word === 'channel'
      ? `the number of a channel, from 1 to ${count}`
      : `numbers of channels with commas, from 1 to ${count}, ${maxShown} at most`;
  throw new VolumeViewError('attribute/invalid', `src got "#${word}=${got.slice(0, 40)}"; expected ${expected}.`);
}

export function describeChannel(omero: Json, index: number): OmeChannel {
  const { label, color, window } = objectOf(listOf(omero.channels)[index]);
  const { start, end } = objectOf(window);
  const isWindow = typeof start === 'number' && typeof end === 'number' && Number.isFinite(end - start) && start < end;
  return {
    index,
    name:
      typeof label === 'string'
        ? cleanName(label.slice(0, 4 * longestName))
            .trim()
            .slice(0, longestName)
        : '',
    color: readColor(color) ?? usualColors[index % usualColors.length],
    window: isWindow ? [start, end] : null,
  };
}

/** Six digits, or eight with an opacity, which is not counted. Black would give no light: null. */
function readColor(color: unknown): Vector3 | null {
  const digits = typeof color === 'string' ? /^#?([\da-f]{6})([\da-f]{2})?$/i.exec(color)?.[1] : null;
  const number = parseInt(digits || '0', 16);
  return number > 0 ? ([16, 8, 0].map((bits) => ((number >> bits) & 255) / 255) as unknown as Vector3) : null;
}

/** What of the channels is not shown, in words; null where all of them are. */
export function describeHidden(shown: ShownChannels, count: number): string | null {
  if (count === 1) return null;
  if (shown.kind === 'values')
    return `${count - 1} of ${count} channels: number ${shown.index + 1} is shown, and "#channel=2" after the address shows the second`;
  const hidden = count - shown.list.length;
  return hidden > 0
    ? `${hidden} of ${count} channels: "#channels=1,2" after the address shows the first and the second`
    : null;
}
