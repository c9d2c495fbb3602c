// Panes, scales, histograms and numbers of data at the ends of what doubles hold: as of data around 1.
import { expect } from '@esm-bundle/chai';
import { drawHistogram } from '../../../src/editor/draw-histogram.ts';
import { labelTicks } from '../../../src/editor/tick-labels.ts';
import { roundStep } from '../../../src/editor/ticks.ts';
import { toShare } from '../../../src/editor/transfer-function-axes.ts';
import { colorPainter, grayPainter } from '../../../src/panes/paint-slice.ts';
import type { Painter } from '../../../src/panes/paint-slice.ts';
import { suitingWindow } from '../../../src/panes/suiting-window.ts';
import { resolveAppearance } from '../../../src/viewer/appearance/resolve-appearance.ts';
import { plainAppearance } from '../../../src/viewer/model/plain-appearance.ts';
import { english } from '../../../src/messages/english-companions.ts';
import { Language } from '../../../src/messages/language.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

/** Factors of the data, and how well doubles of that size tell shares of them apart: below 2.2e-308 they are whole multiples of 4.94e-324. */
const sizes = [
  [5e-310, 1e-12],
  [1e-320, 1 / 2024],
  [1e-300, 1e-12],
  [1e299, 1e-12],
  [1e306, 1e-12],
  [1.7e308, 1e-12],
] as const;

const shares = Float64Array.from({ length: 101 }, (_, i) => i / 100);
const paint = (painter: Painter, values: Float64Array): number[] => {
  const pixels = new Uint8ClampedArray(4 * values.length);
  painter(values, pixels, [0, values.length]);
  return [...pixels];
};
const histogramOf = (size: number) => ({
  low: 0,
  high: size,
  counts: Uint32Array.from({ length: 256 }, (_, i) => 1 + ((i * 37) % 101)),
});
const language = new Language('en', english);

for (const [size, error] of sizes) {
  describe(`data up to ${size}`, () => {
    const values = shares.map((share) => share * size);

    it('are the greys of a pane that data up to 1 are, and so are its colours', () => {
      const greys = (factor: number, window: readonly [number, number]): number[] =>
        paint(
          grayPainter(
            { window: [window[0] * factor, window[1] * factor], windowFunction: 'linear-exact' },
            { slope: factor, intercept: 0 },
          ),
          shares,
        );
      for (const window of [
        [0, 1],
        [0.2, 0.7],
      ] as const) {
        const [got, expected] = [greys(size, window), greys(1, window)];
        expect(Math.max(...got.map((x, i) => Math.abs(x - expected[i])))).to.be.at.most(Math.ceil(512 * error));
      }
      // Authors, and what is made of data, write no stops beyond 1e300.
      if (size > 1e300) return;
      const colors = (factor: number): number[] =>
        paint(
          colorPainter(
            [0, 0.3, 1].map((share, i) => ({ value: share * factor, color: [share, 1 - share, i / 2], opacity: 1 })),
            { slope: factor, intercept: 0 },
            false,
          ),
          shares,
        );
      const [got, expected] = [colors(size), colors(1)];
      expect(Math.max(...got.map((x, i) => Math.abs(x - expected[i])))).to.be.at.most(Math.ceil(1024 * error));
    });

    it('have the window that data up to 1 have', () => {
      const windowOf = (factor: number): readonly [number, number] =>
        suitingWindow({ unit: '', histogram: histogramOf(factor) });
      windowOf(size).forEach((end, i) => expect(end / size).to.be.closeTo(windowOf(1)[i], 2 * error));
    });

    it('have the histogram and the places that data up to 1 have', () => {
      const numbers = (path: string): number[] => path.match(/[\d.]+/g)!.map(Number);
      const [got, expected] = [size, 1].map((factor) => numbers(drawHistogram(histogramOf(factor), [0, factor])));
      expect(got).to.have.length(expected.length);
      expect(Math.max(...got.map((x, i) => Math.abs(x - expected[i])))).to.be.below(0.011 + 2000 * error);
      values.forEach((value, i) => expect(toShare(value, [0, size])).to.be.closeTo(shares[i], error));
    });

    it('have short, finite numbers on a scale, which say where they stand', () => {
      const { ticks, offset } = labelTicks([0, size], 6, language);
      expect(offset).to.equal('');
      expect(ticks).to.have.length.within(3, 7);
      for (const { value, text } of ticks) {
        expect(text).to.match(/^(0|\d(\.\d)?E−?\d+)$/);
        expect(Number(text.replace('−', '-')) / size).to.be.closeTo(value / size, error);
      }
    });

    it('have a look whose stops rise', async () => {
      const volume = {
        ...syntheticVolume({ dimensions: [4, 4, 4] }),
        histogram: histogramOf(size),
        range: [0, size] as const,
      };
      for (const range of [volume.range, [size / 2, size], [-size, -size / 2]] as const) {
        const { window, transferFunction } = await resolveAppearance(plainAppearance, { ...volume, window: range });
        expect(window[0]).to.be.below(window[1]);
        transferFunction.slice(1).forEach(({ value }, i) => expect(value).to.be.at.least(transferFunction[i].value));
      }
    });
  });
}

describe('a round step', () => {
  it('is none where there is none to take, and no other than a number', () => {
    expect([0, Infinity, 5e-324, 3e-323, 1e-321, 3e-321, 1.2e308].map(roundStep)).to.deep.equal([
      0,
      Infinity,
      5e-324,
      5e-323,
      1e-321,
      5e-321,
      Infinity,
    ]);
  });
});

describe('numbers below what doubles usually hold', () => {
  it('have the digits that they are written with, and no others', () => {
    expect([2e-321, 4.2e-321, 5e-324, -1e-320, 2.06e-310].map((value) => language.number(value))).to.deep.equal([
      '2E−321',
      '4.2E−321',
      '5E−324',
      '−1E−320',
      '2.06E−310',
    ]);
    expect([0, -0, 1e-7, 12345.678].map((value) => language.number(value))).to.deep.equal(['0', '0', '1E−7', '12350']);
  });
});
