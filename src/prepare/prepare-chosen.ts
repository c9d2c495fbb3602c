import { VolumeViewError } from '../core/errors.ts';
import type { ByteStore } from '../sources/byte-store.ts';
import { openFiles } from '../sources/open-files.ts';
import { describeFailure, prepareSource } from './prepare-source.ts';
import type { PreparedVolume, PrepareFailure } from './prepare-source.ts';

/** Which volume of the files. */
export interface ChosenVolume {
  /** The number of one of several series; null for the one that a view shows first. */
  readonly series: number | null;
  /** Which one of several scans in time, from 0. */
  readonly scan: number;
}

/** Bytes that one volume may take in memory. */
const deviceBytes = 2 ** 30;

/** The URLs of the files begin with this: no server can have this name (RFC 2606). */
const base = 'https://chosen.invalid/';

/**
 * Makes one volume of files that a person chose ready, as a view shows it that has them as its `files`: an image and a manifest, in which
 * nothing of DICOM is but numbers, unit and places. Never rejects.
 */
export async function prepareChosen(
  files: readonly File[],
  { series, scan }: ChosenVolume,
): Promise<PreparedVolume | PrepareFailure> {
  try {
    const opened = await openFiles({ base, files }, { isStack: false, series: series ?? undefined });
    if (opened.tree)
      throw new VolumeViewError(
        'format/unsupported',
        'it is an OME-Zarr, of which no image can be made yet; expected DICOM, NIfTI or another file of one volume',
      );
    const store: ByteStore = {
      list: async () => null,
      stat: async () => ({ size: null }),
      read: (url, options = {}) => opened.read(url, options),
    };
    const source = { first: opened.first, files: opened.files, phase: 1 } as const;
    const options = {
      fit: 'desktop',
      poster: 0,
      deviceBytes,
      series: series === null ? undefined : series - (opened.before ?? 0),
    } as const;
    let at = 0;
    for await (const one of prepareSource(store, source, options)) if (at++ === scan) return one;
    throw new VolumeViewError('internal', `got scan ${scan + 1} of ${at}`);
  } catch (error) {
    return { number: 1, ...describeFailure(error) };
  }
}
