import { expect } from '@esm-bundle/chai';
import { gzipSync } from 'fflate';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { Budget } from '../../../../src/formats/base/budget.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { decodeBytes, expectError, fetchFile, valuesOf } from '../../../helpers/decode.ts';
import { niftiBytes } from '../../../helpers/nifti-bytes.ts';
import { openScans } from '../../../helpers/scans-of.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

/**
 * nibabel 5.4.2's functional.nii, of each volume: the SHA-256 (its first 16 digits) of the stored int16 numbers, and the mean of
 * the values. Source: `im.dataobj.get_unscaled()[..., t]` and `im.get_fdata()[..., t]` of nibabel 5.4.2, numpy in Fortran's order.
 */
const functional = [
  ['a937b51f91b1e283', 3626.2806277588415],
  ['4608936261cc7c64', 3626.6956125141082],
  ['cfb0cb4a850fdab3', 3630.804905058456],
  ['53921f5cf9c7aea0', 3645.3561969410025],
  ['9a7668bcceb41909', 3654.7832649512115],
  ['c2d4804b2cb64e1a', 3644.594241559005],
  ['7f0228e902c226a4', 3638.566542223555],
  ['cc81d6028e1d7640', 3633.892436698761],
  ['6040c211d9d2221c', 3637.7091135928054],
  ['d33af471a44e775f', 3636.6740455766576],
  ['d9f717a2046a7cf2', 3642.1392553956794],
  ['e0fcf5659856c62a', 3637.6615177844305],
  ['13e92ee4aefa48cd', 3645.534751630408],
  ['49da6a3737efc84e', 3640.2071190444694],
  ['aa2d7dfa4b0a840f', 3635.80922410585],
  ['8ed714d2abdcd1bd', 3635.374525110428],
  ['2ca11ffd2444c0c2', 3635.8637198982788],
  ['bcfd640330759e53', 3638.719750032761],
  ['4dd65edfc46e6da3', 3631.183840917439],
  ['6b77ed5c792b165a', 3630.3195827106356],
] as const;
/** Its scale, by nibabel. */
const [slope, intercept] = [0.07540696859359741, 3100.76171875];

