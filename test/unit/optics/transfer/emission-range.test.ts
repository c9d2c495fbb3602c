import { expect } from '@esm-bundle/chai';
import { emission } from '../../../../src/optics/transfer/emission.ts';
import { rangeEmission } from '../../../../src/optics/transfer/emission-range.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

/** The largest difference among values no more than `apart` from each other, by trying many pairs. */
function tryPairs(transferFunction: TransferFunction, [low, high]: readonly [number, number], apart: number): number {
  const count = 2000;
  const stops = transferFunction.map(({ value }) => value).filter((value) => value >= low && value <= high);
  const values = [...stops, ...Array.from({ length: count + 1 }, (_, i) => low + ((high - low) * i) / count)];
  values.sort((a, b) => a - b);
  const seen = values.map((value) => emission(transferFunction, value));
  let largest = 0;
  for (let i = 0; i < values.length; i++) {
    for (let j = i; j < values.length && values[j] - values[i] <= apart; j++) {
      for (let c = 0; c < 4; c++) largest = Math.max(largest, Math.abs(seen[i][c] - seen[j][c]));
    }
  }
  return largest;
}

const functions = {
  smooth: '0 #000 0, 30 #f80 20%, 100 white 60%',
  'a narrow peak': '0 #000 0, 49.9 #f00 0, 50 #f00 80%, 50.1 #f00 0, 100 #000 0',
  'a jump': '0 #08f 2%, 60 #08f 2%, 60 #f80 90%, 100 #f80 90%',
  'a jump at the lower end': '10 #f00 50%, 20 #00f 50%',
};

describe('how much emission differs among values', () => {
  for (const [name, text] of Object.entries(functions)) {
    it(`is never less than between any two of them, and not much more than between two a little farther apart: ${name}`, () => {
      const transferFunction = parseTransferFunction(text, [0, 100]);
      const range = rangeEmission(transferFunction);
      const random = randomNumbers(7);
      for (let i = 0; i < 12; i++) {
        const low = 95 * random();
        const high = low + (100 - low) * random() ** 2;
        const apart = (high - low) * random();
        const found = range.among(low, high, apart);
        const bin = 100 / 512;
        expect(found, `${low} to ${high}, ${apart}`).to.be.at.least(
          tryPairs(transferFunction, [low, high], apart) - 1e-6,
        );
        expect(found).to.be.at.most(
          tryPairs(transferFunction, [low - 2 * bin, high + 2 * bin], 1.5 * apart + 6 * bin) + 0.005,
        );
      }
    });
  }

  for (const [name, text] of Object.entries(functions)) {
    it(`is off the straight line by what is said, or by half of a jump: ${name}`, () => {
      const transferFunction = parseTransferFunction(text, [0, 100]);
      const range = rangeEmission(transferFunction);
      for (const apart of [0.01, 0.1, 0.5, 2, 8, 30]) {
        let largest = 0;
        for (let from = 0; from <= 100 - apart; from += 0.05) {
          const at = (share: number): number => emission(transferFunction, from + share * apart)[3];
          for (let share = 0.1; share < 1; share += 0.1)
            largest = Math.max(largest, Math.abs(at(share) - at(0) * (1 - share) - at(1) * share));
        }
        expect(range.offLine(0, 100, apart), `${apart} apart`).to.be.at.least(0.5 * largest - 1e-6);
        expect(range.offLine(0, 100, apart)).to.be.at.most(range.among(0, 100, apart));
      }
    });
  }

  it('is not off the straight line where emission is one, however steep', () => {
    const even = rangeEmission(parseTransferFunction('0 #fff 0, 100 #fff 1%', [0, 100]));
    expect(even.offLine(0, 100, 20)).to.be.below(0.02 * even.among(0, 100, 20));
    expect(
      rangeEmission(parseTransferFunction('0 #fff 0, 50 #fff 0, 50 #fff 80%, 65535 #fff 80%', [0, 65535])).offLine(
        0,
        65535,
        10,
      ),
      'a jump in a wide domain',
    ).to.be.above(0.4 * 1.6);
  });

  it('is nothing where all values look the same', () => {
    const range = rangeEmission(parseTransferFunction(functions['a narrow peak'], [0, 100]));
    expect(range.among(0, 48, 48)).to.equal(0);
    expect(range.among(51, 99, 48)).to.equal(0);
    expect(range.among(48, 52, 0.5)).to.be.above(1);
  });
});
