import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { listLeft } from '../base/list-left.ts';
import type { NumberType } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import { keepVolumes } from './keep-volumes.ts';
import type { SeriesSpan } from './keep-volumes.ts';
import { openSeries } from './open-series.ts';
import type { Series } from './open-series.ts';
import { scanTypes } from './scan-types.ts';

/** What a reader says of the volumes of its file; times that it does not give are not known, and scales are 1 and 0. */
export interface VolumesOfFile extends Pick<Series, 'littleEndian'>, Partial<Pick<Series, 'scaleOf' | 'timeOf'>> {
  readonly info: Omit<Series['info'], 'left'>;
  readonly type: NumberType;
  /** What else of the file is left out, in words; null entries are ignored. */
  readonly left?: readonly (string | null)[];
}

/** Times and scales of volumes of which nothing is said. */
export const noTimes: Pick<Series, 'scaleOf' | 'timeOf'> = {
  scaleOf: () => ({ slope: 1, intercept: 0 }),
  timeOf: () => null,
};

/** The volumes of a file, one after another. */
export interface PackedVolumes extends SeriesSpan {
  /** The file, unpacked, in pieces. */
  readonly pieces: AsyncIterable<Uint8Array<ArrayBuffer>>;
  /** Maximum number of bytes that the pieces can have. */
  readonly atMost: number;
}

/** Whether the volumes of a file become scans: a page asks for them, and their numbers have a type that scans can have. */
export function areScans(count: number, type: NumberType, { scan }: DecodeSettings, { isPart }: ReadContext): boolean {
  return count > 1 && scan !== undefined && !isPart && scanTypes.has(type.name);
}

/**
 * Opens the volumes of a file as scans, and reads the one that is wanted.
 * @param describe - called with the unpacked file, or its start
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export async function openVolumes(
  { pieces, atMost, ...span }: PackedVolumes,
  describe: (file: Blob) => VolumesOfFile | Promise<VolumesOfFile>,
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedCartesianVolume> {
  const { onProgress, budget } = context;
  const kept = await keepVolumes(pieces, span, { atMost, onProgress, budget });
  const { info, type, left = [], ...rest } = await describe(kept.file);
  return placeVolume(
    await openSeries(
      {
        ...noTimes,
        ...rest,
        info: { ...info, ...listLeft(1, kept.left, ...left) },
        volumes: kept.volumes,
        count: span.count,
        type: type.name,
      },
      settings,
      context,
    ),
    settings,
  );
}
