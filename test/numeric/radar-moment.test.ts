import { expect } from '@esm-bundle/chai';
import type { DecodeSettings } from '../../src/formats/decoded-volume.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { decodeBytes, expectError, fetchFixture } from '../helpers/decode.ts';

const decodeManifest = (manifest: object, settings: DecodeSettings = {}): Promise<Volume> =>
  decodeBytes(new TextEncoder().encode(JSON.stringify(manifest)), 'a.json', settings);

const tiles = { image: 'mosaic/gray-3x2.png', mosaic: '3x2', elevations: [1, 2, 3, 4, 5, 6], range: [250, 500] };

describe('the moment of a radar', () => {
  it('of a mosaic whose manifest names it is that one, and another is told with it', async () => {
    const manifest = { ...tiles, moment: 'DBZH' };
    for (const settings of [{}, { moment: 'DBZH' }]) expect((await decodeManifest(manifest, settings)).radar).to.deep.include({ moment: 'DBZH', moments: ['DBZH'] });
    const scans = { ...tiles, image: undefined, scans: [{ image: tiles.image, moment: 'DBZH' }] };
    for (const one of [manifest, scans]) {
      const error = await expectError(decodeManifest(one, { moment: 'VRADH' }));
      expect([error.code, error.message]).to.deep.equal(['attribute/invalid', 'moment got "VRADH"; expected one that the file holds: DBZH']);
    }
  });

  it('of a mosaic that nothing else names is what the attribute says', async () => {
    expect((await decodeManifest(tiles, { moment: 'VRADH' })).radar?.moment).to.equal('VRADH');
    const mosaic = { columns: 3, rows: 2 };
    const volume = await decodeBytes(await fetchFixture('mosaic/gray-3x2.png'), 'a.png', { mosaic, elevations: tiles.elevations, range: [250, 500], moment: 'VRADH' });
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
  const volume = await decodeManifest({ ...tiles, mosaic: undefined, range: [100, 100] }, { mosaic: { columns: 3, rows: 2 }, range: [250, 500] });
  expect(volume.radar?.sweeps[0]).to.include({ firstGate: 250, gateLength: 500 });
});
