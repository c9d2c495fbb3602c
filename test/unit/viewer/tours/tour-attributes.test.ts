import { expect } from '@esm-bundle/chai';
import { readBy, readDuration, readStepNumber, usualDuration } from '../../../../src/viewer/tours/tour-attributes.ts';
import { errorOf } from '../../../helpers/error-of.ts';

describe('the attributes of a tour', () => {
  it('say how long a move takes', () => {
    expect([null, '0', '1e3', '12.5'].map(readDuration)).to.deep.equal([usualDuration, 0, 1000, 12.5]);
    for (const text of ['', '-1', '1s', 'Infinity', '0x10'])
      expect(errorOf(() => readDuration(text)).message, text).to.contain(`got "${text}"`);
  });

  it('say whether it follows the page', () => {
    expect([null, '', 'scroll', ' SCROLL '].map(readBy)).to.deep.equal([false, false, true, true]);
    expect(errorOf(() => readBy('time')).message).to.contain('got "time"; expected scroll');
  });

  it('say which step is open, of those that there are', () => {
    expect(readStepNumber(null, 3)).to.equal(1);
    expect(['0', '1', '3', '2.0'].map((text) => readStepNumber(text, 3))).to.deep.equal([0, 1, 3, 2]);
    expect(readStepNumber('7', 0), 'before there are steps').to.equal(0);
    for (const text of ['4', '-1', '1.5', 'two', ''])
      expect(errorOf(() => readStepNumber(text, 3)).message, text).to.contain('1 to 3, or 0 for none');
  });
});
