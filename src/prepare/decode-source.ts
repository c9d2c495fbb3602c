import { VolumeViewError } from '../core/errors.ts';
import { Budget } from '../formats/base/budget.ts';
import type { DecodedVolume, DecodeSettings } from '../formats/base/decoded-volume.ts';
import { NeedsMainThread } from '../formats/base/needs-main-thread.ts';
import type { ScanData } from '../formats/base/scan-data.ts';
import type { ScanTimes } from '../formats/base/choose-scan.ts';
import { decodeFile, explain } from '../formats/decode.ts';
import { finishVolume } from '../formats/finish-volume.ts';
import { readPlacedScan } from '../formats/read-placed-scan.ts';
import type { ByteStore } from '../sources/byte-store.ts';
import { fetchInOrder } from '../sources/fetch-files.ts';
import type { DeviceLimits } from '../volume/reduce.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import type { Source } from './find-sources.ts';

/** Nothing is made smaller when it is read: the writer does that, and says it. */
const noLimits: DeviceLimits = { maxVoxelsPerAxis: Infinity, maxAtlasSize: null, maxBytes: Infinity };

/** One volume of a source. */
export interface SourceVolume {
  /** From 1, counted over all series and times of the source. */
  readonly number: number;
  /** Its series, from 0: the volumes of a series are its scans in time. */
  readonly series: number;
  readonly volume: Volume;
  /** When it was measured: ISO 8601 of a radar or a manifest, or a number with its unit; null where nothing says it. */
  readonly time: string | null;
}

/** A volume that can't be read, while others of its source can. */
export interface SourceFailure {
  readonly number: number;
  readonly error: unknown;
}

export interface DecodeOptions {
  /** Of a radar: the quantity. */
  readonly moment?: string;
  /** Maximum bytes that one volume may take. */
  readonly deviceBytes: number;
  /** Only this one of several series, by its number; all of them if undefined. */
  readonly series?: number;
}

/**
 * Reads all volumes of a source, one after another: each series, each scan in time. Where the first one can't be read, none can.
 * @param store - `source` names its files
 * @throws {VolumeViewError} `format/…`, `source/…`, `manifest/invalid`
 */
export async function* decodeSource(
  store: ByteStore,
  source: Source,
  options: DecodeOptions,
): AsyncGenerator<SourceVolume | SourceFailure> {
  let number = 0;
  const { series: only } = options;
  const first = await decodeScans(store, source, options, only === undefined ? {} : { series: only });
  for await (const one of first.scans) yield { number: ++number, series: 0, ...one };
  if (only !== undefined) return;
  for (const [i, series] of first.others.entries()) {
    try {
      const { scans } = await decodeScans(store, source, options, { series });
      for await (const one of scans) yield { number: ++number, series: i + 1, ...one };
    } catch (error) {
      yield { number: ++number, error };
    }
  }
}

type Scan = Omit<SourceVolume, 'number' | 'series'> | Omit<SourceFailure, 'number'>;

/** The scans of one series, of which the first one is read, and the numbers of the other series. */
async function decodeScans(
  store: ByteStore,
  { first, files }: Source,
  { moment, deviceBytes }: DecodeOptions,
  settings: DecodeSettings,
): Promise<{ readonly scans: AsyncIterable<Scan>; readonly others: readonly number[] }> {
  let [times, data]: [ScanTimes, readonly ScanData[] | undefined] = [[], undefined];
  const fetchFile = (url: string, range?: { readonly start: number; readonly end: number }) =>
    store.read(url, { range });
  const read = async (index: number): Promise<Volume> => {
    try {
      const budget = new Budget(deviceBytes);
      const decoded: DecodedVolume =
        index > 0 && data
          ? await readPlacedScan(data[index], settings, { fetchFile, budget })
          : await decodeFile(
              await fetchFile(first),
              { ...settings, moment, scan: { index } },
              {
                fetchFile,
                fetchFiles: (urls) =>
                  fetchInOrder(
                    urls,
                    (url) => fetchFile(url),
                    () => undefined,
                  ),
                ...(files && files.length > 1 && { files }),
                budget,
                onProgress: () => undefined,
                onScans: (...found) => ([times, data] = found),
              },
            );
      return await finishVolume(decoded, noLimits);
    } catch (cause) {
      throw cause instanceof NeedsMainThread ? refusePicture() : await explain(cause, first);
    }
  };
  const opened = await read(0);
  async function* listScans(): AsyncGenerator<Scan> {
    let last: Volume | null = opened;
    for (let index = 0; index < Math.max(1, times.length); index++) {
      try {
        const volume: Volume = last ?? (await read(index));
        last = null;
        yield { volume, time: (isPolar(volume) ? volume.radar?.time : undefined) ?? times[index] ?? null };
      } catch (error) {
        yield { error };
      }
    }
  }
  const others = (opened.series ?? []).filter(({ shown }) => !shown).map(({ number }) => number);
  return { scans: listScans(), others };
}

function refusePicture(): VolumeViewError {
  return new VolumeViewError(
    'format/unsupported',
    'it is a JPEG or WebP image, which only a browser unpacks; put the image and its manifest on the server as they are, or save the image as PNG',
  );
}
