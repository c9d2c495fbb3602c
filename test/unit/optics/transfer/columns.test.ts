import { expect } from '@esm-bundle/chai';
import { colorTableStops } from '../../../../src/optics/transfer/color-tables.ts';
import { binColumns } from '../../../../src/optics/transfer/column-bins.ts';
import { cutColumns, locateShare, meanOverColumns } from '../../../../src/optics/transfer/columns.ts';
import { buildDefaultPreset } from '../../../../src/optics/transfer/default-preset.ts';
import { domainOf, emission, meanOverSpan } from '../../../../src/optics/transfer/emission.ts';
import { presetNames } from '../../../../src/optics/transfer/preset-names.ts';
import { readTransferFunction } from '../../../../src/optics/transfer/presets.ts';
import { attenuate } from '../../../../src/optics/rays/segment.ts';
import { mapShares } from '../../../../src/optics/transfer/share-map.ts';
import { findColumns } from '../../../../src/optics/transfer/table-columns.ts';
import { placeThreshold } from '../../../../src/optics/transfer/threshold.ts';
import type { Premultiplied, TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { isUsual } from '../../../../src/optics/transfer/usual-columns.ts';
import { chooseOffset } from '../../../../src/volume/detail-offset.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const stop = (
  value: number,
  opacity: number,
  color: readonly [number, number, number] = [1, 0.5, 0],
): TransferFunction[number] => ({ value, color, opacity });

const functions: Record<string, TransferFunction> = {
  'a ramp': [stop(0, 0), stop(1, 0.8, [0, 0.5, 1])],
  'a narrow ramp in a wide domain': [stop(0, 0), stop(1e-5, 0.5), stop(1, 0.6, [0, 0, 1])],
  jumps: [
    stop(0, 0.7),
    stop(0, 0.02),
    stop(0.3, 0),
    stop(0.3, 0.9, [0, 0, 1]),
    stop(0.6, 0.9),
    stop(0.6, 0),
    stop(1, 0.5),
  ],
  'a ramp to opacity 1': [stop(0, 0), stop(1, 1, [0, 1, 1])],
  'opacity 1 at one value': [stop(0, 0.1), stop(0.4, 1, [0, 0, 1]), stop(1, 0.2)],
  'opacity 1 between two values': [stop(0, 0.1), stop(0.4, 1, [0, 0, 1]), stop(0.5, 1), stop(1, 0.2)],
  'one stop': [stop(0.5, 0.3)],
  '65 stops': colorTableStops('viridis', [0, 1]),
};

/** Shares are data values, without rounding. */
const exactly = (value: number): { share: number; edge: number } => ({ share: value, edge: value });

/** Largest difference of what two means show over any length up to a reference length, 1/255. */
const apart = (a: Premultiplied, b: Premultiplied): number =>
  Math.max(
    ...[0.01, 0.1, 1].flatMap((length) =>
      attenuate(a, length).map((x, c) => 255 * Math.abs(x - attenuate(b, length)[c])),
    ),
  );

describe('columns of a transfer function', () => {
  for (const [name, stops] of Object.entries(functions)) {
    it(`of ${name} have the means of any span`, () => {
      const columns = cutColumns(stops, exactly);
      const random = randomNumbers(71);
      let worst = 0;
      for (let i = 0; i < 3000; i++) {
        // Edges are float32: nothing is asked about nearer to them than that.
        const from = Math.fround(random() * 1.4 - 0.2);
        const to = Math.fround(from + (random() - 0.5) * 10 ** (-5 * random()));
        worst = Math.max(worst, apart(meanOverColumns(columns, from, to), meanOverSpan(stops, from, to)));
      }
      console.log(`${name}: ${columns.starts.length / 4} columns, worst ${worst.toFixed(3)} / 255`);
      expect(worst).to.be.below(0.7);
      expect(columns.starts.length / 4).to.be.below(300);
    });

    it(`of ${name} have at stops what holds there, and are clear where nothing is seen`, () => {
      const columns = cutColumns(stops, (value) => ({ share: Math.fround(value), edge: value - 1e-7 }));
      for (const { value } of stops) {
        const [got, expected] = [locateShare(columns, Math.fround(value)).emission, emission(stops, value)];
        got.forEach((x, c) => expect(x, `${value}`).to.be.closeTo(expected[c], 1e-3 * Math.max(1e-3, expected[3])));
      }
    });
  }

  it('are found by bins, with one edge in each, and by no bins where edges are too near', () => {
    const random = randomNumbers(72);
    for (const [name, stops] of Object.entries(functions)) {
      const columns = cutColumns(stops, exactly);
      const bins = binColumns(columns.edges);
      expect(bins === null, name).to.equal(name === 'a narrow ramp in a wide domain');
      if (!bins) continue;
      for (let i = 0; i < 2000; i++) {
        const share = Math.fround(random());
        const bin = Math.min(bins.count - 1, Math.max(0, Math.floor(share * bins.count)));
        const [column, , end] = bins.texels.subarray(bin * 4);
        expect(column + (share < end ? 0 : 1), `${name}, ${share}`).to.equal(locateShare(columns, share).column);
      }
    }
    expect(binColumns(Float32Array.of(-1e35, 0, 1e-9, 1, 1e35))).to.equal(null);
  });

  it('are 4,096 at most, whatever the stops', () => {
    const stops = Array.from({ length: 1024 }, (_, i) => stop(i / 1023, i % 2 === 0 ? 0 : 0.94));
    expect(cutColumns(stops, exactly).starts.length / 4).to.be.within(1000, 4096);
  });
});

