import { expect } from '@esm-bundle/chai';
import { labelTicks } from '../../../src/editor/tick-labels.ts';
import { legendDomain } from '../../../src/editor/describe-scale.ts';
import { listTicks } from '../../../src/editor/ticks.ts';
import { english } from '../../../src/messages/english-companions.ts';
import { Language } from '../../../src/messages/language.ts';

const language = new Language('en', english);
const textsOf = (domain: readonly [number, number], max = 9): string => {
  const { ticks, offset } = labelTicks(domain, max, language);
  return [...(offset ? [`${offset}:`] : []), ...ticks.map(({ text }) => text)].join(' ');
};

describe('the numbers along a scale', () => {
  it('are as before where they are short', () => {
    expect(textsOf([3, 75])).to.equal('10 20 30 40 50 60 70');
    expect(textsOf([-1000, 1800], 6)).to.equal('−1000 −500 0 500 1000 1500');
    expect(textsOf([0, 65535])).to.equal('0 10000 20000 30000 40000 50000 60000');
  });

  it('have as many digits as they need to differ', () => {
    expect(textsOf([1e6, 1e6 + 10], 6)).to.equal('1000000 1000005 1000010');
    expect(textsOf([273.15, 273.16], 6)).to.equal('273.15 273.155 273.16');
  });

  it('are differences from one that is said once, where that takes many digits', () => {
    expect(textsOf([1e7, 1e7 + 1])).to.equal('10000000 +: 0 0.2 0.4 0.6 0.8 1');
    expect(textsOf([12345678, 12345690], 6)).to.equal('12345680 +: −2 0 2 4 6 8 10');
    expect(textsOf([0.5, 0.5 + 1e-7])).to.equal('0.5 +: 0 2E−8 4E−8 6E−8 8E−8 1E−7');
    // One value alone, as a legend spans it.
    expect(textsOf(legendDomain([{ value: -1e17, color: [1, 1, 1], opacity: 1 }], [-1e17, -1e17]))).to.equal(
      '−1E17 +: −50000000000 0 50000000000',
    );
  });

  it('have room: there are fewer of long ones', () => {
    for (const domain of [
      [0, 1e300],
      [-2.5e300, 1e300],
      [-1.7e308, 1.7e308],
      [0, 5e-320],
      [-1e-300, 2.5e-300],
      [-1e17, -1e17 + 1600],
      [1e15, 1e15 + 8],
    ] as const) {
      for (const max of [6, 9]) {
        const { ticks } = labelTicks(domain, max, language);
        expect(ticks, String(domain)).to.have.length.within(2, max + 1);
        expect(new Set(ticks.map(({ text }) => text)).size, `${domain.join(' ')}: all differ`).to.equal(ticks.length);
        const widest = Math.max(...ticks.map(({ text }) => text.length));
        expect(
          ticks.length <= 3 || ticks.length * (widest + 1) <= 6 * max,
          `${domain.join(' ')}: ${ticks.map(({ text }) => text).join(' ')}`,
        ).to.equal(true);
        for (const { value } of ticks) expect(value).to.be.within(domain[0], domain[1]);
      }
    }
  });

  it('are round to the last digit with large offsets, and in the widest range that there is', () => {
    expect(listTicks([-1e17, -1e17 + 1600], 4)).to.deep.equal([-1e17, -1e17 + 500, -1e17 + 1000, -1e17 + 1500]);
    expect(listTicks([-1.7e308, 1.7e308], 4)).to.deep.equal([-1e308, 0, 1e308]);
  });
});

describe('a range in words', () => {
  it('writes its ends differently', () => {
    expect(language.range(-1e17 - 9.5e10, -1e17, '')).to.equal('−1.000001E17 to −1E17');
    expect(language.range(12345678, 12345690, 'm')).to.equal('12345680 to 12345690 m');
    expect(language.range(0, 65535, 'm'), 'no more digits than it takes').to.equal('0 to 65540 m');
    expect(language.range(5, 5, '')).to.equal('5 to 5');
  });
});
