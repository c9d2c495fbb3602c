import { expect } from '@esm-bundle/chai';
import { gunzipSync, gzipSync } from 'fflate';
import type { ScanTimes } from '../../../../src/formats/base/choose-scan.ts';
import { decodeBytes, fetchFixture, valuesOf } from '../../../helpers/decode.ts';
import { openScans } from '../../../helpers/scans-of.ts';

/** Of each volume: the mean of its values, the first one and the last one. */
type Expected = readonly (readonly [mean: number, first: number, last: number])[];

/** Source: nibabel 5.4.2, numpy 2.4, SimpleITK 2.5.7 and pynrrd 1.1.3, of the same files. */
const files: Readonly<Record<string, { readonly by: string; readonly volumes: Expected; readonly times?: ScanTimes }>> =
  {
    'formats/frames.mgz': {
      by: 'nibabel',
      volumes: [
        [-21967.066666666666, -32768.0, -11167.0],
        [-0.5, -10800.0, 10799.0],
        [21966.066666666666, 11166.0, 32767.0],
      ],
    },
    'formats/afni-series+orig.HEAD': {
      times: ['0 s', '2 s', '4 s'],
      by: 'nibabel',
      volumes: [
        [-10983.533333333333, -16384.0, -5583.5],
        [-1.0, -21600.0, 21598.0],
        [21966.066666666666, 11166.0, 32767.0],
      ],
    },
    'formats/minc-time.mnc': {
      times: ['0 s', '2 s', '4 s'],
      by: 'nibabel',
      volumes: [
        [45.32961013199054, -20, 110.65781643396659],
        [61, -4.327992675669492, 126.32799267566949],
        [76.67038986800948, 11.34218356603342, 142],
      ],
    },
    'formats/minc-times-scaled.mnc': {
      times: ['0 s', '2 s', '4 s'],
      by: 'nibabel',
      volumes: [
        [39.329610131990535, -20, 98.65781643396659],
        [43, -16.327992675669492, 102.32799267566949],
        [46.67038986800946, -12.65781643396658, 106],
      ],
    },
    'formats/series.npy': {
      by: 'numpy',
      volumes: [
        [-275.9166666666667, -32768.0, 32216.0],
        [274.81666666666666, -32217.0, 32767.0],
      ],
    },
    'metaimage/series.mha': {
      by: 'SimpleITK',
      volumes: [
        [26.5, -100.0, 153.0],
        [26.5, -100.0, 153.0],
      ],
    },
    'nrrd/list-first.nrrd': {
      by: 'pynrrd',
      volumes: [
        [26.5, -100.0, 153.0],
        [27.5, 154.0, -99.0],
      ],
    },
    'nrrd/list-last.nrrd': {
      by: 'pynrrd',
      volumes: [
        [26.5, -100.0, 153.0],
        [27.5, 154.0, -99.0],
      ],
    },
  };

/** Files of which every voxel is compared; test/fixtures/make-several-volumes.py asks nibabel and numpy. */
const everyVoxel = await readExpectedVolumes();

async function readExpectedVolumes(): Promise<
  { path: string; dimensions: number[]; affine: number[] | null; volumes: number[][] }[]
> {
  const text = new TextDecoder().decode(await fetchFixture('several-volumes.json'));
  return (JSON.parse(text) as { files: Awaited<ReturnType<typeof readExpectedVolumes>> }).files;
}

/** Values of which each slice has a scale of its own are stored as float32. */
const near = (value: number): number => 2e-7 * Math.max(1, Math.abs(value));

async function expectVolumes(
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  volumes: Expected,
  files?: readonly string[],
): Promise<ScanTimes> {
  const last = volumes.length - 1;
  const { first, times, read } = await openScans(bytes, name, { scan: { index: last }, files });
  expect(times).to.have.length(volumes.length);
  for (const [t, [mean, from, to]] of volumes.entries()) {
    const volume = await read(t);
    const values = valuesOf(volume);
    const where = `${name}, volume ${t}`;
    expect(values.reduce((sum, value) => sum + value, 0) / values.length, where).to.be.closeTo(mean, near(mean));
    expect(values[0], where).to.be.closeTo(from, near(from));
    expect(values.at(-1)!, where).to.be.closeTo(to, near(to));
    expect(volume.format).to.match(new RegExp(`, volume ${t + 1} of ${volumes.length}$`));
    expect(volume.left).to.equal(undefined);
    expect(volume.grid.indexToWorld).to.deep.equal(first.grid.indexToWorld);
    if (t === last) expect(values).to.deep.equal(valuesOf(first));
    expect(volume.window).to.deep.equal(first.window);
  }
  return times;
}

