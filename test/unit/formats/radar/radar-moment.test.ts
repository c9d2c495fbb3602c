import { expect } from '@esm-bundle/chai';
import { buildPolarVolume } from '../../../../src/formats/radar/build-polar-volume.ts';
import type { MomentKind } from '../../../../src/formats/radar/radar-file.ts';
import type { DecodeSettings } from '../../../../src/formats/base/decoded-volume.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { decodeBytes, expectError, fetchFixture } from '../../../helpers/decode.ts';
import { syntheticRadar } from '../../../helpers/synthetic-radar.ts';

const decodeManifest = (manifest: object, settings: DecodeSettings = {}): Promise<Volume> =>
  decodeBytes(new TextEncoder().encode(JSON.stringify(manifest)), 'a.json', settings);

const tiles = { image: 'mosaic/gray-3x2.png', mosaic: '3x2', elevations: [1, 2, 3, 4, 5, 6], range: [250, 500] };

describe('the moment of a radar', () => {
  it('of a mosaic whose manifest names it is that one, and another is reported with it', async () => {
    const manifest = { ...tiles, moment: 'DBZH' };
    for (const settings of [{}, { moment: 'DBZH' }])
      expect((await decodeManifest(manifest, settings)).radar).to.deep.include({ moment: 'DBZH', moments: ['DBZH'] });
    const scans = { ...tiles, image: undefined, scans: [{ image: tiles.image, moment: 'DBZH' }] };
    for (const one of [manifest, scans]) {
      const error = await expectError(decodeManifest(one, { moment: 'VRADH' }));
      expect([error.code, error.message]).to.deep.equal([
        'attribute/invalid',
        'moment got "VRADH"; expected one that the file holds: DBZH',
      ]);
    }
  });

  it('of a mosaic that nothing else names is what the attribute says', async () => {
    expect((await decodeManifest(tiles, { moment: 'VRADH' })).radar?.moment).to.equal('VRADH');
    const mosaic = { columns: 3, rows: 2 };
    const volume = await decodeBytes(await fetchFixture('mosaic/gray-3x2.png'), 'a.png', {
      mosaic,
      elevations: tiles.elevations,
      range: [250, 500],
      moment: 'VRADH',
    });
    expect(volume.radar?.moment).to.equal('VRADH');
  });

  it('of a radar file is that of its manifest, and the attribute goes before it', async () => {
    const file = { image: 'radar/odim-2.2.h5' };
    const { moment, moments } = (await decodeManifest(file)).radar!;
    const other = moments.find((one) => one !== moment)!;
    expect((await decodeManifest({ ...file, moment: other })).radar?.moment).to.equal(other);
    expect((await decodeManifest({ ...file, moment: other }, { moment })).radar?.moment).to.equal(moment);
    expect((await expectError(decodeManifest({ ...file, moment: 'NOPE' }))).message).to.contain(moments.join(', '));
  });
});

it('attributes of a radar mosaic go before its manifest', async () => {
  const volume = await decodeManifest(
    { ...tiles, mosaic: undefined, range: [100, 100] },
    { mosaic: { columns: 3, rows: 2 }, range: [250, 500] },
  );
  expect(volume.radar?.sweeps[0]).to.include({ firstGate: 250, gateLength: 500 });
});

describe('the quantity that nobody asked for', () => {
  const moments: [string, MomentKind][] = [
    ['TH', 'reflectivity'],
    ['VRADH', 'velocity'],
    ['DBZH', 'reflectivity'],
  ];
  const sweeps = [['TH', 'VRADH'], ['DBZH'], ['VRADH', 'DBZH']].map((of, i) => ({ elevation: 0.5 + i, moments: of }));

  it('is of the reflectivities the one that most sweeps hold, and is named', () => {
    // As in ../shared/data/reports/12-odim-variants/moments-differ.h5: TH in one sweep, DBZH in two (xradar 0.12).
    const { radar } = buildPolarVolume(syntheticRadar({ sweeps, moments }), {});
    expect(radar!.moment).to.equal('DBZH');
    expect(radar!.sweeps).to.have.length(2);
    expect(radar!.left, 'air that no other sweep shows').to.deep.equal(['sweep 1 at 0.5° holds no DBZH']);
    expect(radar!.details[0]).to.equal('DBZH is shown, as most sweeps hold it: 2 of 3 (TH 1)');
  });

  it('is the first of those that as many hold, and one that is asked for is not explained', () => {
    const same = buildPolarVolume(
      syntheticRadar({ sweeps: sweeps.slice(1).map((sweep) => ({ ...sweep, moments: ['TH', 'DBZH'] })), moments }),
      {},
    ).radar!;
    expect([same.moment, same.left.length]).to.deep.equal(['TH', 0]);
    expect(
      buildPolarVolume(syntheticRadar({ sweeps, moments }), { moment: 'TH' }).radar!.details.join(),
    ).not.to.contain('most sweeps');
  });

  it('has no radials of an antenna on its way to another elevation', () => {
    const file = syntheticRadar({
      sweeps: [{ elevation: 1, azimuths: [0, 10, 20, 30, 40, 50], gates: 2, stored: (azimuth) => 1 + azimuth }],
    });
    const [sweep] = file.sweeps;
    const { grid, samples, radar } = buildPolarVolume(
      { ...file, sweeps: [{ ...sweep, transitions: Uint8Array.of(1, 0, 0, 0, 1, 1) }] },
      {},
    );
    expect(radar!.sweeps[0].radials).to.equal(3);
    expect(radar!.details).to.deep.equal([
      '3 radials are left out: the antenna was on its way between sweeps (antenna_transition)',
    ]);
    const held = [...grid.sweeps[0].azimuths].filter((_, radial) => samples[radial * 2] > 0);
    expect(held).to.deep.equal([10, 20, 30]);
    expect([...samples].filter((value) => value > 0)).to.deep.equal([11, 11, 21, 21, 31, 31]);
  });
});
