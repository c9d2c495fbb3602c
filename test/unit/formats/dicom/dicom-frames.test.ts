// Files of several frames and times: the frames of one time are decoded, and the others when they are shown.
import { expect } from '@esm-bundle/chai';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { hasNumbers, hasSweeps, isFrame } from '../../../../src/formats/base/scan-data.ts';
import type { FramesOfFile, ScanData } from '../../../../src/formats/base/scan-data.ts';
import { decodeRequest } from '../../../../src/worker/decode-request.ts';
import { roomyLimits, urlOf, valuesOf } from '../../../helpers/decode.ts';
import { ctSlice, dicomBytes, packRle } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm } from '../../../helpers/dicom-bytes.ts';
import { mosaicFields, timedFields, timedFrames, valuesAt } from '../../../helpers/dicom-frames.ts';
import { openScans } from '../../../helpers/scans-of.ts';
import type { OpenScans } from '../../../helpers/scans-of.ts';

const size = { times: 4, slices: 8, edge: 6 };
const frameBytes = 2 * size.edge ** 2;
const fields = timedFields(size);

/** Slices of some times that are decoded for one window of all: three of each of four times. */
const looks = 3 * 4;

/** Counts the frames that are unpacked, by the memory that each takes meanwhile. */
class CountingBudget extends Budget {
  unpacked = 0;

  override take(bytes: number, what: string): void {
    // Three slices for one window take as much.
    if (bytes === 3 * frameBytes && what !== 'the DICOM series') this.unpacked++;
    super.take(bytes, what);
  }
}

const pieces = timedFrames(size).map((numbers) => packRle(numbers));
/** Each frame in two pieces, and where the first one of each begins. */
const halves = pieces.flatMap((piece) => [piece.slice(0, 40), piece.slice(40)]);
const starts = pieces.map((_, i) => pieces.slice(0, i).reduce((sum, { length }) => sum + 16 + length, 0));

const forms: Readonly<Record<string, DicomForm>> = {
  'not packed': {},
  'with implicit representations': { isImplicit: true },
  'without a preamble': { hasPreamble: false },
  deflated: { isDeflated: true },
  'packed by runs': { syntax: '1.2.840.10008.1.2.5', fragments: pieces },
  'packed by runs, in two pieces each': { syntax: '1.2.840.10008.1.2.5', fragments: halves, offsets: starts },
};

const filesOf = (data: ScanData): readonly (Blob | string | FramesOfFile)[] => {
  if (hasSweeps(data) || isFrame(data) || hasNumbers(data)) throw new Error('a time has no files');
  return (data.from as { files: readonly (Blob | string | FramesOfFile)[] }).files;
};

const open = (bytes: Uint8Array<ArrayBuffer>, index: number, budget: Budget): Promise<OpenScans> =>
  openScans(bytes.slice(), '1.dcm', { scan: { index }, budget });

