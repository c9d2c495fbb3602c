// Files of several frames and times in a list on a server: of each its start is read, and then the frames of the time that is shown.
import { expect } from '@esm-bundle/chai';
import type { LoadProgress } from '../../../src/formats/base/load-request.ts';
import type { ScanTimes } from '../../../src/formats/base/choose-scan.ts';
import type { ScanData } from '../../../src/formats/base/scan-data.ts';
import { decodeRequest } from '../../../src/worker/decode-request.ts';
import { expectError, roomyLimits } from '../../helpers/decode.ts';
import { dicomBytes, packRle } from '../../helpers/dicom-bytes.ts';
import type { DicomForm } from '../../helpers/dicom-bytes.ts';
import { numbersAt, timedFields } from '../../helpers/dicom-frames.ts';
import type { Scan } from '../../helpers/dicom-series.ts';
import { expectTime, timesOfFiles } from '../../helpers/dicomweb-times.ts';
import type { OpenScans } from '../../helpers/scans-of.ts';
import { serverOfFiles, withFiles } from '../../helpers/file-server.ts';
import type { Habits, Served } from '../../helpers/file-server.ts';

const [times, files, slices, edge] = [8, 3, 4, 72];
const frameBytes = 2 * edge * edge;
const list = Array.from({ length: files }, (_, i) => `${serverOfFiles}/patient-${i}.dcm`);

interface Order {
  readonly time: number;
  readonly slice: number;
}

/** Frames of a file as they lie in it: slice by slice all times, or time by time. */
function orderFrames(file: number, byTime: boolean): Order[] {
  const all = Array.from({ length: times * slices }, (_, i) => ({
    time: byTime ? Math.floor(i / slices) : i % times,
    slice: file * slices + (byTime ? i % slices : Math.floor(i / times)),
  }));
  return all;
}

/** Packing takes a while: each file is packed but once. */
const packed = new Map<number, Uint8Array<ArrayBuffer>[]>();
const shared = timedFields({ times: 1, slices: 1, edge: 1 });

/** A file of a part of the slices, at all times. @param formOf - how its frames are packed; undefined where they are not */
function makeFile(
  file: number,
  {
    byTime = false,
    formOf,
  }: { byTime?: boolean; formOf?: (pieces: readonly Uint8Array<ArrayBuffer>[]) => DicomForm } = {},
): Uint8Array<ArrayBuffer> {
  const order = orderFrames(file, byTime);
  const frames = order.map(({ time, slice }) => numbersAt(time, slice, edge));
  const pixels = new Uint8Array(frames.length * frameBytes);
  for (const [i, numbers] of frames.entries()) pixels.set(new Uint8Array(numbers.buffer), i * frameBytes);
  const bytes = dicomBytes(
    {
      ...shared,
      Rows: [edge],
      Columns: [edge],
      NumberOfFrames: String(frames.length),
      PatientComments: 'x'.repeat(9000),
      PerFrameFunctionalGroupsSequence: order.map(({ time, slice }) => ({
        FrameContentSequence: [{ TemporalPositionIndex: [time + 1] }],
        PlanePositionSequence: [{ ImagePositionPatient: [-1, -2, 3 * slice] }],
      })),
      PixelData: pixels,
    },
    formOf?.(packOnce(file, frames)),
  );
  if (file > 0) return bytes;
  // Files of less than a megabyte are read as a whole, which the first one says. Nothing behind the pixels is looked at.
  const long = new Uint8Array(2 ** 20);
  long.set(bytes);
  return long;
}

const runs = '1.2.840.10008.1.2.5';

function packOnce(file: number, frames: readonly Int16Array[]): Uint8Array<ArrayBuffer>[] {
  const pieces = packed.get(file) ?? frames.map((numbers) => packRle(numbers));
  packed.set(file, pieces);
  return pieces;
}

