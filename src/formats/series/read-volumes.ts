import type { CartesianGrid } from '../../volume/grid.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume, DecodeInput, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { listLeft } from '../base/list-left.ts';
import type { NumberType } from '../base/number-types.ts';
import { PieceReader, readSpan, yieldOnce } from '../base/piece-reader.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { gunzip, isGzip, maxDeflateRatio } from '../codecs/gunzip.ts';
import { areScans, openVolumes } from './open-volumes.ts';
import type { VolumesOfFile } from './open-volumes.ts';

/** What the header of a file says of the volumes that follow it, one after another. */
export interface VolumesBehindHeader {
  readonly grid: CartesianGrid;
  /** Whether the header says where the patient is. */
  readonly anatomical?: boolean;
  readonly type: NumberType;
  readonly littleEndian: boolean;
  readonly count: number;
  /** Where the samples begin. */
  readonly offset: number;
  /** Bytes behind the samples that may be needed; 0 if undefined. */
  readonly tail?: number;
  /** The times of the volumes, from the unpacked file; they are not known if undefined. @param end - where the samples end */
  readonly readTimes?: (file: Blob, end: number) => Promise<VolumesOfFile['timeOf']>;
}

/** A format whose files have a header of one length, and volumes behind it. */
export interface HeaderFormat {
  readonly name: string;
  /** So many are read before `readHeader` is called, or fewer where the file is cut short. */
  readonly headerBytes: number;
  /** @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large` */
  readHeader(header: Uint8Array): VolumesBehindHeader;
}

/** Reads such a file, packed with gzip or not: its volumes as scans where the page asks for them, else the first of them. */
export async function readVolumes(
  { name, headerBytes, readHeader }: HeaderFormat,
  { bytes }: DecodeInput,
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedCartesianVolume> {
  const { onProgress, budget } = context;
  onProgress(0, bytes.length);
  const isPacked = isGzip(bytes);
  const atMost = isPacked ? bytes.length * maxDeflateRatio : bytes.length;
  const unpack = (): AsyncIterable<Uint8Array<ArrayBuffer>> => (isPacked ? gunzip(bytes) : yieldOnce(bytes));
  const reader = new PieceReader(unpack());
  try {
    const header = readHeader(await reader.readStart(headerBytes));
    const { grid, anatomical, type, littleEndian, count, offset, tail, readTimes } = header;
    const info = { grid, anatomical, unit: '', format: name };
    const size = countSampleBytes(`the ${name} header`, grid.dimensions, type);
    if (areScans(count, type, settings, context))
      return await openVolumes(
        { what: `the ${name} file`, pieces: unpack(), atMost, offset, bytes: size, count, tail },
        async (file) => {
          const timeOf = await readTimes?.(file, offset + count * size);
          return { info, type, littleEndian, ...(timeOf && { timeOf }) };
        },
        settings,
        context,
      );
    const source = { atMost, onProgress, budget };
    const span = await readSpan(reader, source, { what: name, offset, bytes: size, isPart: count > 1 });
    // As floats of 32 bits they take twice as many bytes more.
    if (type.name === 'float16') budget.take(2 * size, `the ${name} file`);
    const chooseWhole = await wholeNumbersOf(type);
    const stored = storeSamples(span, type, littleEndian, { slope: 1, intercept: 0, budget, chooseWhole });
    const { samples, scale, offset: intercept, indexed, rounded, unkept } = stored;
    return placeVolume(
      {
        ...info,
        samples,
        slope: scale,
        intercept,
        indexed,
        rounded,
        unkept,
        format: `${name}${count > 1 ? `, volume 1 of ${count}` : ''}`,
        ...listLeft(count),
      },
      settings,
    );
  } finally {
    await reader.stop();
  }
}
