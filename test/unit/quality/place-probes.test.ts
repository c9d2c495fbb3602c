import { expect } from '@esm-bundle/chai';
import { isWorthSearch, moreProbes, placeAround, placeProbes } from '../../../src/quality/place-probes.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

describe('the pixels that are probed', () => {
  it('lie in the rectangle, are about one in 85, and never on one lattice alone', () => {
    for (const [width, height] of [
      [512, 512],
      [1600, 900],
      [300, 200],
      [33, 700],
    ]) {
      const rectangle = { left: 7, bottom: 11, width, height };
      const lattices = placeProbes(rectangle, true);
      const count = lattices.reduce((sum, one) => sum + one.width * one.height, 0);
      expect(count / Math.min(4096, Math.max(1024, (width * height) / 85)), `${width} x ${height}`).to.be.within(
        0.6,
        1.6,
      );
      for (const { stride, first, ...size } of lattices) {
        expect(first[0]).to.be.within(7, 7 + stride);
        expect(first[0] + (size.width - 1) * stride).to.be.below(7 + width);
        expect(first[1] + (size.height - 1) * stride).to.be.below(11 + height);
      }
      expect(lattices.length === 2 ? lattices[1].stride - lattices[0].stride : 3).to.equal(3);
    }
  });

  it('are more where few of them meet the volume, as many as add information and no more than there is time for', () => {
    expect(moreProbes(900, 1024)).to.equal(1);
    expect(moreProbes(64, 1024)).to.equal(4);
    expect(moreProbes(0, 1024)).to.equal(64);
    expect(moreProbes(1, 4096)).to.equal(16);
    expect(moreProbes(480, 1024, true), 'of which one in a thousand is looked for').to.equal(6.25);
    expect(moreProbes(3000, 4096, true)).to.equal(1);
    const rectangle = { left: 0, bottom: 0, width: 800, height: 600 };
    const countOf = (times: number): number =>
      placeProbes(rectangle, true, times).reduce((sum, one) => sum + one.width * one.height, 0);
    for (const times of [2, 8, 16])
      expect(countOf(times) / countOf(1), `${times} times`).to.be.within(0.75 * times, 1.3 * times);
    expect(placeProbes(rectangle, true, 400)).to.have.length(1);
  });

  it('are all pixels of a small rectangle', () => {
    expect(placeProbes({ left: 3, bottom: 4, width: 20, height: 10 }, false)).to.deep.equal([
      { stride: 1, first: [3, 4], width: 20, height: 10 },
    ]);
    expect(placeProbes({ left: 1, bottom: 2, width: 128, height: 128 }, true)).to.deep.equal([
      { stride: 1, first: [1, 2], width: 128, height: 128 },
    ]);
    expect(placeProbes({ left: 1, bottom: 2, width: 128, height: 128 }, false)).to.have.length(2);
    expect(placeProbes({ left: 0, bottom: 0, width: 1, height: 1 }, false)).to.deep.equal([
      { stride: 1, first: [0, 0], width: 1, height: 1 },
    ]);
  });

  it('are searched for among all pixels where so few met something that it may be one thing of several', () => {
    const some = placeProbes({ left: 0, bottom: 0, width: 800, height: 600 }, false, 8);
    expect(isWorthSearch(some, 0)).to.equal(true);
    expect(isWorthSearch(some, 500)).to.equal(false);
    expect(
      isWorthSearch(placeProbes({ left: 0, bottom: 0, width: 20, height: 10 }, false), 0),
      'all are probed',
    ).to.equal(false);
  });

  it('are all pixels that show something where these are few', () => {
    const random = randomNumbers(8);
    for (const count of [1, 2, 30, 900]) {
      const shown = Array.from({ length: count }, (): [number, number] => [
        Math.floor(3000 * random()),
        Math.floor(200 * random()),
      ]);
      const lattices = placeAround(shown);
      expect(lattices.length).to.be.within(1, 32);
      const isProbed = ([x, y]: [number, number]): boolean =>
        lattices.some(({ stride, first, width, height }) =>
          [
            [x, 0, width],
            [y, 1, height],
          ].every(
            ([at, axis, pixels]) =>
              at >= first[axis] && at < first[axis] + stride * pixels && (at - first[axis]) % stride === 0,
          ),
        );
      const area = lattices.reduce((sum, { width, height }) => sum + width * height, 0);
      expect(area).to.be.below(2 ** 16 + 2 ** 12);
      expect(shown.filter(isProbed).length / count, String(count)).to.be.within(count > 100 ? 0.1 : 1, 1);
    }
    expect(placeAround([[17, 30]])).to.deep.equal([{ stride: 1, first: [17, 30], width: 1, height: 1 }]);
  });
});
