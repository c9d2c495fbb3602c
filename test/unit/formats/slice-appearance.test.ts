// What a volume of one slice looks like where its file does not say it.
import { expect } from '@esm-bundle/chai';
import { finishVolume } from '../../../src/formats/finish-volume.ts';
import { sliceStops } from '../../../src/volume/slice-stops.ts';
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
    const spot = await finish(sampled((i) => (i % 1000 === 0 ? 1e6 : mixed(i))));
    expect(spot.window![1]).to.be.lessThan(0.03 * 1e6);
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
    expect(flat.window![1]).to.be.greaterThan(flat.window![0]);
  });

  it('shows grays of a screen as they are', async () => {
    const screen = await finish(Uint8Array.from({ length: count }, (_, i) => 20 + (mixed(i) % 150)));
    expect(screen).to.deep.include({ transferFunction: sliceStops, window: [0, 255] });
    const dark = await finish(Uint8Array.from({ length: count }, (_, i) => 20 + (mixed(i) % 50)));
    expect(dark.window![1]).to.be.lessThan(72);
  });

  it('has the window of its file, and as a CT that of soft tissue', async () => {
    const ofFile = await finish(sampled(mixed), { window: [100, 300] });
    expect(ofFile).to.deep.include({ transferFunction: sliceStops, window: [100, 300] });
    for (const unit of ['HU', ''])
      expect(await finish(sampled(ct), { unit })).to.deep.include({
        transferFunction: sliceStops,
        window: [-160, 240],
      });
    expect((await finish(sampled(ct), { unit: 'HU', window: [-1350, 150] })).window).to.deep.equal([-1350, 150]);
    // PET, in any unit.
    expect((await finish(sampled(mixed), { unit: 'Bq/ml', isUptake: true })).transferFunction).to.equal(sliceStops);
  });

  it('keeps the colours of labels, masks, statistics and reflectivities, and those of its file', async () => {
    const things = Uint8Array.from({ length: count }, (_, i) => Math.floor((i % 200) / 40) % 4);
    expect((await finish(things)).isDiscrete).to.equal(true);
    const mask = await finish(Uint8Array.from({ length: count }, (_, i) => Number(i % 200 > 90)));
    expect(mask.transferFunction).not.to.equal(sliceStops);
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

  it('is not lit, and named looks are those of its kind', async () => {
    const volume = await finish(sampled(mixed));
    expect(withDefaultLook(plainAppearance, volume)).to.deep.equal(plainAppearance);
    const plain = { ...plainAppearance, window: null };
    expect(applyNamedLook(plain, 'skin', volume).shading).to.equal('lit');
    const ofCt = await finish(sampled(ct), { unit: 'HU' });
    expect(applyNamedLook(plain, 'bone', ofCt).transferFunction).to.equal('ct-bone');
  });

  it('of two slices is a volume', async () => {
    expect((await finish(sampled(mixed), { size: [100, 100, 2] })).transferFunction).to.equal(undefined);
    expect((await finish(sampled(mixed), { size: [20000, 1, 1] })).transferFunction).to.equal(undefined);
  });
});