describe('volumes of a file as scans', () => {
  for (const [name, { by, volumes, times = volumes.map(() => null) }] of Object.entries(files)) {
    it(`${name}: as ${by} reads them, at the place of the file's first volume`, async () => {
      const bytes = await fetchFixture(name);
      expect(await expectVolumes(bytes.slice(), name, volumes)).to.deep.equal(times);
      const alone = await decodeBytes(bytes, name);
      expect(alone.left!.join()).to.contain('of the file');
      const { read } = await openScans(await fetchFixture(name), name);
      expect(valuesOf(await read(0))).to.deep.equal(valuesOf(alone));
      expect((await read(0)).grid).to.deep.equal(alone.grid);
      expect((await read(0)).anatomical).to.equal(alone.anatomical);
    });
  }

  it('of MGH have the time between two frames (TR), packed or not, wherever the pieces end', async () => {
    const packed = await fetchFixture('formats/frames.mgz');
    const plain = gunzipSync(packed);
    const { volumes } = files['formats/frames.mgz'];
    const end = 284 + 3 * 2 * 60;
    new DataView(plain.buffer, plain.byteOffset).setFloat32(end, 2500);
    for (const bytes of [plain.slice(), gzipSync(plain)])
      expect(await expectVolumes(bytes, 'x.mgz', volumes)).to.deep.equal(['0 s', '2.5 s', '5 s']);
    // Without what follows the samples the time is not known; a cut volume is an error.
    expect(await expectVolumes(plain.slice(0, end), 'x.mgh', volumes)).to.deep.equal([null, null, null]);
    const cut = await openScans(plain.slice(0, end - 1), 'x.mgh').catch((error: Error) => error.message);
    expect(cut).to.contain('ends early');
  });

  it('of AFNI have the times of the header, in its unit', async () => {
    const name = 'formats/afni-series+orig.HEAD';
    const head = new TextDecoder().decode(await fetchFixture(name));
    const withTimes = (code: number, first: number, step: number): Uint8Array<ArrayBuffer> =>
      new TextEncoder().encode(
        `${head}\ntype = integer-attribute\nname = TAXIS_NUMS\ncount = 3\n 3 0 ${code}\n\ntype = float-attribute\nname = TAXIS_FLOATS\ncount = 2\n ${first} ${step}\n`,
      );
    const timesOf = async (bytes: Uint8Array<ArrayBuffer>) => expectVolumes(bytes, name, files[name].volumes);
    expect(await timesOf(withTimes(77001, 500, 2000))).to.deep.equal(['0.5 s', '2.5 s', '4.5 s']);
    expect(await timesOf(withTimes(77002, 0, 1.3))).to.deep.equal(['0 s', '1.3 s', '2.6 s']);
    expect(await timesOf(withTimes(77003, 1, 1))).to.deep.equal(['1 Hz', '2 Hz', '3 Hz']);
    expect(await timesOf(withTimes(0, 0, 1))).to.deep.equal([null, null, null]);
  });

  it('of NRRD have times where an axis has a unit of time and a spacing', async () => {
    const text = async (lines: string): Promise<ScanTimes> => {
      const bytes = await fetchFixture('nrrd/list-last.nrrd');
      const [head, data] = splitHead(bytes);
      const changed = new TextEncoder().encode(`${head}\n${lines}\n\n`);
      const { times } = await openScans(new Uint8Array([...changed, ...data]), 'x.nrrd');
      return times;
    };
    expect(await text('units: "mm" "mm" "mm" "ms"\nspacings: nan nan nan 250')).to.deep.equal(['0 s', '0.25 s']);
    expect(await text('units: "mm" "mm" "mm" "s"\naxis mins: nan nan nan 3\nspacings: nan nan nan 2')).to.deep.equal([
      '4 s',
      '6 s',
    ]);
    expect(await text('units: "mm" "mm" "mm" "s"')).to.deep.equal([null, null]);
    expect(await text('spacings: nan nan nan 2')).to.deep.equal([null, null]);
  });

  for (const path of everyVoxel.map((file) => file.path)) {
    it(`${path}: every voxel of every volume, packed or not`, async () => {
      const { dimensions, affine, volumes } = everyVoxel.find((file) => file.path === path)!;
      const bytes = await fetchFixture(path);
      for (const given of path.endsWith('.npy') ? [bytes.slice(), gzipSync(bytes)] : [bytes.slice()]) {
        const { times, read } = await openScans(given, path);
        expect(times).to.deep.equal(volumes.map(() => null));
        for (const [t, expected] of volumes.entries()) {
          const volume = await read(t);
          expect(volume.grid.dimensions).to.deep.equal(dimensions);
          expect(valuesOf(volume), `volume ${t}`).to.deep.equal(expected);
          if (affine) expect(volume.grid.indexToWorld).to.deep.equal(affine);
          expect(volume.format).to.match(new RegExp(`^(Analyze 7.5|NPY), volume ${t + 1} of ${volumes.length}$`));
          expect(volume.left).to.equal(undefined);
        }
      }
      // Where a page wants no scans, the first one is shown at the same place.
      const alone = await decodeBytes(bytes, path);
      expect(valuesOf(alone)).to.deep.equal(volumes[0]);
      if (affine) expect(alone.grid.indexToWorld).to.deep.equal(affine);
    });
  }

  it('of Analyze say once what is not used of the header', async () => {
    const bytes = await fetchFixture('formats/analyze-series.hdr');
    bytes[252] = 2;
    const { first, read } = await openScans(bytes, 'formats/analyze-series.hdr');
    expect(first.left).to.have.length(1);
    expect(first.left![0]).to.contain('orient 2');
    expect((await read(1)).left).to.deep.equal(first.left);
  });

  it('of an array that is cut short are an error before memory is taken', async () => {
    const bytes = (await fetchFixture('formats/series-fortran.npy')).slice(0, -1);
    const words = await openScans(bytes, 'x.npy').catch((error: Error) => error.message);
    expect(words).to.contain('ends early');
  });
});

/** The header of an NRRD file without its empty line, and what follows. */
function splitHead(bytes: Uint8Array<ArrayBuffer>): [string, Uint8Array<ArrayBuffer>] {
  const at = bytes.findIndex((byte, i) => byte === 10 && bytes[i + 1] === 10);
  return [new TextDecoder('latin1').decode(bytes.subarray(0, at)), bytes.slice(at + 2)];
}
