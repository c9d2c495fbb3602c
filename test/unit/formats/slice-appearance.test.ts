// What a volume of one slice looks like where its file does not say it.
import { expect } from '@esm-bundle/chai';
import { finishVolume } from '../../../src/formats/finish-volume.ts';
import { colorSliceStops, ctSliceStops, sliceStops } from '../../../src/volume/slice-stops.ts';
import { applyNamedLook } from '../../../src/viewer/appearance/named-looks.ts';
import { withDefaultLook } from '../../../src/viewer/appearance/default-look.ts';
import { plainAppearance } from '../../../src/viewer/model/plain-appearance.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Samples, Volume } from '../../../src/volume/volume.ts';
import { roomyLimits } from '../../helpers/decode.ts';

type Given = Partial<Parameters<typeof finishVolume>[0]> & { readonly size?: Vector3 };

function finish(samples: Samples, { size = [200, 100, 1], ...given }: Given = {}): Promise<Volume> {
  const grid = cartesianGrid(size, axialIndexToWorld(size, [1, 1, 1]));
  const plain = { grid, samples, slope: 1, intercept: 0, unit: '', format: 'test' };
  return finishVolume({ ...plain, ...given } as Parameters<typeof finishVolume>[0], roomyLimits);
}

const count = 20000;
const sampled = (valueAt: (i: number) => number): Float32Array<ArrayBuffer> =>
  Float32Array.from({ length: count }, (_, i) => valueAt(i));
/** The numbers from 0 to 20,000, mixed. */
const mixed = (i: number): number => (i * 7919) % count;

/** Air, soft tissue and a little bone. */
const ct = (i: number): number => (i % 50 === 0 ? 900 : i % 2 ? -1000 : 40) + (mixed(i) % 30);

