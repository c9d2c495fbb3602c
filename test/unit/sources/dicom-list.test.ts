// Lists of DICOM files on servers: starts first, then every eighth slice, then the others, of both the middle ones first.
import { expect } from '@esm-bundle/chai';
import { decodeRequest } from '../../../src/worker/decode-request.ts';
import type { CoarseVolume, LoadProgress, LoadRequest } from '../../../src/formats/base/load-request.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { expectError, roomyLimits } from '../../helpers/decode.ts';
import { ctSlice, dicomBytes } from '../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../helpers/dicom-bytes.ts';
import { serverOfFiles, withFiles } from '../../helpers/file-server.ts';
import type { Asked, Habits, Served } from '../../helpers/file-server.ts';
import { decodeSeries } from '../../helpers/dicom-series.ts';

const origin = serverOfFiles;
const startBytes = 2 ** 14;

const edge = 96;

/** A slice whose file is longer than the start that is read of each. */
function slice(k: number, fields: DicomFields = {}): Uint8Array<ArrayBuffer> {
  const numbers = Int16Array.from({ length: edge * edge }, (_, i) => ((i * (k + 3)) % 1999) - 900);
  return dicomBytes({
    ...ctSlice(2 * k),
    Rows: [edge],
    Columns: [edge],
    PixelRepresentation: [1],
    PixelData: new Uint8Array(numbers.buffer),
    ...fields,
  });
}

const count = 44;
const sorted = Array.from({ length: count }, (_, k) => slice(k));

/** The place of the file in the list of the slice k: another order than that of their places. */
const fileOf = (i: number): number => (i * 7) % count;
const nameOf = (k: number): string => `slice-${k}.dcm`;

/** A list, in another order than that of the places. */
const list = Array.from({ length: count }, (_, i) => `${origin}/${nameOf(fileOf(i))}`);
const files = new Map(sorted.map((bytes, k) => [`${origin}/${nameOf(k)}`, bytes]));

interface Loaded {
  readonly volume: Volume;
  readonly coarse: readonly CoarseVolume[];
  readonly progress: readonly LoadProgress[];
  /** Requests before the coarse volume came. */
  readonly before: readonly Asked[];
}

async function load(request: Partial<LoadRequest>, served: Served, signal?: AbortSignal): Promise<Loaded> {
  const coarse: CoarseVolume[] = [];
  const progress: LoadProgress[] = [];
  let before: readonly Asked[] = [];
  const volume = await decodeRequest(
    { url: list[0], files: list, limits: roomyLimits, ...request },
    {
      pageOrigin: origin,
      signal,
      onProgress: (one) => progress.push(one),
      onCoarse: (one) => {
        if (!one) return;
        coarse.push(one);
        before = [...served.asked];
      },
    },
  );
  return { volume, coarse, progress, before };
}

const expectSame = async (volume: Volume): Promise<void> => {
  expect(volume.samples).to.deep.equal((await decodeSeries(sorted)).samples);
};

