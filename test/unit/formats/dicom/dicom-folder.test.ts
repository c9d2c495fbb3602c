// Files of a disk or of an archive: their starts are read first, and every eighth slice comes first.
import { expect } from '@esm-bundle/chai';
import { gzipSync, zipSync } from 'fflate';
import { Budget, bytesPerFileByte, freeBytes } from '../../../../src/formats/base/budget.ts';
import { decodeRequest } from '../../../../src/worker/decode-request.ts';
import type { CoarseVolume, LoadProgress } from '../../../../src/formats/base/load-request.ts';
import { chooseFirst } from '../../../../src/formats/dicom/coarse-part.ts';
import type { SourceSettings } from '../../../../src/formats/base/source-settings.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { expectError, roomyLimits, valuesOf } from '../../../helpers/decode.ts';
import { ctSlice, dicomBytes, packRle } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm } from '../../../helpers/dicom-bytes.ts';
import { decodeSeries } from '../../../helpers/dicom-series.ts';

const base = 'https://local-9.invalid/';
const pageOrigin = 'https://example.test';
const pixels = 96 * 96;

interface Opened {
  readonly volume: Volume;
  readonly coarse: readonly CoarseVolume[];
  readonly progress: readonly LoadProgress[];
  /** Bytes that were read of the files. */
  readonly read: number;
  readonly budget: Budget;
}

/** Does a task, and is told of all that is read of files meanwhile. @param onRead - gets bytes, and may throw instead of the disk */
async function watchReads<T>(onRead: (bytes: number) => void, task: () => Promise<T>): Promise<T> {
  const { arrayBuffer } = Blob.prototype;
  Blob.prototype.arrayBuffer = async function () {
    onRead(this.size);
    return arrayBuffer.call(this);
  };
  try {
    return await task();
  } finally {
    Blob.prototype.arrayBuffer = arrayBuffer;
  }
}

async function openFolder(
  files: readonly Uint8Array<ArrayBuffer>[],
  settings: SourceSettings = {},
  onRead: (bytes: number) => void = () => {},
): Promise<Opened> {
  let read = 0;
  const budget = new Budget(Infinity);
  const coarse: CoarseVolume[] = [];
  const progress: LoadProgress[] = [];
  const count = (bytes: number): void => {
    onRead(bytes);
    read += bytes;
  };
  const volume = await watchReads(count, () =>
    decodeRequest(
      {
        url: base,
        local: { base, files: files.map((bytes, i) => new File([bytes], `${i + 1}.dcm`)) },
        settings,
        limits: roomyLimits,
      },
      {
        pageOrigin,
        budget,
        onProgress: (one) => progress.push(one),
        onCoarse: (one) => one && coarse.push(one),
      },
    ),
  );
  return { volume, coarse, progress, read, budget };
}

/** Slices of 96 x 96 pixels: their files are longer than the start that is read of each. */
function slice(k: number, fields: DicomFields = {}, form: DicomForm & { readonly isPacked?: boolean } = {}) {
  const numbers = Int16Array.from({ length: pixels }, (_, i) => ((i * (k + 3)) % 1999) - 900);
  const { isPacked, ...rest } = form;
  return dicomBytes(
    {
      ...ctSlice(2 * k),
      Rows: [96],
      Columns: [96],
      PixelRepresentation: [1],
      PixelData: new Uint8Array(numbers.buffer),
      ...fields,
    },
    isPacked ? { ...rest, syntax: '1.2.840.10008.1.2.5', fragments: [packRle(numbers)] } : rest,
  );
}

const made = new Map<string, Uint8Array<ArrayBuffer>[]>();

function slices(count: number, fields?: DicomFields, form?: Parameters<typeof slice>[2]): Uint8Array<ArrayBuffer>[] {
  const key = JSON.stringify([count, fields, form]);
  const files = made.get(key) ?? Array.from({ length: count }, (_, k) => slice(k, fields, form));
  made.set(key, files);
  return [...files];
}

/** In another order than that of their places. */
const shuffle = <T>(all: readonly T[]): T[] => all.map((_, i) => all[(i * 7) % all.length]);