const startsOf = (pieces: readonly Uint8Array[], eachTakes: number): number[] =>
  pieces.map((_, i) => pieces.slice(0, i).reduce((sum, { length }) => sum + eachTakes + length, 0));

type FormOf = (pieces: readonly Uint8Array<ArrayBuffer>[]) => DicomForm;

const forms: Readonly<Record<string, FormOf>> = {
  'packed by runs': (pieces) => ({ syntax: runs, fragments: pieces, offsets: startsOf(pieces, 8) }),
  'packed by runs, in two pieces each': (pieces) => {
    const halves = pieces.flatMap((piece) => [piece.slice(0, 400), piece.slice(400)]);
    return { syntax: runs, fragments: halves, offsets: startsOf(pieces, 16) };
  },
};

interface Opened {
  readonly volume: Scan;
  readonly times: ScanTimes;
  readonly data: readonly ScanData[];
  readonly progress: readonly LoadProgress[];
}

async function open(index: number): Promise<Opened> {
  let [found, data]: [ScanTimes, readonly ScanData[]] = [[], []];
  const progress: LoadProgress[] = [];
  const volume = (await decodeRequest(
    { url: list[0], files: list, scan: { index }, limits: roomyLimits },
    {
      pageOrigin: serverOfFiles,
      onProgress: (one) => progress.push(one),
      onScans: (some, places = []) => ([found, data] = [some, structuredClone(places)]),
    },
  )) as Scan;
  return { volume, times: found, data, progress };
}

const show = (data: ScanData): Promise<Scan> =>
  decodeRequest(
    { url: list[0], limits: roomyLimits, data },
    { pageOrigin: serverOfFiles, onProgress: () => undefined },
  ) as Promise<Scan>;

const bytesOf = ({ sent }: Served, from = 0): number => sent.slice(from).reduce((sum, { bytes }) => sum + bytes, 0);

/** Runs with such a list on a server. */
async function withList(
  made: readonly Uint8Array<ArrayBuffer>[],
  habits: Habits,
  run: (served: Served, expected: OpenScans) => Promise<void>,
): Promise<void> {
  const expected = await timesOfFiles(made);
  await withFiles(new Map(made.map((bytes, i) => [list[i], bytes])), habits, (served) => run(served, expected));
}

const plain = list.map((_, i) => makeFile(i));