describe('where stops lie among the numbers of a GPU', () => {
  it('samples that are at a stop are on its right, those next to it are not, for any slope and intercept', () => {
    const random = randomNumbers(73);
    for (const whole of [true, false]) {
      for (let i = 0; i < 2000; i++) {
        const slope = [1, -1, 0.1, 0.0037, -1 / 3][i % 5];
        const intercept = [0, -1024, 12.5, 0.3][i % 4];
        const storedScale = whole ? [1, 255][i % 2] : 1;
        const max = storedScale === 255 ? 255 : 65535;
        const sample = Math.floor(random() * max);
        const value = slope * sample + intercept;
        const range = [Math.min(0, slope) * max + intercept, Math.max(0, slope) * max + intercept] as const;
        const values = { slope, intercept, storedScale, range, whole };
        const map = mapShares(values, range);
        const shareOf = (stored: number): number =>
          Math.fround(Math.fround(Math.fround(stored / storedScale) - map.from) * map.scale);
        // As an author writes it: with fewer digits than slope and intercept make.
        const written = Number(value.toPrecision(12));
        const { edge } = placeThreshold(values, map, written);
        for (const attached of [-1, 0, 1]) {
          const isRight = slope * (sample + attached) + intercept >= written;
          for (const ulps of [-2, 0, 2]) {
            expect(
              shareOf(sample + attached) * (1 + ulps * 2 ** -24) >= Math.fround(edge),
              `${written}, ${sample} + ${attached}, slope ${slope}, intercept ${intercept}`,
            ).to.equal(isRight);
          }
        }
      }
    }
  });

  it('values are where they should be in domains as wide as numbers go, by factors that no GPU takes for 0', () => {
    const minNormal = 2 ** -126;
    for (const width of [1e5, 1e30, 1e38, 3e38, 1e300]) {
      for (const [slope, intercept, storedScale] of [
        [1, 0, 1],
        [-1, 0, 255],
        [1 / 65535, -1024, 1],
      ] as const) {
        const map = mapShares({ slope, intercept, storedScale, range: [intercept, intercept + 1] }, [-width, width]);
        expect(Math.abs(map.scale), `${width}, slope ${slope}`).to.be.at.least(minNormal);
        expect([map.scale, map.from].every(Number.isFinite)).to.equal(true);
        for (const value of [0, 0.4, 1]) {
          const number = Math.fround((value - intercept) / slope / storedScale);
          const share = Math.fround(Math.fround(number - map.from) * map.scale);
          expect(share, `${value} of ${width}`).to.be.closeTo((value + width) / (2 * width), 1e-5);
        }
      }
    }
  });

  it('the low end of a domain is 0 to the last bit', () => {
    for (const [slope, intercept, storedScale, low] of [
      [1, 0, 255, 41],
      [0.1, 0, 1, 0.3],
      [1, -1000, 1, -990],
      [1, 1e7, 1, 1e7 + 13],
    ]) {
      const { from } = mapShares({ slope, intercept, storedScale, range: [low, low + 100] }, [low, low + 50]);
      expect(from).to.equal(Math.fround(Math.round((low - intercept) / slope) / storedScale));
    }
  });
});

describe('the table of means holds', () => {
  it('all presets, with all stops that are clear on columns', async () => {
    for (const window of [
      [-123.7, 981.3],
      [0, 255],
      [0.013, 0.9],
    ] as const) {
      for (const name of presetNames) {
        const stops = name === 'mri' ? buildDefaultPreset(window) : await readTransferFunction(name, window);
        const columns = findColumns(stops)!;
        expect(columns, name).to.be.within(1024, 2048);
        const [low, high] = domainOf(stops);
        stops.forEach(({ value, opacity }, i) => {
          const isKink =
            i > 0 && i < stops.length - 1 && opacity === 0 && stops[i - 1].opacity + stops[i + 1].opacity > 0;
          const column = ((value - low) / (high - low)) * (columns - 1);
          if (isKink) expect(Math.abs(column - Math.round(column)), `${name} at ${value}`).to.be.below(1e-5);
        });
      }
    }
    expect(isUsual(buildDefaultPreset([0.013, 0.9]))).to.equal(true);
  });

  it('no jumps, no narrow pieces, no opacity of 1, no stops that are on no columns', () => {
    for (const name of ['a narrow ramp in a wide domain', 'jumps', 'a ramp to opacity 1', 'opacity 1 at one value']) {
      expect(findColumns(functions[name]), name).to.equal(null);
      expect(isUsual(functions[name]), name).to.equal(false);
    }
    expect(findColumns([stop(0, 0), stop(Math.SQRT1_2, 0), stop(1, 0.5)])).to.equal(null);
    expect(findColumns(functions['a ramp'])).not.to.equal(null);
  });
});

describe('what is taken off values before they become float32', () => {
  it('is nothing where that does no harm', () => {
    const random = randomNumbers(74);
    expect(chooseOffset(Float64Array.from({ length: 5000 }, () => random()))).to.equal(0);
    expect(chooseOffset(Float64Array.from({ length: 5000 }, (_, i) => -1024 + (i % 3000)))).to.equal(0);
    expect(chooseOffset(new Float64Array(10))).to.equal(0);
    expect(chooseOffset([])).to.equal(0);
  });

  it('is near the detail, whatever lies far away', () => {
    const random = randomNumbers(75);
    const detail = Float64Array.from({ length: 5000 }, (_, i) =>
      i % 100 === 0 ? 0 : i % 777 === 0 ? -2e9 : 1.5e9 + 1000 * random(),
    );
    expect(chooseOffset(detail)).to.be.within(1.5e9, 1.5e9 + 1000);
  });
});
