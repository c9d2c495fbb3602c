// Numbers that are counted while slices come give the samples, the range and the histogram that a look at all of them gives.
import { expect } from '@esm-bundle/chai';
import { hostIsLittleEndian, numberTypes } from '../../../../src/formats/base/number-types.ts';
import { storeSamples } from '../../../../src/formats/base/store-samples.ts';
import { NumberCounts, storeCounted } from '../../../../src/formats/dicom/number-counts.ts';
import { summarize } from '../../../../src/volume/histogram.ts';
import { ctSlice, dicomBytes } from '../../../helpers/dicom-bytes.ts';
import { decodeSeries } from '../../../helpers/dicom-series.ts';

/** Numbers from `low` to `high`, both of them too, in an order without a rule. */
function makeNumbers(Type: typeof Int16Array | typeof Uint16Array, length: number, low: number, high: number) {
  let seed = 7;
  const next = (): number => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const numbers = new Type(length).map(() => low + Math.floor(next() * (high - low + 1)));
  numbers[length >> 1] = low;
  numbers[length - 1] = high;
  return numbers;
}

describe('numbers that are counted as they come', () => {
  for (const [Type, low, high] of [
    [Int16Array, -1024, 3071],
    [Int16Array, -32768, 32767],
    [Int16Array, -32768, -30000],
    [Int16Array, -1, 300],
    [Int16Array, 0, 4095],
    [Int16Array, 5, 32767],
    [Uint16Array, 0, 65535],
    [Uint16Array, 700, 40000],
    [Uint16Array, 65000, 65535],
  ] as const) {
    it(`are stored as others: ${Type.name}, ${low} to ${high}`, () => {
      for (const length of [3, 4, 1001, 4096]) {
        const numbers = makeNumbers(Type, length, low, high);
        const usual = storeSamples(
          new Uint8Array(numbers.slice().buffer),
          Type === Int16Array ? numberTypes.int16 : numberTypes.uint16,
          hostIsLittleEndian,
          { slope: 1, intercept: 0 },
        );
        const counts = new NumberCounts();
        counts.add(numbers.subarray(0, length >> 1));
        counts.add(numbers.subarray(length >> 1));
        const stored = storeCounted(numbers, counts)!;
        expect(stored.samples.constructor).to.equal(usual.samples.constructor);
        expect([...stored.samples]).to.deep.equal([...usual.samples]);
        expect([stored.scale, stored.offset]).to.deep.equal([usual.scale, usual.offset]);
        for (const [slope, intercept] of [
          [1, -1024],
          [-0.5, 3],
        ])
          expect(summarize(stored.samples, slope, intercept, { known: stored.counts })).to.deep.equal(
            summarize(usual.samples, slope, intercept),
          );
      }
    });
  }

  it('are left to others where 8 bits hold them', () => {
    const numbers = makeNumbers(Int16Array, 100, -100, 155);
    const counts = new NumberCounts();
    counts.add(numbers);
    expect(storeCounted(numbers, counts)).to.equal(null);
  });

  it('are shifted where a pair of them does not begin at a multiple of four bytes', () => {
    const numbers = Int16Array.of(9, -3, 400, 7).subarray(1);
    const counts = new NumberCounts();
    counts.add(numbers);
    expect([...storeCounted(numbers, counts)!.samples]).to.deep.equal([0, 403, 10]);
  });

  it('of a series are those of its volume: no slice is counted twice or left out', async () => {
    const numbers = (k: number) => Int16Array.from({ length: 96 * 96 }, (_, i) => ((i * (k + 3)) % 1999) - 900 - k);
    const files = Array.from({ length: 5 }, (_, k) =>
      dicomBytes({
        ...ctSlice(2 * k),
        Rows: [96],
        Columns: [96],
        PixelRepresentation: [1],
        PixelData: new Uint8Array(numbers(k).buffer),
      }),
    );
    const { samples, slope, intercept, histogram, range, hasNoData } = await decodeSeries(files);
    expect({ histogram, range, hasNoData }).to.deep.equal(summarize(samples, slope, intercept));
    expect(samples).to.be.instanceOf(Uint16Array);
  });
});