describe('a list of DICOM files of several frames and times on a server', function () {
  this.timeout(20_000);

  it('comes by the starts of its files, and then by the frames of the time that is shown', () =>
    withList(plain, {}, async (served, expected) => {
      const { volume, times: found, data } = await open(5);
      expect(found).to.have.length(times);
      await expectTime(volume, 5, expected);
      // The first file as a whole, which says the format, of each other one its start, and three slices of five times for one window.
      const [first, ...others] = served.sent;
      expect(first).to.deep.include({ isPart: false, bytes: plain[0].length });
      expect(others.every(({ isPart }) => isPart)).to.equal(true);
      const starts = (files - 1) * 2 ** 14;
      const frames = (bytesOf(served) - plain[0].length - starts) / frameBytes;
      expect(frames, 'frames of the other files').to.equal((files - 1) * slices + 2 * 5);
      for (const time of [7, 0, 5]) {
        const before = served.sent.length;
        await expectTime(await show(data[time]), time, expected);
        expect(bytesOf(served, before)).to.equal((files - 1) * slices * frameBytes);
      }
      expect(served.most()).to.be.at.most(6);
    }));

  it('asks for frames that lie together in one request', () =>
    withList(
      list.map((_, i) => makeFile(i, { byTime: true })),
      {},
      async (served, expected) => {
        const { data } = await open(0);
        const before = served.sent.length;
        await expectTime(await show(data[3]), 3, expected);
        expect(served.sent.slice(before).map(({ bytes }) => bytes)).to.deep.equal(
          Array(files - 1).fill(slices * frameBytes),
        );
      },
    ));

  for (const [what, formOf] of Object.entries(forms)) {
    it(`reads packed frames where the file says where each begins: ${what}`, () => {
      const made = list.map((_, i) => makeFile(i, { formOf }));
      return withList(made, {}, async (served, expected) => {
        const { volume, data } = await open(2);
        await expectTime(volume, 2, expected);
        const others = made.slice(1).reduce((sum, { length }) => sum + length, 0);
        expect(bytesOf(served) - made[0].length).to.be.below(0.6 * others);
        for (const time of [7, 0]) {
          const before = served.sent.length;
          await expectTime(await show(data[time]), time, expected);
          expect(bytesOf(served, before)).to.be.below(0.2 * others);
        }
      });
    });
  }

  const unlisted: FormOf = (pieces) => ({ syntax: runs, fragments: pieces });
  for (const [what, habits, formOf] of [
    ['its server sends no parts', { sendsNoParts: true }, undefined],
    ['its server hides sizes', { hidesSizes: true }, undefined],
    ['it does not say where its frames begin', {}, unlisted],
  ] as const) {
    it(`is read as a whole where ${what}`, () =>
      withList(
        list.map((_, i) => makeFile(i, { formOf })),
        habits,
        async (served, expected) => {
          const { volume, data } = await open(1);
          await expectTime(volume, 1, expected);
          const before = served.sent.length;
          await expectTime(await show(data[6]), 6, expected);
          expect(served.sent, 'nothing more').to.have.length(before);
        },
      ));
  }

  it('reports what has come of all, up to all, and never goes back', () =>
    withList(plain, {}, async () => {
      const { progress } = await open(2);
      const shares = progress
        .filter(({ phase, total }) => phase === 'fetch' && total > 0)
        .map(({ loaded, total }) => loaded / total);
      expect(shares.every((share, i) => i === 0 || share >= shares[i - 1])).to.equal(true);
      expect(shares.at(-1)).to.equal(1);
    }));

  it('of which a file is cut short, or has changed, says so without a name', async () => {
    const cut = plain.map((bytes, i) => (i === 1 ? bytes.slice(0, -frameBytes) : bytes));
    await withFiles(new Map(cut.map((bytes, i) => [list[i], bytes])), {}, async () => {
      const { volume } = await open(0);
      expect(volume.left!.join()).to.match(/^file 2 of 3: damaged/);
      expect(volume.left!.join()).not.to.match(/patient/);
    });
    const served = new Map(plain.map((bytes, i) => [list[i], bytes]));
    await withFiles(served, {}, async () => {
      const { data } = await open(0);
      served.set(list[2], plain[2].slice(0, 40_000));
      const { code, message } = await expectError(show(data[7]));
      expect(code).to.equal('format/corrupt');
      expect(message).to.match(/^file \d of \d of this time sent [\d,]+ bytes of its frames; expected/);
      expect(message).not.to.match(/patient/);
    });
  });

  it('of wrong places of frames is read as a whole, or is an error in words', async () => {
    const right = makeFile(0, { formOf: forms['packed by runs'] });
    const wrong: readonly ((starts: number[]) => number[])[] = [
      (starts) => starts.map(() => 0),
      (starts) => starts.map((_, i) => starts[starts.length - 1 - i]),
      (starts) => starts.map((start) => start + 2 ** 30),
      (starts) => starts.map((start) => start + 3),
    ];
    for (const change of wrong) {
      const formOf: FormOf = (pieces) => ({
        syntax: runs,
        fragments: pieces,
        offsets: change(startsOf(pieces, 8)),
      });
      const made = list.map((_, i) => (i === 0 ? right : makeFile(i, { formOf })));
      await withFiles(new Map(made.map((bytes, i) => [list[i], bytes])), {}, async () => {
        const opened = await open(0).catch((error: Error & { code?: string }) => error);
        if (opened instanceof Error) expect(opened.code).to.match(/^format\//);
      });
    }
  });
});
