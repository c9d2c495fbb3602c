import { expect } from '@esm-bundle/chai';
import { describeOrder, fitOrder, minOrder, measureOrders } from '../accuracy/orders.ts';

describe('the reference converges', () => {
  it('with step length, grid spacing and pixel size, as theory has it', () => {
    const rows = measureOrders();
    for (const row of rows) console.log(describeOrder(row));
    expect(rows.length).to.equal(8);
    for (const row of rows) {
      const { study, transferFunction, order, errors } = row;
      expect(order, `${study}, ${transferFunction}`).to.be.at.least(minOrder(row));
      // From what one sees to what nobody does.
      expect(errors[0], `${study}, ${transferFunction}`).to.be.above(0.05 / 255);
      expect(errors.at(-1), `${study}, ${transferFunction}`).to.be.below(errors[0] / 3);
    }
  });

  it('by orders that are what they are of errors with a known order', () => {
    expect(fitOrder([10, 20, 40], [1, 0.25, 0.0625])).to.be.closeTo(2, 1e-12);
    expect(fitOrder([3, 30], [5, 0.5])).to.be.closeTo(1, 1e-12);
  });
});
