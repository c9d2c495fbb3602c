import { expect } from '@esm-bundle/chai';
import { resolveAppearance } from '../../../../src/viewer/appearance/resolve-appearance.ts';
import type { ScanModel } from '../../../../src/viewer/model/scan-model.ts';
import { plainAppearance } from '../../../../src/viewer/model/plain-appearance.ts';
import type { AppearanceSettings } from '../../../../src/viewer/model/settings.ts';
import type { VolumeOptics } from '../../../../src/viewer/model/volume-info.ts';
import { evenAzimuths, radarVolume } from '../../../helpers/synthetic-radar.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

/** A ball in air. @param values - of air, and of the middle of the ball */
const ball = ([air, middle]: readonly [number, number], more: Partial<ScanModel> = {}): ScanModel => ({
  ...syntheticVolume({
    dimensions: [16, 16, 16],
    kind: 'float32',
    field: (x, y, z) => air + (middle - air) * Math.max(0, 1 - 2 * Math.hypot(x - 0.5, y - 0.5, z - 0.5)),
  }),
  ...more,
});

const mri = ball([0, 900]);
const ct = ball([-1000, 1200], { unit: 'HU', transferFunction: 'ct-bone' });
const statistics = ball([-4, 5], { transferFunction: 'diverging', window: [-5, 5] });
const labels = ball([0, 5], { transferFunction: '0.5 red 0, 0.5 red 20%', isDiscrete: true });
const mask = syntheticVolume({ dimensions: [8, 8, 8], kind: 'uint8', field: (x) => (x > 0.5 ? 1 : 0) });
const radar = radarVolume({ sweeps: [{ elevation: 1, azimuths: evenAzimuths(36), gates: 20, gateLength: 1000 }] });

const read = (named: string, volume: ScanModel, more: Partial<AppearanceSettings> = {}): Promise<VolumeOptics> =>
  resolveAppearance({ ...plainAppearance, ...more, named }, volume);

async function failure(reading: Promise<unknown>): Promise<string> {
  return reading.then(
    () => 'was read',
    (error: Error) => error.message,
  );
}

describe('a look by one word', () => {
  it('lights what is anatomy, and nothing whose colours are read as values', async () => {
    const lit = async (volume: ScanModel) => (await read('textbook', volume)).shading;
    expect(await lit(mri)).to.equal('lit');
    expect(await lit(ct)).to.equal('lit');
    expect(await lit({ ...mask, transferFunction: '40% #3d2418 0, 100% #fdebd3 18%' })).to.equal('lit');
    for (const flat of [statistics, labels, radar]) expect(await lit(flat)).to.equal('unlit');
    // A picture of theirs is that of the bare tag.
    for (const flat of [statistics, labels, radar])
      expect(await read('textbook', flat)).to.deep.equal(await resolveAppearance(plainAppearance, flat));
  });

  it('is flat where that is asked for', async () => {
    for (const volume of [mri, ct, statistics, labels, radar])
      expect(await read(' Flat ', volume)).to.deep.equal(
        await resolveAppearance({ ...plainAppearance, shading: 'unlit' }, volume),
      );
  });

  it('gives way to what the page says', async () => {
    const stops = '0 black 0, 100 white 5%';
    const own = await read('textbook', ct, { transferFunction: stops });
    expect(own.transferFunction).to.deep.equal(
      (await resolveAppearance({ ...plainAppearance, transferFunction: stops }, ct)).transferFunction,
    );
    // The factor goes with the preset.
    expect([own.opacityFactor, own.shading]).to.deep.equal([1, 'lit']);
    expect((await read('textbook', ct)).opacityFactor).to.equal(3);
    expect((await read('textbook', ct, { opacityFactor: 1 })).opacityFactor).to.equal(1);
    expect((await read('textbook', mri, { shading: 'unlit' })).shading).to.equal('unlit');
    expect((await read('xray', mri, { window: [3, 4] })).window).to.deep.equal([3, 4]);
    expect((await read('mip', mri, { projection: 'min' })).projection).to.equal('min');
  });

  it('shows means like an X-ray, from air to what rays through the middle have', async () => {
    for (const [volume, air] of [
      [mri, 0],
      [ct, -1000],
    ] as const) {
      const {
        projection,
        window: [low, high],
      } = await read('xray', volume);
      const full = volume.range[1] - air;
      expect(projection).to.equal('average');
      expect(low).to.be.closeTo(air, 0.01 * full);
      // A ray through the middle of the ball, whose values fall to 0 at its edge, has a half.
      expect((high - low) / full).to.be.within(0.25, 0.55);
    }
    expect((await read('xray', ball([-3000, 100], { unit: 'HU', transferFunction: 'ct-bone' }))).window[0]).to.equal(
      -1000,
    );
  });

  it('shows the largest values in a window that nearly all lie in', async () => {
    // 999 of 1,000 voxels of noise that rises evenly are below 99.9 % of it.
    const even = syntheticVolume({
      dimensions: [16, 16, 16],
      kind: 'float32',
      field: (x, y, z) => 900 * ((x - 1 / 32) * 0.9375 + (y - 1 / 32) * 0.0586 + (z - 1 / 32) * 0.00366),
    });
    expect((await read('mip', even)).window[1]).to.be.closeTo(0.999 * even.range[1], 0.01 * even.range[1]);
    expect((await read('mip', ct)).window[0]).to.equal(-100);
    expect((await read('mip', statistics)).window).to.deep.equal([-5, 5]);
  });

  it('has words for CT and for scans alone, and says so', async () => {
    for (const word of ['bone', 'skin', 'vessels']) expect((await read(word, ct)).shading).to.equal('lit');
    expect(await failure(read('bone', mri))).to.equal(
      'look got "bone"; expected textbook, flat, mip, xray, skin; "bone" is for CT, in Hounsfield units.',
    );
    expect(await failure(read('skin', radar))).to.equal(
      'look got "skin"; expected textbook, flat, mip; "skin" is for CT and MRI.',
    );
    // Of both signs, a mean is near 0: a blank picture would say nothing.
    expect(await failure(read('xray', statistics))).to.equal(
      'look got "xray"; expected textbook, flat, mip; "xray" is for CT and MRI.',
    );
    expect(await failure(read('mip', labels))).to.equal(
      'look got "mip"; expected textbook, flat; "mip" is for data that are no labels.',
    );
    expect(await failure(read('wax', ct))).to.equal(
      'look got "wax"; expected textbook, flat, mip, xray, skin, bone, vessels.',
    );
    expect(await failure(read('constructor', mri))).to.include('expected textbook');
  });
});
