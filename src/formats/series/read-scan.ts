import { corruptFile } from '../base/file-problem.ts';
import type { DecodedCartesianVolume, DecodeInput } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import type { ScanNumbers, WebPixels } from '../base/scan-data.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { scanTypes } from './scan-types.ts';

/** What reading a scan needs: memory, and files of which it reads a part. */
export type ScanAccess = Pick<ReadContext, 'fetchFile' | 'budget'> &
  Partial<Pick<ReadContext, 'onProgress'>> & {
    /** Fetches pixels from a DICOMweb server, as a file without any other element. */
    readonly fetchPixels?: (pixels: WebPixels) => Promise<DecodeInput>;
  };

/**
 * Reads one volume of a file that holds several, without its place in a page (see `placeVolume`).
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, and what fetching throws
 */
export async function readScan(scan: ScanNumbers, access: ScanAccess): Promise<DecodedCartesianVolume> {
  return storeScan(await readPart(scan, 0, countBytes(scan), access), scan, access);
}

/**
 * The same from its bytes.
 * @param bytes - taken from the budget already
 */
export async function storeScan(
  bytes: Uint8Array<ArrayBuffer>,
  scan: Omit<ScanNumbers, 'from'>,
  access: ScanAccess,
): Promise<DecodedCartesianVolume> {
  const { littleEndian, format, series, slope, intercept } = scan;
  const type = scanTypes.get(scan.type)!;
  const { samples, scale, offset, ...rest } = storeSamples(bytes, type, littleEndian, {
    slope,
    intercept,
    budget: access.budget,
    chooseWhole: await wholeNumbersOf(type),
  });
  const rescale = type.complex ? { slope: 1, intercept: 0 } : { slope, intercept };
  return {
    ...series,
    format,
    samples,
    slope: rescale.slope * scale,
    intercept: rescale.slope * offset + rescale.intercept,
    // Nobody expects all digits of scaled numbers.
    ...(rescale.slope === 1 && rescale.intercept === 0 && { indexed: rest.indexed, rounded: rest.rounded }),
    unkept: rest.unkept,
  };
}

export function countBytes({ from }: Pick<ScanNumbers, 'from'>): number {
  return from instanceof Blob ? from.size : from.end - from.start;
}

/** Bytes of a scan from `start` up to `end`, in a buffer of their own. */
export async function readPart(
  { from, format }: Pick<ScanNumbers, 'from' | 'format'>,
  start: number,
  end: number,
  { fetchFile, budget }: ScanAccess,
): Promise<Uint8Array<ArrayBuffer>> {
  budget.addFile(end - start);
  budget.take(end - start, `${format} of the file`);
  const bytes =
    from instanceof Blob
      ? new Uint8Array(await from.slice(start, end).arrayBuffer())
      : (await fetchFile(from.url, { start: from.start + start, end: from.start + end })).bytes;
  if (bytes.length === end - start) return bytes;
  throw corruptFile(
    'the file',
    `sent ${bytes.length} bytes of ${format}; expected ${end - start}: it has changed since it was opened, or is cut short. Load it again`,
  );
}