describe('a folder of DICOM', function () {
  this.timeout(60_000);

  for (const [what, files, settings] of [
    ['not packed', slices(34)],
    ['packed by runs', slices(40, {}, { isPacked: true })],
    ['implicit', slices(40, {}, { isImplicit: true })],
    ['deflated', slices(5, {}, { isDeflated: true })],
    ['with padding', slices(40, { PixelPaddingValue: [0x10000 - 900] })],
    ['of unlike scales', Array.from({ length: 34 }, (_, k) => slice(k, { RescaleSlope: [1 + (k % 3) / 4] }))],
    ['with a slice that is missing', slices(34).filter((_, k) => k !== 20)],
    [
      'with uneven places',
      Array.from({ length: 34 }, (_, k) => slice(k, { ImagePositionPatient: [0, 0, k > 20 ? 2 * k + 0.7 : 2 * k] })),
    ],
    ['with a long start', slices(34, { PatientComments: 'x'.repeat(20_000) })],
    [
      'with a start that is longer still',
      slices(34, { PatientComments: 'x'.repeat(60_000), ImageComments: 'y'.repeat(60_000) }),
    ],
    ['with a spacing of the page', slices(34), { spacing: [2, 3, 4] }],
    ['of two series', [...slices(34), ...slices(8, { SeriesInstanceUID: '7.7' })], { series: 2 }],
  ] as const satisfies readonly (readonly [string, readonly Uint8Array<ArrayBuffer>[], SourceSettings?])[]) {
    it(`has the same values and place as files that are read as a whole: ${what}`, async () => {
      const mixed = shuffle(files as readonly Uint8Array<ArrayBuffer>[]);
      const expected = await decodeSeries(mixed, settings);
      const { volume } = await openFolder(mixed, settings);
      const { samples, macrocells, source: _source, ...rest } = volume;
      const { samples: expectedSamples, macrocells: expectedCells, ...expectedRest } = expected;
      expect(samples).to.deep.equal(expectedSamples);
      expect(macrocells).to.deep.equal(expectedCells);
      expect(rest).to.deep.equal(expectedRest);
    });
  }

  it('shows every eighth slice before the others are read, at their places', async () => {
    const files = slices(44);
    const { volume, coarse, progress } = await openFolder(files);
    expect(coarse).to.have.length(1);
    const [{ volume: small, of }] = coarse;
    expect(small.coarse).to.equal(true);
    expect(small.grid).to.deep.include({ kind: 'cartesian', dimensions: [96, 96, 6] });
    expect(of.grid).to.deep.equal(volume.grid);
    expect(Object.keys(of)).not.to.include('samples');
    const first = chooseFirst(44);
    expect(first).to.deep.equal([3, 11, 18, 25, 33, 40]);
    const [all, few] = [valuesOf(volume), valuesOf(small)];
    first.forEach((k, i) =>
      expect(few.slice(i * pixels, (i + 1) * pixels)).to.deep.equal(all.slice(k * pixels, (k + 1) * pixels)),
    );
    expect(progress.at(-1)!.loaded).to.equal(progress.at(-1)!.total);
  });

  it('reports the bytes of all files together, and never goes back', async () => {
    for (const files of [slices(34), [...slices(34), ...slices(20, { SeriesInstanceUID: '7.7' })]]) {
      const { progress } = await openFolder(files);
      const known = progress.filter(({ total }) => total > 0);
      const shares = known.map(({ loaded, total }) => loaded / total);
      expect(shares.every((share, i) => i === 0 || share >= shares[i - 1])).to.equal(true);
      expect(shares.at(-1)).to.equal(1);
      expect(new Set(known.map(({ phase }) => phase))).to.deep.equal(new Set(['fetch']));
      expect(known.length).to.be.above(34);
    }
  });

  it('reads only the start of files of other series', async () => {
    const other = slices(20, { SeriesInstanceUID: '7.7' });
    const alone = await openFolder(slices(34));
    const both = await openFolder([...slices(34), ...other]);
    const size = other.reduce((sum, { length }) => sum + length, 0);
    // For the picture of each series one file is read.
    const pictures = other[0].length + slices(34)[0].length;
    expect(both.read - alone.read).to.equal(20 * 2 ** 14 + pictures);
    expect(both.read - alone.read).to.be.below(size);
  });

  it('reads each file in two pieces, of which several files have one', async () => {
    const reads: number[] = [];
    const files = slices(100);
    await openFolder(files, {}, (bytes) => reads.push(bytes));
    // The first 16 KiB of 32 files at once, then 32 files.
    expect(reads).to.have.length(4 + 4);
    const size = files.reduce((sum, { length }) => sum + length, 0);
    expect(reads.reduce((sum, bytes) => sum + bytes, 0)).to.equal(100 * 2 ** 14 + size);
  });

  it('reads files one by one where several at once can not be read', async () => {
    const files = slices(34);
    const { volume } = await openFolder(files, {}, (bytes) => {
      if (bytes > 1.5 * files[0].length) throw new DOMException('of the disk', 'NotReadableError');
    });
    expect(volume.samples).to.deep.equal((await decodeSeries(files)).samples);
  });

  it('may have each file packed with gzip', async () => {
    const files = [0, 1, 2].map((k) => slice(k));
    const packed = files.map((bytes) => gzipSync(bytes));
    const [{ volume }, { volume: plain }] = [await openFolder(packed), await openFolder(files)];
    expect(volume.grid.dimensions).to.deep.equal([96, 96, 3]);
    expect(valuesOf(volume)).to.deep.equal(valuesOf(plain));
  });

  it('with a file that can not be read any longer is an error that names its number', async () => {
    const files = slices(34);
    files[12] = slice(12, { PatientComments: 'x'.repeat(1000) });
    const error = await expectError(
      openFolder(files, {}, (bytes) => {
        if (bytes === files[12].length || bytes > 1.5 * files[0].length) throw new DOMException('', 'NotReadableError');
      }),
    );
    expect(error.code).to.equal('source/not-found');
    expect(error.message).to.match(/^file 13 of 34 .*can not be read/);
  });

  it('may take memory by the bytes of all files, each counted once', async () => {
    const files = slices(34);
    const { budget } = await openFolder(files);
    const counted = (budget.allowedBytes - freeBytes) / bytesPerFileByte;
    const size = files.reduce((sum, { length }) => sum + length, 0);
    expect(counted).to.be.within(size, size + 2 ** 14); // The start of the first one says the format.
  });

  it('stops where it is given up', async () => {
    const stop = new AbortController();
    let count = 0;
    const files = slices(300).map((bytes, i) => new File([bytes], `${i}.dcm`));
    let error: unknown;
    // To look at all takes 11 reads, and to read them 10 more.
    const onRead = (): void => void (++count === 14 && stop.abort());
    await watchReads(onRead, async () => {
      try {
        await decodeRequest(
          { url: base, local: { base, files }, limits: roomyLimits },
          { signal: stop.signal, pageOrigin, onProgress: () => undefined },
        );
      } catch (thrown) {
        error = thrown;
      }
      expect((error as Error).name).to.equal('AbortError');
      await new Promise((resolve) => setTimeout(resolve, 20));
      expect(count).to.be.below(17);
    });
  });

  it('with a file that is cut behind its start shows no data there', async () => {
    const files = slices(34);
    files[33] = files[33].slice(0, -100);
    const { volume } = await openFolder(files);
    expect(volume.left![0]).to.match(/^file 34 of 34: damaged, and its place shown as no data \(ends early/);
    const values = valuesOf(volume);
    expect(values.slice(-pixels).every(Number.isNaN)).to.equal(true);
    expect(values.slice(0, -pixels).some(Number.isNaN)).to.equal(false);
  });

  for (const level of [0, 6] as const) {
    it(`in a ZIP archive is unpacked file by file (level ${level})`, async () => {
      const files = slices(34);
      const zip = zipSync(Object.fromEntries(files.map((bytes, i) => [`a/${i + 1}.dcm`, bytes])), { level });
      const { volume, coarse, progress } = await openFolder([zip]);
      expect(volume.samples).to.deep.equal((await decodeSeries(files)).samples);
      expect(coarse).to.have.length(1);
      expect(progress.at(-1)!.loaded).to.equal(progress.at(-1)!.total);
    });
  }

  it('in a ZIP archive with a damaged entry shows no data there', async () => {
    const files = slices(34);
    const zip = zipSync(Object.fromEntries(files.map((bytes, i) => [`${i + 1}.dcm`, bytes])), { level: 0 });
    // Within the pixels of the 30th file: its checksum is wrong.
    zip[Math.floor(29.6 * (files[0].length + 60))] ^= 0xff;
    const { volume } = await openFolder([zip]);
    expect(volume.left![0]).to.match(/^file 30 of 34: damaged, and its place shown as no data \(.*can not be read/);
    expect(valuesOf(volume).filter(Number.isNaN)).to.have.length(pixels);
  });
});