describe('a volume of one slice', () => {
  it('is a picture in gray of all its values but the few that lie apart', async () => {
    const { transferFunction, window } = await finish(sampled(mixed));
    expect(transferFunction).to.equal(sliceStops);
    // Half a percent at both ends, in steps of the histogram.
    expect(window![0]).to.be.within(0, 100);
    expect(window![1]).to.be.within(19900, 20000);
  });

  it('is as bright with a few values that are far from all others, and with a background of no data', async () => {
    for (const far of [1e6, -1e9, 3.4e38]) {
      const { window } = await finish(sampled((i) => (i % 1000 === 0 ? far : mixed(i))));
      expect(window![0]).to.be.within(0, 300);
      expect(window![1]).to.be.within(19700, 20000);
    }
    for (const noData of [-9999999, 1e9]) {
      const { window } = await finish(sampled((i) => (i % 5 < 2 ? noData : mixed(i))));
      expect(window![0]).to.be.within(0, 200);
      expect(window![1]).to.be.within(19800, 20000);
    }
    // Beside the background there may be little.
    const sparse = await finish(sampled((i) => (i % 500 === 0 ? 1000 + mixed(i) / 20 : 0)));
    expect(sparse.window![0]).to.equal(0);
    expect(sparse.window![1]).to.be.greaterThan(1900);
  });

  it('is so along any axis, and has the same look with no data and with one value', async () => {
    for (const size of [
      [1, 200, 100],
      [200, 1, 100],
    ] as const)
      expect((await finish(sampled(mixed), { size })).transferFunction).to.equal(sliceStops);
    const holes = await finish(sampled((i) => (i % 3 ? mixed(i) : NaN)));
    expect(holes).to.deep.include({ transferFunction: sliceStops, hasNoData: true });
    const flat = await finish(sampled(() => 5));
    expect(flat.transferFunction).to.equal(sliceStops);
    expect(flat.window).to.deep.equal([4.5, 5.5]);
    // Nothing is black.
    expect((await finish(sampled(() => 0))).window).to.deep.equal([0, 1]);
    for (const value of [0, 100, 255])
      expect((await finish(new Uint8Array(count).fill(value))).window).to.deep.equal([0, 255]);
  });

  it('shows grays of a screen as they are', async () => {
    const screen = await finish(Uint8Array.from({ length: count }, (_, i) => 20 + (mixed(i) % 150)));
    expect(screen).to.deep.include({ transferFunction: sliceStops, window: [0, 255] });
    // White is 0.
    const turned = await finish(
      Uint8Array.from({ length: count }, (_, i) => 20 + (mixed(i) % 150)),
      {
        slope: -1,
        intercept: 255,
      },
    );
    expect(turned).to.deep.include({ transferFunction: sliceStops, window: [0, 255] });
    const blackAndWhite = await finish(Uint8Array.from({ length: count }, (_, i) => 255 * Number(i % 200 > 90)));
    expect(blackAndWhite).to.deep.include({ transferFunction: sliceStops, window: [0, 255] });
    const bits = Uint8Array.from({ length: count }, (_, i) => Number(i % 200 > 90));
    expect(await finish(bits, { format: 'TIFF' })).to.deep.include({ transferFunction: sliceStops, window: [0, 1] });
    const dark = await finish(Uint8Array.from({ length: count }, (_, i) => 20 + (mixed(i) % 50)));
    expect(dark.window![1]).to.be.lessThan(72);
  });

  it('has the window of its file, and as a CT that of soft tissue', async () => {
    const ofFile = await finish(sampled(mixed), { window: [100, 300] });
    expect(ofFile).to.deep.include({ transferFunction: sliceStops, window: [100, 300] });
    for (const unit of ['HU', '']) {
      const volume = await finish(sampled(ct), { unit });
      expect(volume).to.deep.include({ transferFunction: ctSliceStops, window: [-160, 240] });
      // What is known of a CT stays so, also where its file says no unit.
      const { transferFunction } = applyNamedLook({ ...plainAppearance, window: null }, 'bone', volume);
      expect(transferFunction).to.equal('ct-bone');
    }
    expect((await finish(sampled(ct), { unit: 'HU', window: [-1350, 150] })).window).to.deep.equal([-1350, 150]);
    // Of a piece of a lung, nothing is soft tissue.
    const lung = (
      await finish(
        sampled((i) => -900 + mixed(i) / 100),
        { unit: 'HU' },
      )
    ).window!;
    expect(lung[0]).to.be.within(-900, -898);
    expect(lung[1]).to.be.within(-702, -700);
    // A body of 1 SUV with a small hot spot.
    const uptake = await finish(
      sampled((i) => (i % 500 === 0 ? 14 : mixed(i) / count)),
      { unit: 'SUV', isUptake: true },
    );
    expect(uptake).to.deep.include({ transferFunction: sliceStops, window: [0, 5] });
    // PET, in any unit.
    expect((await finish(sampled(mixed), { unit: 'Bq/ml', isUptake: true })).transferFunction).to.equal(sliceStops);
  });

  it('keeps the colours of labels, masks, statistics and reflectivities, and those of its file', async () => {
    const things = Uint8Array.from({ length: count }, (_, i) => Math.floor((i % 200) / 40) % 4);
    expect((await finish(things)).isDiscrete).to.equal(true);
    const mask = await finish(Uint8Array.from({ length: count }, (_, i) => Number(i % 200 > 90)));
    expect(mask.transferFunction).not.to.equal(sliceStops);
    const checks = await finish(Uint8Array.from({ length: count }, (_, i) => (i % 200 > 90 ? 220 : 20)));
    expect(checks.transferFunction).to.equal(sliceStops);
    const map = await finish(
      sampled((i) => 4 * Math.sin(mixed(i)) ** 9),
      { intent: 3 },
    );
    expect(map.transferFunction).to.equal('diverging');
    expect(
      (
        await finish(
          sampled((i) => mixed(i) / 300),
          { unit: 'dBZ' },
        )
      ).transferFunction,
    ).to.equal('radar-dbz');
    expect((await finish(sampled(mixed), { transferFunction: 'hot' })).transferFunction).to.equal('hot');
  });

  it('keeps the colours of both signs where 0 means nothing', async () => {
    const noise = (i: number): number => [1, 2, 3].reduce((sum, n) => sum + (mixed(n * i) % 1001) - 500, 0) / 100;
    const map = await finish(sampled((i) => (i % 200 < 70 ? 0 : noise(i))));
    expect(map.transferFunction).to.equal('diverging');
    // As a picture of an electron microscope is, whose mean is 0.
    expect((await finish(sampled((i) => noise(i) + 1e-3))).transferFunction).to.equal(sliceStops);
  });

  it('is gray where its file shows it as a picture, whatever its values are like', async () => {
    // Fields of some grays, as of a test picture: in a file that says nothing they could be labels.
    const fields = Uint8Array.from({ length: count }, (_, i) => 3 * ((Math.floor((i % 200) / 10) * 7) % 11));
    expect((await finish(fields)).isDiscrete).to.equal(true);
    const windows = [{ name: 'Window 1', from: 0, to: 40, width: 40, level: 20 }];
    for (const given of [
      { window: [0, 40], windows },
      { format: 'DICOM, US' },
      { transferFunction: sliceStops, window: [0, 40] },
    ] as const) {
      const { transferFunction, isDiscrete } = await finish(fields, given);
      expect({ transferFunction, isDiscrete }).to.deep.equal({ transferFunction: sliceStops, isDiscrete: undefined });
    }
    expect((await finish(fields, { format: 'DICOM, SEG', isLabels: true })).isDiscrete).to.equal(true);
    // Of few voxels, and of a mask whose file says that it is one.
    const rare = await finish(Uint8Array.from({ length: count }, (_, i) => Number(i === 77)));
    const said = await finish(
      fields.map((value) => (value > 9 ? 7 : 5)),
      { isLabels: true },
    );
    for (const mask of [rare, said]) expect(mask.transferFunction).to.match(/#6b4430/);
  });

  it('is not lit, and named looks are those of its kind', async () => {
    const volume = await finish(sampled(mixed));
    expect(withDefaultLook(plainAppearance, volume)).to.deep.equal(plainAppearance);
    const plain = { ...plainAppearance, window: null };
    expect(applyNamedLook(plain, 'skin', volume).shading).to.equal('lit');
    const inColors = { ...volume, transferFunction: colorSliceStops };
    expect(applyNamedLook(plain, 'mip', inColors)).to.deep.include({
      transferFunction: sliceStops,
      projection: 'max',
    });
    for (const one of [volume, await finish(sampled(ct), { unit: 'HU' })])
      expect(applyNamedLook(plain, 'textbook', one)).to.deep.equal(plain);
  });

  it('of two slices is a volume', async () => {
    // Of which one level of a pyramid may have one.
    const levels = [{ dimensions: [400, 200, 2] }] as never;
    expect((await finish(sampled(mixed), { levels })).transferFunction).to.equal(undefined);
    expect((await finish(sampled(mixed), { size: [100, 100, 2] })).transferFunction).to.equal(undefined);
    expect((await finish(sampled(mixed), { size: [20000, 1, 1] })).transferFunction).to.equal(undefined);
  });
});
