import { expect } from '@esm-bundle/chai';
import { chooseChecks, compareRay, placeChecks, sumUpChecks } from '../../../src/quality/compare-rays.ts';
import type { RayVariant } from '../../../src/quality/compare-rays.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

describe('rays that are checked', () => {
  it('lie within what can be seen, at most a few hundred, wherever they begin', () => {
    for (const rectangle of [
      { left: 3, bottom: 5, width: 512, height: 300 },
      { left: 0, bottom: 0, width: 1, height: 1 },
      { left: 7, bottom: 2, width: 2, height: 900 },
      { left: 1, bottom: 1, width: 4000, height: 3000 },
    ]) {
      for (const begin of [0, 0.5, 1 - 1e-9]) {
        const {
          stride,
          first: [x, y],
          width,
          height,
        } = placeChecks(rectangle, () => begin);
        expect(width, 'columns').to.be.at.least(1);
        expect(height, 'rows').to.be.at.least(1);
        expect(width * height).to.be.at.most(1000);
        expect(x).to.be.at.least(rectangle.left);
        expect(y).to.be.at.least(rectangle.bottom);
        expect(x + (width - 1) * stride).to.be.below(rectangle.left + rectangle.width);
        expect(y + (height - 1) * stride).to.be.below(rectangle.bottom + rectangle.height);
      }
    }
  });

  it('come to every pixel in time', () => {
    const random = randomNumbers(5);
    const seen = new Set<string>();
    for (let time = 0; time < 400; time++) {
      const { first, stride } = placeChecks({ left: 0, bottom: 0, width: 100, height: 100 }, random);
      expect(stride).to.equal(5);
      seen.add(String(first));
    }
    expect(seen.size).to.equal(25);
  });

  it('are 20 of those that show something, and 4 of the others, spread over all', () => {
    const picture = new Float32Array(4 * 100);
    for (let ray = 40; ray < 80; ray++) picture[4 * ray + 3] = 0.5;
    const chosen = chooseChecks(picture, () => 0.99);
    const shown = chosen.filter((ray) => picture[4 * ray + 3] > 0);
    expect(new Set(chosen).size).to.equal(24);
    expect(shown).to.have.length(20);
    expect(Math.min(...shown)).to.be.below(43);
    expect(Math.max(...shown)).to.be.above(76);
  });

  it('are as many as there are where there are few', () => {
    const picture = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 0.5);
    expect(chooseChecks(picture, () => 0.5)).to.deep.equal([0, 1]);
    expect(chooseChecks(new Float32Array(0), () => 0.5)).to.deep.equal([]);
  });
});

describe('how a ray of the GPU compares', () => {
  const own = [0.2, 0.3, 0.1, 0.5];

  it('is its largest difference of any channel, 1/255', () => {
    const { apart, isEdge } = compareRay([0.2, 0.3, 0.1, 0.5 + 9 / 255], () => own);
    expect(apart).to.be.closeTo(9, 1e-6);
    expect(isEdge).to.equal(false);
  });

  it('hangs by a thread only where it is off and a ray a thousandth of a pixel away shows something else', () => {
    const edge = ({ shift: [x] }: RayVariant): number[] => (x > 0 ? [0, 0, 0, 0] : own);
    expect(compareRay([0, 0, 0, 0], edge).isEdge).to.equal(true);
    expect(compareRay([0, 0, 0, 0], ({ digits }) => (digits === 3 ? [0, 0, 0, 0] : own)).isEdge, 'by a digit').to.equal(
      true,
    );
    expect(compareRay(own, edge).isEdge).to.equal(false);
    expect(compareRay([0, 0, 0, 0], () => own).isEdge).to.equal(false);
  });

  it('is as wrong as can be where the GPU draws no number, at an edge as well', () => {
    const edge = ({ shift: [x] }: RayVariant): number[] => (x > 0 ? [0, 0, 0, 0] : own);
    expect(compareRay([NaN, 0, 0, 0], edge)).to.deep.equal({ apart: Infinity, isEdge: false });
  });

  it('counts, and one ray in twenty may be off', () => {
    const good = { apart: 0.3, isEdge: false };
    const bad = { apart: 40, isEdge: false };
    const edge = { apart: 90, isEdge: true };
    expect(sumUpChecks([...Array.from({ length: 22 }, () => good), bad, edge])).to.deep.equal({
      rays: 24,
      edges: 1,
      off: 1,
      max: 40,
      agrees: true,
    });
    expect(sumUpChecks([...Array.from({ length: 22 }, () => good), bad, bad]).agrees).to.equal(false);
    expect(sumUpChecks([bad]).agrees).to.equal(false);
    expect(sumUpChecks([])).to.deep.equal({ rays: 0, edges: 0, off: 0, max: 0, agrees: true });
  });
});
