import { expect } from '@esm-bundle/chai';
import { encode } from 'fast-png';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { decodeBytes, expectError, fetchFixture } from '../../../helpers/decode.ts';
import { fetchSharedData } from '../../../helpers/shared-data.ts';

const settings = { mosaic: { columns: 3, rows: 2 } };
const load = async (name: string): Promise<Volume> => decodeBytes(await fetchFixture(`mosaic/${name}`), name, settings);
/** What the fixtures' tiles hold, see tile_values in make-fixtures.py: voxel i of 4 x 4 x 6. */
const valueAt = (i: number): number => 20 * Math.floor(i / 16) + (i % 16);
const all = (of: (i: number) => number): number[] => Array.from({ length: 96 }, (_, i) => of(i));

describe('mosaics from PNG', () => {
  for (const name of ['gray', 'rgb', 'rgba', 'gray-alpha', 'gamma']) {
    it(`${name}: the exact values, without colour management or alpha`, async () => {
      const volume = await load(`${name}-3x2.png`);
      expect(volume.samples).to.be.instanceOf(Uint8Array);
      expect(Array.from(volume.samples)).to.deep.equal(all(valueAt));
      expect(volume.format).to.equal('PNG mosaic');
    });
  }

  it('gray of 16 bits keeps them', async () => {
    const volume = await load('gray16-3x2.png');
    expect(volume.samples).to.be.instanceOf(Uint16Array);
    expect(Array.from(volume.samples)).to.deep.equal(all((i) => valueAt(i) * 400 + 7));
  });

  it('two channels of 8 bits make 16: the high byte in red, the low one in green', async () => {
    const values = Array.from({ length: 24 * 8 }, (_, i) => (i * 341) % 65536);
    const rgb = Uint8Array.from(values.flatMap((v) => [v >> 8, v & 255, 77]));
    const png = new Uint8Array(encode({ width: 24, height: 8, data: rgb, channels: 3, depth: 8 }));
    const settings16 = { mosaic: { columns: 3, rows: 1 }, channels: 'high-low' as const };
    const volume = await decodeBytes(png, 'a.png', settings16);
    expect(volume.samples).to.be.instanceOf(Uint16Array);
    const expected = [0, 1, 2].flatMap((tile) =>
      Array.from({ length: 64 }, (_, i) => values[Math.floor(i / 8) * 24 + tile * 8 + (i % 8)]),
    );
    expect(Array.from(volume.samples)).to.deep.equal(expected);
    const gray = await fetchFixture('mosaic/gray-3x2.png');
    const noColors = await expectError(decodeBytes(gray, 'a.png', { ...settings, channels: 'high-low' }));
    expect(noColors.code).to.equal('mosaic/layout');
    expect(noColors.message).to.match(/red and green/);
    const jpeg = await fetchFixture('mosaic/flat-3x2.jpg');
    const lossy = await expectError(decodeBytes(jpeg, 'a.jpg', { ...settings, channels: 'high-low' }));
    expect(lossy.code).to.equal('format/unsupported');
  });

  it('a palette of 4 bits, and one bit', async () => {
    expect(Array.from((await load('palette4-3x2.png')).samples)).to.deep.equal(all((i) => (valueAt(i) % 16) * 17));
    expect(Array.from((await load('bits1-3x2.png')).samples)).to.deep.equal(all((i) => (valueAt(i) % 2) * 255));
  });

  it('colours become luma', async () => {
    const volume = await load('colour-3x2.png');
    const lumaAt = (v: number): number =>
      Math.floor(0.2126 * v + 0.7152 * (255 - v) + 0.0722 * Math.floor(v / 2) + 0.5);
    expect(Array.from(volume.samples)).to.deep.equal(all((i) => lumaAt(valueAt(i))));
  });

  it('lies in the world as axial slices do', async () => {
    const volume = await decodeBytes(await fetchFixture('mosaic/gray-3x2.png'), 'a.png', {
      ...settings,
      spacing: [0.5, 0.5, 2],
    });
    expect(volume.grid.spacing).to.deep.equal([0.5, 0.5, 2]);
    expect(transformPoint(volume.grid.indexToWorld, [0, 0, 0])).to.deep.equal([0.75, 0.75, -5]);
    expect(transformPoint(volume.grid.indexToWorld, [3, 3, 5])).to.deep.equal([-0.75, -0.75, 5]);
  });

  it('with tiles of 10.25 pixels keeps its size in the world', async () => {
    const png = encode({ width: 41, height: 41, data: new Uint8Array(41 * 41).fill(9), channels: 1, depth: 8 });
    const volume = await decodeBytes(new Uint8Array(png), 'a.png', {
      mosaic: { columns: 4, rows: 4 },
      slices: 3,
      spacing: [2, 2, 5],
    });
    expect(volume.grid.dimensions).to.deep.equal([10, 10, 3]);
    expect(volume.grid.spacing[0] * 10).to.be.closeTo(20.5, 1e-12);
    expect(volume.samples.every((value) => value === 9)).to.equal(true);
  });

  it('too large for any device is refused by its header', async () => {
    const bytes = await fetchFixture('mosaic/gray-3x2.png');
    new DataView(bytes.buffer).setUint32(16, 2 ** 30);
    const error = await expectError(decodeBytes(bytes, 'a.png', settings));
    expect(error.code).to.equal('format/too-large');
    expect(error.message).to.contain('1073741824 x 8');
  });

  it('that does not fit its image is refused', async () => {
    const bytes = await fetchFixture('mosaic/gray-3x2.png');
    for (const [columns, rows, slices] of [
      [13, 1],
      [3, 9],
      [3, 2, 7],
    ]) {
      const error = await expectError(decodeBytes(bytes, 'a.png', { mosaic: { columns, rows }, slices }));
      expect(error.code).to.equal('mosaic/layout');
    }
  });
});

describe('mosaics from JPEG and WebP', () => {
  const flat = [0, 255, 40, 200, 90, 160];

  for (const name of ['flat-3x2.jpg', 'flat-3x2.webp']) {
    it(`${name}: each tile its own value`, async () => {
      const volume = await load(name);
      expect(volume.grid.dimensions).to.deep.equal([32, 32, 6]);
      // The codecs' own loss, in flat blocks of 16 pixels that tile edges do not cross.
      volume.samples.forEach((value, i) => expect(value).to.be.closeTo(flat[Math.floor(i / 1024)], 3));
      expect(volume.format).to.equal(name.endsWith('jpg') ? 'JPEG mosaic' : 'WebP mosaic');
    });
  }

  it('lossless WebP: the exact values', async () => {
    expect(Array.from((await load('lossless-3x2.webp')).samples)).to.deep.equal(all(valueAt));
  });
});

describe('the aorta mosaic of the 2011 paper', () => {
  it('has 96 slices of 410 voxels from tiles of 409.6 pixels', async function () {
    const bytes = new Uint8Array(await fetchSharedData(this, 'medical/aorta_mosaic/aorta4096.png'));
    const volume = await decodeBytes(bytes, 'aorta4096.png', { mosaic: { columns: 10, rows: 10 }, slices: 96 });
    expect(volume.grid.dimensions).to.deep.equal([410, 410, 96]);
    expect(volume.grid.spacing[0]).to.be.closeTo(409.6 / 410, 1e-12);
    expect(volume.range[1]).to.be.greaterThan(200);
  });
});
