import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { atlasLayout, packAtlas } from '../../../src/volume/atlas.ts';
import { parseMosaicSize } from '../../../src/volume/mosaic-size.ts';
import { checkMosaicLayout, cutMosaic, mosaicDimensions } from '../../../src/volume/mosaic.ts';
import type { GrayImage } from '../../../src/volume/mosaic.ts';

/** An image whose pixel at (x, y) is `value(x, y)`. */
function draw(width: number, height: number, value: (x: number, y: number) => number, deep = false): GrayImage {
  const data = deep ? new Uint16Array(width * height) : new Uint8Array(width * height);
  for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) data[y * width + x] = value(x, y);
  return { width, height, data };
}

describe('mosaic tiles', () => {
  it('read COLUMNSxROWS and nothing else', () => {
    expect(parseMosaicSize('10x10')).to.deep.equal({ columns: 10, rows: 10 });
    expect(parseMosaicSize(' 4 X 2 ')).to.deep.equal({ columns: 4, rows: 2 });
    for (const text of ['', '10', '0x4', '4x0', '-1x2', '1.5x2', '4x2x1', '4 2', '4xtwo', '1e3x2']) {
      expect(parseMosaicSize(text), text).to.equal(null);
    }
  });

  it('of whole pixels are copied exactly, row by row from the top left, unused ones left alone', () => {
    const image = draw(6, 4, (x, y) => 10 * y + x);
    const layout = checkMosaicLayout(image, { columns: 3, rows: 2 }, 5);
    expect(mosaicDimensions(image, layout)).to.deep.equal([2, 2, 5]);
    expect(Array.from(cutMosaic(image, layout))).to.deep.equal([
      0, 1, 10, 11, 2, 3, 12, 13, 4, 5, 14, 15, 20, 21, 30, 31, 22, 23, 32, 33,
    ]);
  });

  it('of 16 bits stay so', () => {
    const image = draw(4, 2, (x, y) => 30000 + 1000 * x + y, true);
    const samples = cutMosaic(image, checkMosaicLayout(image, { columns: 2, rows: 1 }));
    expect(samples).to.be.instanceOf(Uint16Array);
    expect(Array.from(samples)).to.deep.equal([30000, 31000, 30001, 31001, 32000, 33000, 32001, 33001]);
  });

  // 409.6 pixels, as in the aorta mosaic; 3.5, whose edges fall on pixel centres; 10.25 with a remainder each way.
  for (const [size, tiles] of [
    [4096, 10],
    [7, 2],
    [41, 4],
    [100, 7],
    [11, 6],
  ] as const) {
    it(`of ${size} / ${tiles} pixels hold no value of a neighbour`, () => {
      // A pixel belongs to the tile that its centre lies in; each tile has one value.
      const tileOf = (p: number): number => Math.floor(((p + 0.5) * tiles) / size + 1e-12);
      const image = draw(size, 2, (x) => 20 * tileOf(x) + 5);
      const layout = checkMosaicLayout(image, { columns: tiles, rows: 1 });
      const samples = cutMosaic(image, layout);
      const [nx, ny] = mosaicDimensions(image, layout);
      expect(nx).to.equal(Math.round(size / tiles));
      samples.forEach((value, i) => expect(value).to.equal(20 * Math.floor(i / (nx * ny)) + 5));
      const turned = draw(2, size, (_, y) => 20 * tileOf(y) + 5);
      cutMosaic(turned, checkMosaicLayout(turned, { columns: 1, rows: tiles })).forEach((value, i) =>
        expect(value).to.equal(20 * Math.floor(i / (nx * ny)) + 5),
      );
    });
  }

  it('of 10.25 pixels are sampled at equal distances', () => {
    const image = draw(41, 1, (x) => 1000 * x, true);
    const samples = cutMosaic(image, checkMosaicLayout(image, { columns: 4, rows: 1 }));
    for (let tile = 0; tile < 4; tile++) {
      for (let i = 0; i < 10; i++) {
        const position = 10.25 * tile + (i + 0.5) * 1.025 - 0.5;
        const first = Math.ceil(10.25 * tile - 0.5);
        const last = Math.ceil(10.25 * (tile + 1) - 0.5) - 1;
        expect(samples[tile * 10 + i]).to.be.closeTo(1000 * Math.min(last, Math.max(first, position)), 0.5 + 1e-6);
      }
    }
  });

  it('that do not fit are refused, with what to do', () => {
    const size = { width: 100, height: 50 };
    const refuse = (columns: number, rows: number, slices?: number): string => {
      try {
        checkMosaicLayout(size, { columns, rows }, slices);
      } catch (error) {
        expect(error).to.be.instanceOf(VolumeViewError);
        expect((error as VolumeViewError).code).to.equal('mosaic/layout');
        return (error as VolumeViewError).message;
      }
      throw new Error(`${columns}x${rows}, ${slices} was accepted`);
    };
    expect(refuse(101, 1)).to.contain('less than one pixel').and.to.contain('100 x 50');
    refuse(1, 51);
    refuse(0, 1);
    refuse(2.5, 1);
    refuse(-2, 2);
    expect(refuse(2, 2, 5)).to.contain('from 1 to 4');
    for (const slices of [0, -1, 1.5, NaN]) refuse(2, 2, slices);
    expect(checkMosaicLayout(size, { columns: 100, rows: 50 }).slices).to.equal(5000);
  });
});

describe('the 2D atlas', () => {
  it('is near square, and null where nothing fits', () => {
    expect(atlasLayout([410, 410, 96], 4100)).to.deep.equal({ columns: 10, rows: 10, width: 4100, height: 4100 });
    expect(atlasLayout([410, 410, 96], 4099)).to.equal(null);
    expect(atlasLayout([10, 10, 1], 10)).to.deep.equal({ columns: 1, rows: 1, width: 10, height: 10 });
    expect(atlasLayout([11, 1, 1], 10)).to.equal(null);
    const layout = atlasLayout([197, 233, 189], 4096);
    expect(layout).to.not.equal(null);
    expect(Math.max(layout!.width, layout!.height)).to.be.at.most(4096);
    expect(layout!.columns * layout!.rows).to.be.at.least(189);
  });

  it('holds every voxel in its tile', () => {
    const [nx, ny, nz] = [3, 2, 7];
    const samples = new Uint16Array(nx * ny * nz).map((_, i) => i + 1);
    const layout = atlasLayout([nx, ny, nz], 16)!;
    const atlas = packAtlas(samples, [nx, ny, nz], layout);
    expect(atlas).to.be.instanceOf(Uint16Array);
    const back = cutMosaic({ ...layout, data: atlas as Uint16Array<ArrayBuffer> }, { ...layout, slices: nz });
    expect(Array.from(back)).to.deep.equal(Array.from(samples));
  });

  it('is the same written in bands, whatever they cut', () => {
    const [nx, ny, nz] = [3, 4, 7];
    const samples = new Float32Array(nx * ny * nz).map((_, i) => i + 1);
    const layout = atlasLayout([nx, ny, nz], 16)!;
    const whole = Array.from(packAtlas(samples, [nx, ny, nz], layout));
    for (const rows of [1, 3, 5]) {
      const bands: number[] = [];
      for (let first = 0; first < layout.height; first += rows) {
        const count = Math.min(rows, layout.height - first);
        bands.push(...packAtlas(samples, [nx, ny, nz], layout, { first, count }));
      }
      expect(bands, `bands of ${rows} rows`).to.deep.equal(whole);
    }
  });
});
