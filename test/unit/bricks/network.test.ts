import { expect } from '@esm-bundle/chai';
import { arrivalTimes } from '../../bench/bricks/network.ts';

describe('A connection of the simulator', () => {
  it('takes one delay for all requests that are under way together', () => {
    const times = arrivalTimes([100, 100, 100], { delay: 1, bandwidth: 100 }, { atOnce: 8, first: 0 });
    expect([...times]).to.deep.equal([2, 3, 4]);
  });

  it('asks for no more than some at once', () => {
    const times = arrivalTimes([1, 1, 1, 1], { delay: 10, bandwidth: 1e9 }, { atOnce: 2, first: 0 });
    expect([...times].map(Math.round)).to.deep.equal([10, 10, 20, 20]);
  });

  it('waits for the first ones before it asks for others', () => {
    const times = arrivalTimes([1, 1, 1], { delay: 10, bandwidth: 1e9 }, { atOnce: 8, first: 2 });
    expect([...times].map(Math.round)).to.deep.equal([10, 10, 20]);
  });
});