describe('a list of DICOM files on a server', function () {
  this.timeout(20_000);

  it('comes by its starts, then every eighth slice, then the others, of both the middle ones first', () =>
    withFiles(files, {}, async (served) => {
      const { volume, coarse, before } = await load({}, served);
      await expectSame(volume);
      expect(coarse).to.have.length(1);
      expect(coarse[0].volume.grid).to.deep.include({ dimensions: [edge, edge, 6] });
      expect(coarse[0].of.grid).to.deep.equal(volume.grid);
      const { asked } = served;
      expect(asked[0], 'the first file says the format').to.deep.equal({ name: nameOf(fileOf(0)), isPart: false });
      const starts = asked.slice(1, count);
      expect(starts.every(({ isPart }) => isPart)).to.equal(true);
      const whole = asked.slice(count).map(({ name }) => name);
      expect(new Set([...whole, nameOf(0)]).size, 'none twice').to.equal(count);
      const first = [18, 25, 11, 33, 3, 40].map(nameOf);
      expect(whole.slice(0, 6)).to.have.members(first);
      // Six requests are on their way when the last of these has come.
      expect(before.length - count).to.be.within(6, 12);
      const away = whole.slice(6).map((name) => Math.abs(Number(/\d+/.exec(name)![0]) - 21.5));
      expect(Math.max(...away.slice(0, 10))).to.be.below(9);
      expect(Math.min(...away.slice(-4))).to.be.above(16);
      expect(served.most()).to.equal(6);
    }));

  for (const [what, habits, requests] of [
    ['sends no parts', { sendsNoParts: true }, count],
    ['hides sizes', { hidesSizes: true }, 2 * count - 1],
    // Those that were on their way when the first one was refused.
    ['does not answer requests for parts', { refusesParts: true }, count + 6],
    ['packs parts', { packsParts: true }, count + 6],
  ] as const) {
    it(`is whole where the server ${what}`, () =>
      withFiles(files, habits, async (served) => {
        const { volume, coarse } = await load({}, served);
        await expectSame(volume);
        expect(coarse).to.have.length(1);
        expect(served.asked).to.have.length(requests);
        expect(served.most()).to.be.at.most(6);
      }));
  }

  for (const habits of [{}, { hidesSizes: true }, { sendsNoParts: true }]) {
    it(`reports what has come of all files, and never goes back: ${JSON.stringify(habits)}`, () =>
      withFiles(files, habits, async (served) => {
        const { progress } = await load({}, served);
        const fetched = progress.filter(({ phase }) => phase === 'fetch');
        const bytes = fetched.map(({ loaded }) => loaded);
        expect(bytes.every((n, i) => i === 0 || n >= bytes[i - 1])).to.equal(true);
        const shares = fetched.filter(({ total }) => total > 0).map(({ loaded, total }) => loaded / total);
        expect(shares.every((share, i) => i === 0 || share >= shares[i - 1])).to.equal(true);
        expect(shares.at(-1)).to.equal(1);
        expect(bytes.at(-1)).to.equal(sorted.reduce((sum, { length }) => sum + length, 0));
      }));
  }

  it('tries again where a failure may pass, and says which file is not there', async () => {
    await withFiles(files, { fail: (n) => (n === 9 || n === 60 ? 503 : undefined) }, async (served) => {
      await expectSame((await load({}, served)).volume);
    });
    const gone = `${origin}/${nameOf(25)}`;
    await withFiles(files, { fail: (_, url) => (url === gone ? 404 : undefined) }, async (served) => {
      const { code, message } = await expectError(load({}, served));
      expect([code, message.slice(0, gone.length)]).to.deep.equal(['source/not-found', gone]);
    });
  });

  it('asks for nothing more where it is given up', async () => {
    for (const after of [10, 50]) {
      const stop = new AbortController();
      const habits: Habits = { fail: (n) => void (n === after && stop.abort()) };
      await withFiles(files, habits, async (served) => {
        const failed = await load({}, served, stop.signal).catch((error: unknown) => error);
        expect((failed as Error).name).to.equal('AbortError');
        await new Promise((resolve) => setTimeout(resolve, 20));
        expect(served.asked.length).to.be.at.most(after + 7);
      });
    }
  });

  it('of few slices is fetched at once, each file in one request', () => {
    const few = list.slice(0, 20);
    return withFiles(files, {}, async (served) => {
      const { volume } = await load({ files: few }, served);
      expect(volume.grid).to.deep.include({ kind: 'cartesian' });
      expect(served.asked.map(({ isPart }) => isPart)).to.deep.equal(Array(20).fill(false));
    });
  });

  it('of a manifest looks from the first slices on as the manifest says', async () => {
    const manifest = { files: list.map((url) => url.slice(origin.length + 1)), title: 'A head', unit: 'x', slope: 2 };
    const url = `${origin}/volume.json`;
    const bytes = new TextEncoder().encode(JSON.stringify(manifest));
    await withFiles(new Map([...files, [url, bytes]]), {}, async (served) => {
      const { volume, coarse } = await load({ url, files: undefined }, served);
      await expectSame(volume);
      const look = ({ title, unit, slope, intercept, window }: Volume | CoarseVolume['of']): unknown => ({
        title,
        unit,
        slope,
        intercept,
        window,
      });
      expect(look(volume)).to.deep.include({ title: 'A head', unit: 'x' });
      expect(look(coarse[0].of)).to.deep.equal(look(volume));
      expect(look(coarse[0].volume)).to.deep.equal(look(volume));
      expect(served.asked.filter(({ isPart }) => isPart)).to.have.length(count - 1);
    });
  });

  it('of which the starts are longer than usual is whole', async () => {
    const long = sorted.map((_, k) => slice(k, { PatientComments: 'x'.repeat(startBytes) }));
    await withFiles(new Map(long.map((bytes, k) => [`${origin}/${nameOf(k)}`, bytes])), {}, async (served) =>
      expectSame((await load({}, served)).volume),
    );
  });
});