describe('a DICOM file of several frames and times', () => {
  for (const [what, form] of Object.entries(forms)) {
    it(`decodes the frames of the time that is shown: ${what}`, async () => {
      const budget = new CountingBudget();
      const { first, times, data, read } = await open(dicomBytes(fields, form), 2, budget);
      expect(times).to.deep.equal([null, null, null, null]);
      expect(valuesOf(first)).to.deep.equal(valuesAt(2, size));
      expect(first.format).to.equal('DICOM, MR, volume 3 of 4');
      if (form.fragments) expect(budget.unpacked).to.equal(size.slices + looks);
      for (const time of [3, 0, 1, 2]) {
        budget.unpacked = 0;
        const volume = await read(time);
        expect(valuesOf(volume), `time ${time}`).to.deep.equal(valuesAt(time, size));
        expect(volume.grid).to.deep.equal(first.grid);
        expect(volume.window).to.deep.equal(first.window);
        if (form.fragments) expect(budget.unpacked, 'frames of this time').to.equal(size.slices);
        const [{ file, frames }, ...others] = filesOf(data[time]) as readonly FramesOfFile[];
        expect(others).to.have.length(0);
        expect(frames.map((frame) => frame % size.times)).to.deep.equal(Array(size.slices).fill(time));
        // What is before the pixels, and no other frames.
        if (!form.fragments && !form.isDeflated)
          expect(file.size).to.equal(dicomBytes(fields, form).length - (size.times - 1) * size.slices * frameBytes);
      }
    });
  }

  it('of which a frame is damaged says so where its time is shown', async () => {
    const damaged = pieces.map((piece, i) => (i === 4 * 3 + 2 ? piece.slice(0, 66) : piece));
    const bytes = dicomBytes(fields, { syntax: '1.2.840.10008.1.2.5', fragments: damaged });
    const { first, read } = await open(bytes, 0, new Budget());
    expect(first.left).to.equal(undefined);
    expect((await read(1)).left).to.equal(undefined);
    expect((await read(2)).left!.join()).to.match(/^file 1 of 1 of this time: damaged, and its place shown as no data/);
  });

  it('of a vector of times has each frame at its place, and its rescale', async () => {
    const groups = (fields.PerFrameFunctionalGroupsSequence as readonly DicomFields[]).map((group, i) => ({
      ...group,
      PixelValueTransformationSequence: [{ RescaleIntercept: String(-(i % size.times)), RescaleSlope: '2' }],
    }));
    const scaled = timedFields(size, { PerFrameFunctionalGroupsSequence: groups });
    const { read } = await open(dicomBytes(scaled), 0, new Budget());
    for (const time of [0, 3])
      expect(valuesOf(await read(time))).to.deep.equal(valuesAt(time, size).map((value) => 2 * value - time));
  });

  it('among other files of a folder is read in the same way, also one slice a file of all times', async () => {
    const files = Array.from({ length: 5 }, (_, k) => {
      const numbers = Uint16Array.from({ length: 36 }, (_, i) => 100 * Math.floor(i / 12) + 10 * k + (i % 12));
      return dicomBytes({
        ...ctSlice(0),
        ...fields,
        Rows: [3],
        Columns: [4],
        NumberOfFrames: '3',
        PixelData: new Uint8Array(numbers.buffer),
        PerFrameFunctionalGroupsSequence: [0, 1, 2].map((time) => ({
          FrameContentSequence: [{ TemporalPositionIndex: [time + 1] }],
          PlanePositionSequence: [{ ImagePositionPatient: [-1, -2, 3 * k] }],
        })),
      });
    });
    const base = 'https://local-5.invalid/';
    const load = { url: base, limits: roomyLimits };
    const environment = { pageOrigin: 'https://example.test', onProgress: () => undefined };
    let scans: readonly ScanData[] = [];
    const first = await decodeRequest(
      { ...load, scan: { index: 1 }, local: { base, files: files.map((one, i) => new File([one], `${i}.dcm`)) } },
      { ...environment, onScans: (_times, data = []) => (scans = structuredClone(data)) },
    );
    const expected = (time: number): number[] =>
      [0, 1, 2, 3, 4].flatMap((k) => Array.from({ length: 12 }, (_, i) => 100 * time + 10 * k + i));
    expect(valuesOf(first)).to.deep.equal(expected(1));
    expect(scans).to.have.length(3);
    for (const time of [2, 0]) {
      const volume = await decodeRequest({ ...load, data: scans[time] }, environment);
      expect(valuesOf(volume)).to.deep.equal(expected(time));
    }
  });
});

describe('a folder of mosaics of several times', () => {
  it('reads the picture of the time that is shown', async () => {
    const pad = 'x'.repeat(20_000);
    const edge = 2 * 8;
    const files = [0, 1, 2].map((time) =>
      dicomBytes({ ...mosaicFields(time, { edge, count: 3 }), PatientComments: pad }),
    );
    const urls = files.map((_, i) => urlOf(`${i}.dcm`));
    const { first, times, read } = await openScans(files[0].slice(), '0.dcm', {
      scan: { index: 1 },
      files: urls,
      fetchFile: async (url) => ({ bytes: files[urls.indexOf(url)].slice(), url, contentType: '' }),
    });
    expect(times).to.deep.equal(['0 s', '2 s', '4 s']);
    expect(first.grid).to.deep.include({ dimensions: [8, 8, 3] });
    const tiles = (time: number): number[] =>
      [0, 1, 2].flatMap((k) =>
        Array.from({ length: 64 }, (_, i) => {
          const [x, y] = [(i % 8) + 8 * (k % 2), Math.floor(i / 8) + 8 * Math.floor(k / 2)];
          return 1000 * time + y * edge + x;
        }),
      );
    expect(valuesOf(first)).to.deep.equal(tiles(1));
    for (const time of [2, 0]) expect(valuesOf(await read(time))).to.deep.equal(tiles(time));
  });
});
