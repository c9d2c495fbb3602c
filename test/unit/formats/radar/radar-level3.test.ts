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

  it('reads reflectivity of an airport, and correlation and phase in fine radials, as MetPy does', async () => {
    const { numbers } = builtProducts.reflectivity153;
    // MetPy 1.7.1: 256 levels from -32 dBZ on; (number - offset) / scale.
    for (const [code, levels, name, unit, grid, valueOf] of [
      [180, [-320, 5, 254], 'REF', 'dBZ', { firstGate: 75, gateLength: 150 }, (n: number) => -32 + (n - 2) / 2],
      [
        167,
        { scale: 300, offset: -60.5 },
        'RHO',
        '',
        { firstGate: 125, gateLength: 250 },
        (n: number) => (n + 60.5) / 300,
      ],
      [
        168,
        { scale: 0.5, offset: 2 },
        'PHI',
        'degrees',
        { firstGate: 125, gateLength: 250 },
        (n: number) => (n - 2) / 0.5,
      ],
    ] as const) {
      const { sweeps, moments, beamWidth } = await readLevel3(buildLevel3({ code, levels, numbers }));
      expect([moments[0].name, moments[0].unit]).to.deep.equal([name, unit]);
      expect(beamWidth).to.equal(code === 180 ? 0.55 : 0.95);
      const data = sweeps[0].read(name)!;
      expect(data).to.include(grid);
      gateValues(data).forEach((value, i) => {
        const number = numbers.flat()[i];
        if (number < 2) expect(Number.isNaN(value), `gate ${i}`).to.equal(true);
        else expect(value).to.be.closeTo(valueOf(number), 1e-6);
      });
    }
  });

  it('a spectrum width of 0 has the number 129, whatever the head says of the least one', async () => {
    for (const least of [0, -635]) {
      const { sweeps } = await readLevel3(
        buildLevel3({ code: 155, numbers: [[0, 129, 130, 167]], levels: [least, 5, 254] }),
      );
      expect([...gateValues(sweeps[0].read('SW')!)]).to.deep.equal([NaN, 0, 0.5, 19]);
    }
  });

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
