import { expect } from '@esm-bundle/chai';
import { describeScale, legendDomain } from '../../../src/editor/describe-scale.ts';
import { drawArea, drawCurve, paintStops } from '../../../src/editor/paint-curve.ts';
import { labelShift, listTicks, roundStep, roundTo } from '../../../src/editor/ticks.ts';
import { chooseDomain, toHeight, toOpacity, toShare, toValue } from '../../../src/editor/transfer-function-axes.ts';
import { bandsFromStops, chooseBandEdges, stopsFromBands } from '../../../src/editor/transfer-function-bands.ts';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { resolveTransferFunction } from '../../../src/optics/transfer/resolve-transfer-function.ts';
import { evaluate } from '../../../src/optics/transfer/transfer-function.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { english } from '../../../src/messages/english-companions.ts';
import { Language } from '../../../src/messages/language.ts';
import { expectNear } from '../../helpers/emission.ts';

const none = { bands: null, bandEdges: null };
const dbz = { unit: 'dBZ', window: [-10, 60] as const };
const plain = { unit: '', window: [0, 30] as const };

describe('bands', () => {
  it("are the paper's 15 of 5 dBZ where the unit is dBZ", () => {
    expect(chooseBandEdges(none, dbz)).to.deep.equal([-5, 0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70]);
    expect(chooseBandEdges({ ...none, bands: '3' }, dbz)).to.deep.equal([-5, 20, 45, 70]);
  });

  it('else divide the window, at values that are short to read', () => {
    expect(chooseBandEdges(none, plain)).to.deep.equal(Array.from({ length: 16 }, (_, i) => 2 * i));
    expect(chooseBandEdges({ ...none, bands: '4' }, plain)).to.deep.equal([0, 7.5, 15, 22.5, 30]);
    expect(
      chooseBandEdges({ ...none, bands: '2' }, { unit: '', window: [7, 7] }),
      'data that are all the same',
    ).to.deep.equal([6.5, 7, 7.5]);
    const edges = chooseBandEdges({ ...none, bands: '7' }, { unit: 'HU', window: [-512.34567, 1033.21] });
    expect(edges.every((edge) => String(edge).length <= 6)).to.equal(true);
    edges.slice(1).forEach((edge, i) => expect(edge - edges[i]).to.be.closeTo(1545.6 / 7, 10));
  });

  it('are those of band-edges where it is given', () => {
    expect(chooseBandEdges({ bands: '3', bandEdges: ' 0, 10 50\n90 ' }, dbz)).to.deep.equal([0, 10, 50, 90]);
  });

  for (const attributes of [
    { bands: '0' },
    { bands: '65' },
    { bands: 'x' },
    { bandEdges: '5' },
    { bandEdges: '5 4' },
    { bandEdges: '1 1' },
    { bandEdges: 'a b' },
    { bandEdges: '' },
  ]) {
    it(`refuse ${JSON.stringify(attributes)} in words`, () => {
      expect(() => chooseBandEdges({ ...none, ...attributes }, plain)).to.throw(
        VolumeViewError,
        /^band.+ got ".*"; expected/,
      );
    });
  }

  it('become stops with a jump at each edge: nothing below, the last colour above', () => {
    const bands = [
      { low: 0, high: 10, color: [1, 0, 0], opacity: 0.2 },
      { low: 10, high: 20, color: [0, 1, 0], opacity: 0.6 },
    ] as const;
    const stops = stopsFromBands(bands);
    expectNear(evaluate(stops, -1), [0, 0, 0, 0]);
    for (const value of [0, 5, 9.999]) expectNear(evaluate(stops, value), [0.2, 0, 0, 0.2]);
    for (const value of [10, 15, 19.999, 20, 99]) expectNear(evaluate(stops, value), [0, 0.6, 0, 0.6]);
    expect(bandsFromStops(stops, [0, 10, 20])).to.deep.equal(bands);
  });

  it('keep the colour of a band that is transparent', () => {
    const bands = [
      { low: 0, high: 10, color: [1, 0.5, 0], opacity: 0 },
      { low: 10, high: 20, color: [0, 1, 0], opacity: 0 },
    ] as const;
    expect(bandsFromStops(stopsFromBands(bands), [0, 10, 20])).to.deep.equal(bands);
  });

  it('take what a preset is in the middle of each', async () => {
    const stops = await resolveTransferFunction('radar-dbz', [0, 1]);
    const bands = bandsFromStops(stops, chooseBandEdges(none, dbz));
    expect(bands[0].opacity).to.equal(0);
    expect(bands[10].opacity).to.be.closeTo((0.25 + 0.36) / 2, 1e-12); // 45 to 50: half-way between its ends
  });
});

describe('ticks', () => {
  it('are round numbers within the range', () => {
    expect(listTicks([3, 75], 9)).to.deep.equal([10, 20, 30, 40, 50, 60, 70]);
    expect(listTicks([-1000, 1800], 6)).to.deep.equal([-1000, -500, 0, 500, 1000, 1500]);
    expect(listTicks([0, 0.3], 3)).to.deep.equal([0, 0.1, 0.2, 0.3]);
    expect(listTicks([-0.25, 0.25], 5)).to.deep.equal([-0.2, -0.1, 0, 0.1, 0.2]);
    expect(listTicks([5, 5], 5)).to.deep.equal([]);
  });

  it('are few and within, whatever the range', () => {
    for (let i = 0; i < 400; i++) {
      const scale = 10 ** ((i % 17) - 8);
      const low = Math.sin(i) * scale;
      const high = low + scale * 10 ** ((i % 5) - 3) * (1 + (i % 7));
      const ticks = listTicks([low, high], 6);
      expect(ticks.length, `${low} ${high}`).to.be.within(1, 7);
      expect(ticks[0], `${low} ${high}`).to.be.at.least(low - 1e-9 * (high - low));
      expect(ticks.at(-1), `${low} ${high}`).to.be.at.most(high + 1e-9 * (high - low));
    }
  });

  it('round', () => {
    expect([0.9, 1, 1.1, 2, 3, 6, 0.03].map(roundStep)).to.deep.equal([1, 1, 2, 2, 5, 10, 0.05]);
    expect(roundTo(0.30000000000000004, 0.1)).to.equal(0.3);
    expect(Object.is(roundTo(-0.01, 0.1), 0)).to.equal(true);
    expect([0, 0.5, 1].map(labelShift)).to.deep.equal([0, 0.5, 1]);
  });
});

