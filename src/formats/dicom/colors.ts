// Pictures in colours: their brightness, which are the numbers of a volume, and the colours themselves. Sources: DICOM PS3.3, C.7.6.3.1.2, C.7.6.3.1.3, C.7.6.3.1.5
import { lumaOf } from '../base/channels.ts';
import type { DataSet } from './data-set.ts';
import { tags } from './tags.ts';
import type { TransferSyntax } from './transfer-syntax.ts';

/** How the colours of a pixel are written. */
export type Colors =
  | { readonly kind: 'RGB' | 'YBR'; /** Whether all numbers of one kind come first. */ readonly isPlanar: boolean }
  /** Of two pixels: both brightnesses, and two numbers that they share. */
  | { readonly kind: 'YBR pairs' }
  /** A number of a pixel, minus `first`, is the place of its brightness, and of its red, green and blue, in the tables. */
  | { readonly kind: 'palette'; readonly first: number; readonly table: Uint8Array; readonly rgb: Uint8Array };

/** Numbers of a pixel, as they lie in the file. */
export function samplesPerPixel(colors: Colors | null): number {
  return !colors || colors.kind === 'palette' ? 1 : colors.kind === 'YBR pairs' ? 2 : 3;
}

/** @returns null where this is no form of colours that is read */
export function readColors(
  set: DataSet,
  photometric: string,
  samples: number,
  packing: TransferSyntax['packing'],
): Colors | null {
  if (photometric === 'PALETTE COLOR') return samples === 1 ? readPalette(set) : null;
  const isJ2k = packing === 'JPEG 2000' || packing === 'HTJ2K';
  const isJpeg = packing === 'JPEG';
  if (samples !== 3 || !(isJ2k || isJpeg || packing === 'none' || packing === 'RLE')) return null;
  const isPlanar = set.number(tags.planar) === 1 && !isJ2k && !isJpeg;
  // The library for JPEG 2000 turns these two back.
  if (photometric === 'RGB' || (isJ2k && /^YBR_(RCT|ICT)$/.test(photometric))) return { kind: 'RGB', isPlanar };
  if (photometric === 'YBR_FULL' || (isJpeg && /^YBR_FULL_42[02]$/.test(photometric))) return { kind: 'YBR', isPlanar };
  return photometric === 'YBR_FULL_422' && packing === 'none' ? { kind: 'YBR pairs' } : null;
}

function readPalette(set: DataSet): Colors | null {
  const read = readPaletteTables(set);
  if (!read) return null;
  const { first, entries, entry } = read;
  const table = new Uint8Array(entries);
  const rgb = new Uint8Array(3 * entries);
  for (let i = 0; i < entries; i++) {
    const [red, green, blue] = entry(i);
    table[i] = lumaOf(red, green, blue);
    rgb.set([Math.round(red), Math.round(green), Math.round(blue)], 3 * i);
  }
  return { kind: 'palette', first, table, rgb };
}

/** The colours of a palette, 0 to 1, by number; null where it has none that can be read. */
export function readPaletteColors(set: DataSet): ((number: number) => readonly [number, number, number]) | null {
  const read = readPaletteTables(set);
  if (!read) return null;
  const { first, entries, entry } = read;
  return (number) => {
    const [red, green, blue] = entry(Math.max(0, Math.min(entries - 1, number - first)));
    return [red / 255, green / 255, blue / 255];
  };
}

/** The tables of a palette; an entry has red, green and blue, 0 to 255. */
function readPaletteTables(
  set: DataSet,
): { readonly first: number; readonly entries: number; readonly entry: (i: number) => number[] } | null {
  const [count, first, bits] = set.numbers(tags.redDescriptor);
  const entries = count || 2 ** 16;
  const data = [tags.redTable, tags.greenTable, tags.blueTable].map((tag) => set.bytesOf(tag));
  if (!(entries > 0 && entries <= 2 ** 16 && (bits === 8 || bits === 16))) return null;
  if (!data.every(({ length }) => length >= entries * (bits / 8))) return null;
  const how = { entries, bits, little: set.littleEndian };
  return { first, entries, entry: (i) => data.map((bytes) => readEntry(bytes, i, how)) };
}

/** An entry of a table, 0 to 255. Entries of 8 bits may stand in words of 16. */
function readEntry(
  bytes: Uint8Array,
  i: number,
  { entries, bits, little }: { entries: number; bits: number; little: boolean },
): number {
  if (bytes.length < 2 * entries) return bytes[little ? i : i ^ 1];
  const [low, high] = little ? [bytes[2 * i], bytes[2 * i + 1]] : [bytes[2 * i + 1], bytes[2 * i]];
  return bits === 8 ? low : (256 * high + low) / 257;
}

/** Where a frame's brightness is written, and its colours if they are wanted: red, green and blue of each pixel. */
export interface ColorTarget {
  readonly gray: { [at: number]: number; readonly length: number };
  readonly rgb?: Uint8Array;
}

/** Writes red, green and blue of a pixel, or what is turned into them. */
type PixelWriter = (i: number, first: number, second: number, third: number) => void;

const writerOf =
  ({ gray, rgb }: ColorTarget): PixelWriter =>
  (i, red, green, blue) => {
    gray[i] = lumaOf(red, green, blue);
    if (!rgb) return;
    rgb[3 * i] = red;
    rgb[3 * i + 1] = green;
    rgb[3 * i + 2] = blue;
  };

const clamp = (value: number): number => Math.max(0, Math.min(255, Math.round(value)));

/** Source: PS3.3, C.7.6.3.1.2, YBR_FULL */
const turnYbr =
  (write: PixelWriter): PixelWriter =>
  (i, y, cb, cr) => {
    const red = y + 1.402 * (cr - 128);
    const green = y - 0.344136 * (cb - 128) - 0.714136 * (cr - 128);
    write(i, clamp(red), clamp(green), clamp(y + 1.772 * (cb - 128)));
  };

/**
 * The colours of all pixels.
 * @param bytes - the numbers of a frame in three colours, as they lie in the file
 * @param isTurned - whether the three numbers of a pixel lie together, the first one last
 */
export function writeColors(
  bytes: Uint8Array,
  colors: Exclude<Colors, { kind: 'palette' }>,
  to: ColorTarget,
  isTurned: boolean,
): void {
  const pixels = to.gray.length;
  const write = colors.kind === 'RGB' ? writerOf(to) : turnYbr(writerOf(to));
  if (colors.kind === 'YBR pairs') {
    for (let i = 0, at = 0; i < pixels; i++, at = 4 * (i >> 1))
      write(i, bytes[at + (i & 1)], bytes[at + 2], bytes[at + 3]);
    return;
  }
  const [first, step, apart] = isTurned ? [2, 3, -1] : colors.isPlanar ? [0, 1, pixels] : [0, 3, 1];
  for (let i = 0, at = first; i < pixels; i++, at += step)
    write(i, bytes[at], bytes[at + apart], bytes[at + 2 * apart]);
}

/** Puts the brightness of the table in the place of each number. */
export function applyPalette({ gray: numbers, rgb }: ColorTarget, colors: Colors): void {
  if (colors.kind !== 'palette') return;
  const { first, table } = colors;
  for (let i = 0; i < numbers.length; i++) {
    const entry = Math.max(0, Math.min(table.length - 1, numbers[i] - first));
    numbers[i] = table[entry];
    rgb?.set(colors.rgb.subarray(3 * entry, 3 * entry + 3), 3 * i);
  }
}