async function digest(volume: Volume): Promise<string> {
  const stored = Int16Array.from(valuesOf(volume), (value) => Math.round((value - intercept) / slope));
  const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', stored));
  return Array.from(hash.subarray(0, 8), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;

/** A NIfTI file of 4 x 3 x 2 voxels and further axes; the voxels of volume t are 100 t, 100 t + 1 and so on. */
function series(axes: readonly number[], units = 2 | 8, step = 1.5): Uint8Array<ArrayBuffer> {
  const head = niftiBytes(syntheticVolume({ dimensions: [4, 3, 2] }));
  const count = axes.reduce((product, n) => product * n, 1);
  const bytes = new Uint8Array(352 + count * 48);
  bytes.set(head.subarray(0, 352));
  const view = new DataView(bytes.buffer);
  view.setInt16(40, 3 + axes.length, true);
  axes.forEach((n, i) => view.setInt16(48 + 2 * i, n, true));
  view.setInt16(70, 4, true);
  view.setFloat32(112, 1, true);
  view.setFloat32(116, 0, true);
  view.setFloat32(92, step, true);
  bytes[123] = units;
  for (let i = 0; i < count * 24; i++) view.setInt16(352 + 2 * i, 100 * Math.floor(i / 24) + (i % 24), true);
  return bytes;
}

const voxels = (t: number): number[] => Array.from({ length: 24 }, (_, i) => 100 * t + i);

describe('a NIfTI file of several times', () => {
  it("has every voxel of every time as nibabel reads it, packed or not, and the header's window for all", async () => {
    const bytes = await fetchFile('/demos/data/functional.nii');
    for (const file of [bytes.slice(), gzipSync(bytes, { level: 1 })]) {
      const { first, times, read } = await openScans(file, 'functional.nii', { scan: { index: 3 } });
      expect(times).to.deep.equal(Array.from({ length: 20 }, (_, t) => `${2 * t} s`));
      expect(await digest(first)).to.equal(functional[3][0]);
      for (const [t, [sha, average]] of functional.entries()) {
        const volume = await read(t);
        expect(await digest(volume), `volume ${t}`).to.equal(sha);
        expect(mean(valuesOf(volume))).to.be.closeTo(average, 1e-9 * average);
        expect(volume.format).to.equal(`NIfTI-1, volume ${t + 1} of 20`);
        expect(volume.left).to.equal(undefined);
        expect(volume.window).to.deep.equal(first.window);
      }
      expect(first.window![0]).to.be.closeTo(629.8262, 1e-3);
    }
  });

  it('in two files is the same, whichever of them is given', async () => {
    const bytes = await fetchFile('/demos/data/functional.nii');
    const head = bytes.slice(0, 348);
    head.set([0x6e, 0x69, 0x31], 344);
    new DataView(head.buffer).setFloat32(108, 0, true);
    new DataView(head.buffer).setFloat32(136, 1.5, true);
    const files = new Map([
      ['x.hdr', head],
      ['x.img', bytes.slice(352)],
      ['x.img.gz', gzipSync(bytes.subarray(352), { level: 1 })],
    ]);
    for (const [name, without] of [
      ['x.hdr', 'x.img.gz'],
      ['x.img', 'x.img.gz'],
      ['x.hdr', 'x.img'],
    ]) {
      const { times, read, first } = await openScans(files.get(name)!.slice(), name, {
        scan: { index: 19 },
        fetchFile: async (url) => {
          const other = new URL(url).pathname.slice(1);
          const found = other === without ? undefined : files.get(other);
          if (!found) throw new VolumeViewError('source/not-found', 'no such file');
          return { bytes: found.slice(), url, contentType: '' };
        },
      });
      expect(times.slice(0, 2)).to.deep.equal(['1.5 s', '3.5 s']);
      expect(await digest(first)).to.equal(functional[19][0]);
      expect(await digest(await read(7))).to.equal(functional[7][0]);
    }
  });

  it('has one window for all, whichever is shown first, where the header gives none', async () => {
    const opened = await Promise.all([0, 2].map((index) => openScans(series([3]), 'x.nii', { scan: { index } })));
    const windows = [
      ...opened.map(({ first }) => first.window),
      ...(await Promise.all([0, 1, 2].map((t) => opened[0].read(t)))).map(({ window }) => window),
    ];
    for (const window of windows) expect(window).to.deep.equal(windows[0]);
    expect(windows[0]![1]).to.be.above(100);
  });

  it('is fetched in ranges where its start says what it is', async () => {
    const whole = series([5]);
    const asked: (readonly [number, number])[] = [];
    const { first, read } = await openScans(whole.slice(0, 400), 'x.nii', {
      scan: { index: 4 },
      input: { missing: whole.length - 400 },
      fetchFile: async (url, range) => {
        asked.push([range!.start, range!.end]);
        return { bytes: whole.slice(range!.start, range!.end), url, contentType: '' };
      },
    });
    expect(valuesOf(first)).to.deep.equal(voxels(4));
    expect(asked.at(-1)).to.deep.equal([352 + 4 * 48, 352 + 5 * 48]);
    expect(valuesOf(await read(1))).to.deep.equal(voxels(1));
    expect(asked.at(-1)).to.deep.equal([352 + 48, 352 + 96]);
  });

  for (const [what, units, times] of [
    ['seconds', 8, ['0 s', '1.5 s', '3 s']],
    ['milliseconds', 16, ['0 s', '0.0015 s', '0.003 s']],
    ['hertz', 32, ['0 Hz', '1.5 Hz', '3 Hz']],
    ['nothing', 0, [null, null, null]],
  ] as const) {
    it(`counts ${what} where its header says so`, async () => {
      expect((await openScans(series([3], 2 | units), 'x.nii')).times).to.deep.equal(times);
    });
  }

  it('has no times where the step is none', async () => {
    for (const step of [0, -1, NaN, Infinity])
      expect((await openScans(series([2], 10, step), 'x.nii')).times).to.deep.equal([null, null]);
  });

  it('has the first number of each voxel where there are several, and volumes along further axes', async () => {
    const several = await openScans(series([2, 3]), 'x.nii');
    expect(several.data.length).to.equal(2);
    expect(valuesOf(await several.read(1))).to.deep.equal(voxels(1));
    expect(several.first.left).to.deep.equal(['numbers 2 to 3 of each voxel']);
    const further = await openScans(series([1, 1, 4]), 'x.nii');
    expect(further.times).to.deep.equal([null, null, null, null]);
    expect(valuesOf(await further.read(3))).to.deep.equal(voxels(3));
  });

  it('is its first volume where nobody asks for scans, as a layer or labels', async () => {
    const volume = await decodeBytes(series([3]), 'x.nii');
    expect(valuesOf(volume)).to.deep.equal(voxels(0));
    expect(volume.left).to.deep.equal(['volumes 2 to 3 of the file']);
  });

  it('is refused in words where it is cut, or says more than it holds', async () => {
    const bytes = series([5]);
    const cut = await expectError(openScans(bytes.slice(0, 480), 'x.nii'));
    expect(cut.code).to.equal('format/corrupt');
    expect(cut.message).to.equal(
      'the NIfTI file ends early: got at most 480 bytes; its header asks for 592 bytes, 5 volumes of 48',
    );
    const packed = gzipSync(bytes.slice(0, 480));
    expect((await expectError(openScans(packed, 'x.nii.gz'))).message).to.include('ends early: got 480 bytes');
    const broken = gzipSync(bytes);
    broken[broken.length - 8] ^= 1;
    expect((await expectError(openScans(broken, 'x.nii.gz'))).code).to.equal('format/corrupt');
    new DataView(bytes.buffer).setInt16(48, 32_000, true);
    expect((await expectError(openScans(bytes.slice(), 'x.nii'))).message).to.include('32,000 volumes of 48');
    const served = openScans(bytes.slice(0, 400), 'x.nii', { input: { missing: 192 } });
    expect((await expectError(served)).message).to.include('ends early: got 592 bytes');
  });

  it('of a thousand million times is refused before memory is taken', async () => {
    const view = new DataView(new ArrayBuffer(600));
    view.setInt32(0, 540, true);
    [0x6e, 0x2b, 0x32, 0, 13, 10, 26, 10].forEach((byte, i) => view.setUint8(4 + i, byte));
    view.setInt16(12, 4, true);
    [4, 4, 3, 2, 1_000_000_000].forEach((n, i) => view.setBigInt64(16 + 8 * i, BigInt(n), true));
    view.setBigInt64(168, 544n, true);
    const error = await expectError(openScans(new Uint8Array(view.buffer), 'x.nii'));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.include('1,000,000,000 volumes of 48');
  });

  it('keeps as many volumes as memory allows, and says which ones are left out', async () => {
    const packed = gzipSync(series([300]));
    const { data, first } = await openScans(packed, 'x.nii.gz', { budget: new Budget(4800) });
    expect(data.length).to.equal(50);
    expect(first.left![0]).to.match(/^volumes 51 to 300 of the file: unpacked, they take more memory/);
  });
});
