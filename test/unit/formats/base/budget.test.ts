import { expect } from '@esm-bundle/chai';
import { Budget, bytesPerFileByte, freeBytes } from '../../../../src/formats/base/budget.ts';
import { errorOf } from '../../../helpers/error-of.ts';

describe('the budget of a load', () => {
  it('allows what every file may take, and a multiple of what was fetched', () => {
    const budget = Budget.ofFile(1000);
    expect(budget.allowedBytes).to.equal(freeBytes + 1000 * bytesPerFileByte);
    budget.addFile(500);
    expect(budget.allowedBytes).to.equal(freeBytes + 1500 * bytesPerFileByte);
  });

  it('allows no more than the device has', () => {
    const budget = new Budget(2 ** 20);
    budget.addFile(2 ** 30);
    budget.take(2 ** 20, 'the file');
    expect(errorOf(() => budget.take(1, 'the file')).code).to.equal('format/too-large');
  });

  it('counts what is held at once, and says what was asked for and what is allowed', () => {
    const budget = Budget.ofFile(0);
    budget.take(freeBytes - 10, 'one part');
    const { code, message } = errorOf(() => budget.take(2 ** 34, 'the other part'));
    expect(code).to.equal('format/too-large');
    expect(message).to.contain('the other part asks for 16,384 MiB').and.contain('allowed 64 MiB');
    budget.giveBack(freeBytes - 10);
    budget.take(freeBytes, 'the other part');
    expect(budget.leftBytes).to.equal(0);
  });

  it('refuses sizes that are no numbers', () => {
    for (const bytes of [NaN, Infinity, -1])
      expect(errorOf(() => Budget.ofFile(0).take(bytes, 'a part')).code).to.equal('format/too-large');
  });

  it('ends what makes and drops for ever', () => {
    const budget = Budget.ofFile(100);
    const error = errorOf(() => {
      for (let i = 0; i < 1e6; i++) {
        budget.take(freeBytes, 'the part');
        budget.giveBack(freeBytes);
      }
    });
    expect(error.message).to.contain('the part takes more than');
  });

  it('ends loops', () => {
    const budget = Budget.ofFile(100);
    expect(
      errorOf(() => {
        for (let i = 0; i < 1e8; i++) budget.step(1, 'a list');
      }).code,
    ).to.equal('format/too-large');
  });
});
