// Which of the volumes in several files is shown, and what is said of the others.
import { invalidAttribute } from '../core/errors.ts';
import type { DecodedVolume } from '../formats/base/decoded-volume.ts';

type SeriesInfo = NonNullable<DecodedVolume['series']>[number];

/** A volume among several files, or all series of such files. */
export interface VolumePart {
  readonly of: 'volume' | 'images' | 'slices' | 'tree';
  /** The name of its format; '' where it is not known. */
  readonly format: string;
  /** The number of its files, and their bytes as they lie on the disk or are unpacked; null where these are not known. */
  readonly count: number;
  readonly bytes: number | null;
}

/**
 * The place of the volume that is shown. Files of series are one part, the last one, though they may hold several volumes.
 * @param wanted - its number from 1, that of a series included; the largest one where undefined
 * @throws {VolumeViewError} `attribute/invalid` where there are fewer
 */
export function choosePart(parts: readonly VolumePart[], wanted: number | undefined): number {
  const last = parts.length - 1;
  if (wanted === undefined) {
    // Images next to a volume are mostly pictures of it.
    const sizes = parts.map(({ of, bytes }) => (of === 'images' ? 0 : (bytes ?? 0)));
    return sizes.indexOf(Math.max(...sizes));
  }
  if (wanted > parts.length && parts[last].format !== 'DICOM')
    throw invalidAttribute(
      'series',
      String(wanted),
      `a number from 1 to ${parts.length}, as the files hold as many volumes`,
    );
  return Math.min(wanted - 1, last);
}

/**
 * Lists all volumes of several files, one of which was read.
 * @param shown - its place @param isWanted - whether it was asked for by its number
 */
export function listVolumes<T extends DecodedVolume>(
  volume: T,
  parts: readonly VolumePart[],
  { shown, isWanted }: { readonly shown: number; readonly isWanted: boolean },
): T {
  const series = parts.flatMap((part, i) => (i === shown ? describeShown(volume, part, i) : describeOther(part, i)));
  const others = parts.filter((_, i) => i !== shown);
  return withLeft({ ...volume, series }, [
    `${others.length > 1 ? `${others.length.toLocaleString('en')} other volumes` : 'another volume'} in the files (${countFormats(others)}): ${
      isWanted ? `number ${shown + 1}` : 'the largest one'
    } is shown, and the attribute series chooses another`,
  ]);
}

function describeShown({ series, grid }: DecodedVolume, { format }: VolumePart, before: number): readonly SeriesInfo[] {
  // A reader of series counts its own from 1.
  if (series) return series.map((one) => ({ ...one, number: one.number + before }));
  const dimensions = grid.kind === 'polar' ? {} : { dimensions: grid.dimensions };
  return [{ number: before + 1, shown: true, modality: '', format, ...dimensions }];
}

function describeOther({ format, count, bytes }: VolumePart, place: number): SeriesInfo {
  return { number: place + 1, shown: false, modality: '', format, files: count, ...(bytes === null ? {} : { bytes }) };
}

/** '2 × NIfTI, DICOM of 120 files'. */
function countFormats(parts: readonly VolumePart[]): string {
  const counts = new Map<string, number>();
  for (const { format, count } of parts) {
    const words = `${format || 'unknown'}${count > 1 ? ` of ${count.toLocaleString('en')} files` : ''}`;
    counts.set(words, (counts.get(words) ?? 0) + 1);
  }
  return [...counts]
    .map(([words, count]) => (count > 1 ? `${count.toLocaleString('en')} × ${words}` : words))
    .join(', ');
}

/** Says more of what is left out. */
export function withLeft<T extends DecodedVolume>(volume: T, words: readonly string[]): T {
  if (words.length === 0) return volume;
  const { radar } = volume;
  // What is said of a radar's files is said with them.
  if (radar) return { ...volume, radar: { ...radar, left: [...(radar.left ?? []), ...words] } };
  return { ...volume, left: [...(volume.left ?? []), ...words] };
}