describe('the axes of the chart', () => {
  it('spread small opacities, and make zero easy to hit', () => {
    expect([0, 0.001, 0.125, 1].map(toHeight)).to.deep.equal([0, 0.1, 0.5, 1]);
    for (const opacity of [0.0005, 0.01, 0.3, 1])
      expect(toOpacity(toHeight(opacity))).to.be.closeTo(opacity, opacity * 0.005);
    expect([-1, 0, 0.02, 2].map(toOpacity)).to.deep.equal([0, 0, 0, 1]);
  });

  it('round values under the hand, and stay within the chart', () => {
    expect(toValue(0.50004, [0, 1000])).to.equal(500);
    expect(toValue(-1, [0.5, 9])).to.equal(0.5);
    expect(toValue(2, [0.5, 9.0001])).to.equal(9.0001);
    expect(toShare(toValue(0.25, [-10, 10]), [-10, 10])).to.equal(0.25);
  });

  it('span the window, the stops and all data but strays', () => {
    const counts = new Uint32Array(100).fill(0);
    counts.fill(1000, 20, 60);
    counts[99] = 1; // one stray voxel
    const histogram = { low: 0, high: 100, counts };
    const optics = (stops: number[], window: [number, number]) => ({
      transferFunction: stops.map((value) => ({ value, color: [0, 0, 0] as const, opacity: 0 })),
      window,
    });
    expect(chooseDomain(histogram, optics([30], [30, 40]))).to.deep.equal([20, 60]);
    expect(chooseDomain(histogram, optics([-7, 80], [10, 40]))).to.deep.equal([-7, 80]);
    const flat = { low: 3, high: 3, counts: new Uint32Array(100).fill(0, 0) };
    expect(chooseDomain(flat, optics([3], [3, 3]))).to.deep.equal([2.5, 3.5]);
  });
});

describe('the drawing of a transfer function', () => {
  const stops: TransferFunction = [
    { value: 0, color: [0, 0, 1], opacity: 0 },
    { value: 10, color: [1, 0, 0], opacity: 0.5 },
    { value: 10, color: [0, 1, 0], opacity: 0.125 },
  ];

  it('is what evaluate says, at every point', () => {
    for (const { share, color, opacity } of paintStops(stops, [-10, 30])) {
      const value = -10 + share * 40;
      if (value === 10) continue; // a jump has two
      const [red, green, blue, alpha] = evaluate(stops, value);
      expect(opacity).to.be.closeTo(alpha, 1e-12);
      if (alpha > 0) expectNear(color, [red / alpha, green / alpha, blue / alpha]);
    }
  });

  it('runs along the whole scale and jumps upright', () => {
    const points = paintStops(stops, [-10, 30]);
    const shares = points.map(({ share }) => share);
    expect([shares[0], shares.at(-1)]).to.deep.equal([0, 1]);
    expect(shares.every((share, i) => i === 0 || share >= shares[i - 1])).to.equal(true);
    expect(points.filter(({ share }) => share === 0.5).map(({ opacity }) => opacity)).to.include.members([0.5, 0.125]);
    expect(drawCurve(points)).to.match(/^M0\.00 100\.00L.*L500\.00 50\.00L1000\.00 50\.00$/);
    expect(drawArea(points).endsWith('L1000 100H0Z')).to.equal(true);
    expect(drawCurve(points, true)).to.match(/^M0\.00 1000\.00L.*L50\.00 0\.00$/);
  });

  it('is one of a single stop too', () => {
    expect(paintStops([stops[1]], [9, 11]).map(({ share, opacity }) => [share, opacity])).to.deep.equal([
      [0, 0.5],
      [0.5, 0.5],
      [1, 0.5],
    ]);
  });
});

describe('a legend in words', () => {
  it('names colours from where they begin', () => {
    const language = new Language('en', english);
    const stops: TransferFunction = [
      { value: 0, color: [0, 0, 1], opacity: 0.1 },
      { value: 50, color: [0, 0, 1], opacity: 0.1 },
      { value: 50, color: [1, 0, 0], opacity: 0.1 },
      { value: 100, color: [1, 0, 0], opacity: 0.1 },
    ];
    expect(describeScale({ stops, domain: [0, 100], label: 'Speed', unit: 'm/s' }, language)).to.equal(
      'Speed, 0 to 100 m/s: blue, red from 51.',
    );
    expect(describeScale({ stops, domain: [0, 100], label: '', unit: '' }, language)).to.equal(
      'Colours, 0 to 100: blue, red from 51.',
    );
  });

  it('spans the stops, or the data where they span nothing', () => {
    const stop = { value: 5, color: [0, 0, 0], opacity: 1 } as const;
    expect(legendDomain([stop, { ...stop, value: 9 }], [0, 100])).to.deep.equal([5, 9]);
    expect(legendDomain([stop], [0, 100])).to.deep.equal([0, 100]);
    expect(legendDomain([stop], [5, 5])).to.deep.equal([4.5, 5.5]);
  });
});
