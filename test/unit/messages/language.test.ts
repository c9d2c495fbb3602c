import { expect } from '@esm-bundle/chai';
import { english } from '../../../src/messages/english-companions.ts';
import { english as viewEnglish } from '../../../src/messages/english-view.ts';
import { Language } from '../../../src/messages/language.ts';

const en = new Language('en', english);
const de = new Language('de', english);

describe('numbers', () => {
  it('have few digits, no grouping, and a minus as wide as a plus', () => {
    expect([-5.00004, 1234567, 0, -0, 0.00001234].map((value) => en.number(value))).to.deep.equal([
      '−5',
      '1235000',
      '0',
      '0',
      '0.00001234',
    ]);
    expect(en.number(Math.PI, 2)).to.equal('3.1');
  });

  it('that are very small or large have an exponent', () => {
    expect([1.5e-7, -2e15, 9e14].map((value) => en.number(value))).to.deep.equal([
      '1.5E−7',
      '−2E15',
      '900000000000000',
    ]);
  });

  it('are written as the language writes them', () => {
    expect([de.number(-1234.5, 5), de.value(0.25, 'g'), de.percent(0.125)]).to.deep.equal([
      '−1234,5',
      '0,25 g',
      '12,5\u00a0%',
    ]);
    expect(new Language('ar-EG', english).number(1.5)).to.equal('١٫٥');
  });

  it('have their unit, if they have one', () => {
    expect([en.value(3, 'HU'), en.value(3, ''), en.range(-1, 2, 'dBZ')]).to.deep.equal(['3 HU', '3', '−1 to 2 dBZ']);
  });

  it('that are opacities have three digits, two of them decimals', () => {
    expect([0, 0.00001, 0.0059123, 0.02346, 1].map((opacity) => en.opacity(opacity))).to.deep.equal([
      '0%',
      '< 0.01%',
      '0.59%',
      '2.35%',
      '100%',
    ]);
  });
});

describe('times', () => {
  const evening = '2018-12-20T23:06:28Z';

  it('are in UTC, of 24 hours, whatever the language', () => {
    expect([en, de, new Language('en-US', english)].map((language) => language.clock(evening, false))).to.deep.equal([
      '23:06',
      '23:06',
      '23:06',
    ]);
    expect(en.clock('2018-12-20T00:06:28Z', true)).to.equal('00:06:28');
  });

  it('have days in the language', () => {
    expect([new Language('en-GB', english).day(evening), de.day(evening)]).to.deep.equal([
      '20 Dec 2018',
      '20. Dez. 2018',
    ]);
  });
});

describe('the English words', () => {
  it('are all there, none empty', () => {
    const empty = Object.entries({ ...viewEnglish, ...english })
      .filter(([, term]) => term === '')
      .map(([name]) => name);
    expect(empty).to.deep.equal([]);
    expect(Object.values(viewEnglish.errors).every((text) => /^[A-Z].+\.$/.test(text))).to.equal(true);
  });
});
