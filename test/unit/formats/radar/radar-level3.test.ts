import { expect } from '@esm-bundle/chai';
import { gzipSync } from 'fflate';
import { readLevel3 } from '../../../../src/formats/radar/level3.ts';
import { nearestOnly } from '../../../../src/volume/polar-grid.ts';
import { bzip2 } from '../../../fuzz/grammars/bzip2-writer.ts';
import { decodeBytes, expectError, fetchFixture } from '../../../helpers/decode.ts';
import { buildLevel3, builtProducts } from '../../../helpers/level3-builder.ts';
import { gateValues } from '../../../helpers/radar.ts';

/** What Py-ART reads of each built product, radial by radial; null for no data. */
const expected = JSON.parse(new TextDecoder().decode(await fetchFixture('level3-values.json'))) as Record<
  string,
  (number | null)[]
>;

/** Py-ART gives these in knots, as the file has them. */
const inKnots = new Set(['velocity27']);

const pack = (bytes: Uint8Array): Uint8Array => bzip2(bytes);

describe('NEXRAD Level III', () => {
  for (const [name, product] of Object.entries(builtProducts)) {
    it(`${name}: every gate as Py-ART has it, packed or not`, async () => {
      for (const bytes of [
        buildLevel3(product),
        buildLevel3({ ...product, pack }),
        new Uint8Array(gzipSync(buildLevel3(product))),
      ]) {
        const { sweeps, moments } = await readLevel3(bytes);
        const data = sweeps[0].read(moments[0].name)!;
        const values = gateValues(data);
        expect(values.length).to.equal(expected[name].length);
        expected[name].forEach((value, i) => {
          const wanted = inKnots.has(name) && value !== null ? (value * 1852) / 3600 : value;
          // Py-ART's numbers have 32 bits.
          if (wanted === null) expect(Number.isNaN(values[i]), `gate ${i}`).to.equal(true);
          else expect(values[i], `gate ${i}`).to.be.closeTo(wanted, 1e-6 * Math.max(1, Math.abs(wanted)));
        });
      }
    });
  }

  it('has its radar, time, elevation, the middles of radials, and gates along the beam', async () => {
    const file = await readLevel3(buildLevel3(builtProducts.reflectivity94));
    // Py-ART 2.3.0: 33.172, -86.77, 231.3432 m, 2015-01-02T02:05:33Z, 3.4 degrees; radials start at 355.5, 356.5 ...
    expect(file.site).to.deep.equal({ name: 'BMX', latitude: 33.172, longitude: -86.77, height: 759 * 0.3048 });
    expect(file.time).to.equal('2015-01-02T02:05:33Z');
    const [sweep] = file.sweeps;
    expect(sweep.elevation).to.equal(3.4);
    expect([...sweep.azimuths]).to.deep.equal([356, 357, 358, 359]);
    expect(sweep.gridOf('REF')).to.deep.equal({ firstGate: 500, gateLength: 1000, gates: 5 });
    expect(sweep.gridOf('VEL')).to.equal(null);
    const [fine] = (await readLevel3(buildLevel3(builtProducts.reflectivity153))).sweeps;
    expect([...fine.azimuths]).to.deep.equal([0.25, 0.75, 1.25, 1.75]);
    expect(fine.gridOf('REF')).to.deep.equal({ firstGate: 125, gateLength: 250, gates: 5 });
  });

  it('is shown as one sweep, known by its bytes', async () => {
    const volume = await decodeBytes(buildLevel3({ ...builtProducts.velocity99, pack }), 'KBMX_N0U_20150102');
    expect(volume.format).to.equal('NEXRAD Level III, product 99');
    expect([volume.unit, volume.radar!.moment, volume.radar!.sweeps.length]).to.deep.equal(['m/s', 'VEL', 1]);
    expect(volume.range).to.deep.equal([-63.5, 63]);
  });

  it('of kinds of echo says what its numbers stand for, mixes none, and has one colour for a kind in all files', async () => {
    const volume = await decodeBytes(buildLevel3(builtProducts.classes165), 'N0H');
    const { radar, grid, window, transferFunction } = volume;
    expect(radar!.left).to.deep.equal([]);
    expect(radar!.details.join()).to.contain('60 rain');
    expect(grid.kind === 'polar' && grid.foldFrom).to.equal(nearestOnly);
    expect({ window, transferFunction }).to.deep.equal({ window: [0, 140], transferFunction: 'turbo' });
    const other = await decodeBytes(buildLevel3({ ...builtProducts.classes165, numbers: [[60, 70]] }), 'N0H');
    expect(other.window).to.deep.equal(window);
    expect((await decodeBytes(buildLevel3(builtProducts.ratio159), 'N0X')).radar!.details).to.deep.equal([]);
  });

  it('that was cut short shows the radials before the cut, and says so', async () => {
    const whole = buildLevel3(builtProducts.reflectivity94);
    const { sweeps, partial } = await readLevel3(whole.slice(0, -13));
    expect(sweeps[0].azimuths.length).to.equal(2);
    expect(partial).to.contain('2 of 4 radials');
    expect((await expectError(readLevel3(whole.slice(0, 180)))).code).to.equal('format/corrupt');
  });

  it('of other products is refused in words, with a program that converts it', async () => {
    for (const [bytes, code, words] of [
      [buildLevel3({ ...builtProducts.reflectivity94, code: 135 }), 'format/unsupported', /product 135.*Toolkit/],
      [
        buildLevel3({ ...builtProducts.reflectivity94, wrong: { packet: 28 } }),
        'format/unsupported',
        /a packet 28 first.*Toolkit/,
      ],
      [buildLevel3({ ...builtProducts.reflectivity94, wrong: { radials: 0 } }), 'format/corrupt', /0 radials/],
      [buildLevel3({ ...builtProducts.reflectivity94, wrong: { radials: 0xffff } }), null, null],
      [buildLevel3({ ...builtProducts.reflectivity94, wrong: { bytes: 0xffff } }), 'format/corrupt', /no whole radial/],
      [buildLevel3({ ...builtProducts.ratio159, levels: { scale: 0, offset: 1 } }), 'format/corrupt', /the step not 0/],
    ] as const) {
      if (code === null) {
        expect((await readLevel3(bytes)).partial).to.contain('4 of 65535');
        continue;
      }
      const error = await expectError(decodeBytes(bytes, 'x'));
      expect(error.code, error.message).to.equal(code);
      expect(error.message).to.match(words);
    }
  });
});
