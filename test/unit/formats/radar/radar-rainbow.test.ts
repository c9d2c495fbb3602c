import { expect } from '@esm-bundle/chai';
import { gzipSync } from 'fflate';
import { readRainbow } from '../../../../src/formats/radar/rainbow.ts';
import { decodeBytes, expectError } from '../../../helpers/decode.ts';
import { gateValues } from '../../../helpers/radar.ts';
import { buildRainbow, builtSweep, builtVolume } from '../../../helpers/rainbow-builder.ts';

/**
 * What xradar 0.12.0 reads of the built files, radials in the file's order. It gives the number 0, which is no data, as a value (-32, -31.501938
 * and -16.075591), and 360.00012 degrees for 0.00012.
 */
const expected = [
  {
    elevation: 0.6,
    azimuths: [359.00037, 0.00012, 0.99988, 1.99963],
    time: '2013-05-10T00:00:06Z',
    values: [NaN, -31.5, -31, 0, 32, 95, 95.5, NaN, -31.5, -31, 0, 32],
  },
  {
    elevation: 1.4,
    azimuths: [10.49756, 11.49731, 12.50256, 13.50232],
    time: '2013-05-10T00:01:06Z',
    values: [
      NaN,
      -31.5,
      -31.498062,
      -30.92056,
      46.015076,
      95.498062,
      95.5,
      NaN,
      -31.5,
      -31.498062,
      -30.92056,
      46.015076,
    ],
  },
];

describe('Rainbow 5', () => {
  it('has every gate, angle and time as xradar has them, packed or not', async () => {
    for (const bytes of [
      buildRainbow(builtVolume),
      buildRainbow({ ...builtVolume, isPacked: false }),
      new Uint8Array(gzipSync(buildRainbow(builtVolume))),
    ]) {
      const { sweeps, site, beamWidth, time, moments } = await readRainbow(bytes);
      expect(site).to.deep.equal({ name: 'Here', latitude: 50.856633, longitude: 6.379967, height: 116.7 });
      expect([beamWidth, time]).to.deep.equal([1.326, '2013-05-10T00:00:06Z']);
      expect(moments).to.deep.equal([{ name: 'dBZ', kind: 'reflectivity', unit: 'dBZ' }]);
      expect(sweeps).to.have.length(2);
      for (const [i, { elevation, azimuths, time, values }] of expected.entries()) {
        expect([sweeps[i].elevation, sweeps[i].time]).to.deep.equal([elevation, time]);
        azimuths.forEach((azimuth, ray) => expect(sweeps[i].azimuths[ray]).to.be.closeTo(azimuth, 1e-5));
        const data = sweeps[i].read('dBZ')!;
        expect([data.firstGate, data.gateLength, data.gates]).to.deep.equal([2125, 250, 3]);
        gateValues(data).forEach((value, gate) => {
          if (Number.isNaN(values[gate])) expect(Number.isNaN(value), `gate ${gate}`).to.equal(true);
          else expect(value, `gate ${gate}`).to.be.closeTo(values[gate], 1e-6);
        });
      }
    }
  });

  it('of one sweep has the middle between the ends of each radial, and folds where velocities are ambiguous', async () => {
    const volume = await decodeBytes(buildRainbow(builtSweep), 'scan.azi');
    expect(volume.format).to.equal('Rainbow 5.36.5');
    expect(volume.unit).to.equal('m/s');
    for (const [i, end] of [-15.95, 15.95].entries()) expect(volume.range[i]).to.be.closeTo(end, 1e-12);
    const [sweep] = (await readRainbow(buildRainbow(builtSweep))).sweeps;
    // xradar 0.12.0
    [357.50061, 358.50037, 359.75006, 0.49988].forEach((azimuth, ray) =>
      expect(sweep.azimuths[ray]).to.be.closeTo(azimuth, 1e-5),
    );
    expect(sweep.nyquist).to.equal(15.95);
  });

  it('that was cut short shows its whole sweeps, and says so', async () => {
    const { sweeps, partial } = await readRainbow(buildRainbow(builtVolume).slice(0, -20));
    expect(sweeps).to.have.length(1);
    expect(partial).to.contain('1 of 2 sweeps');
  });

  it('that lies, or holds something else, is refused in words', async () => {
    for (const [bytes, code, words] of [
      [buildRainbow({ ...builtVolume, type: 'ele' }), 'format/unsupported', /type "ele".*xradar/],
      [buildRainbow(builtVolume).slice(0, 900), 'format/corrupt', /END XML/],
      [buildRainbow({ ...builtVolume, change: (text) => text.replace('</scan>', '') }), 'format/corrupt', /no XML/],
      [buildRainbow({ ...builtVolume, size: () => 1e9 }), 'format/corrupt', /none of its 2 sweeps/],
      [
        buildRainbow({ ...builtVolume, change: (text) => text.replaceAll('depth="8"', 'depth="4"') }),
        'format/unsupported',
        /4 bits/,
      ],
      [
        buildRainbow({ ...builtVolume, change: (text) => text.replaceAll('bins="3"', 'bins="900"') }),
        'format/corrupt',
        /bytes in its part/,
      ],
      [
        buildRainbow({ ...builtVolume, change: (text) => text.replaceAll('bins="3"', 'bins="1e12"') }),
        'format/too-large',
        /gates/,
      ],
      [
        buildRainbow({ ...builtVolume, change: (text) => text.replaceAll('min="-31.5"', 'min="x"') }),
        'format/corrupt',
        /min="x"/,
      ],
      [buildRainbow({ ...builtVolume, rangestep: 0 }), 'format/corrupt', /rangestep/],
    ] as const) {
      const error = await expectError(decodeBytes(bytes, 'scan.vol'));
      expect(error.code, error.message).to.equal(code);
      expect(error.message).to.match(words);
    }
  });
});
