// The unit in which lengths are written.
import { expect } from '@esm-bundle/chai';
import { extentOf, unitOfLength, unitOfPlaces, unitOfVolume } from '../../../src/messages/length-unit.ts';

const written = (length: number, extent: number): string => {
  const { unit, perMillimetre } = unitOfLength(length, extent);
  return `${Number((length * perMillimetre).toPrecision(4))} ${unit}`;
};

describe('the unit of a length', () => {
  it('is chosen by the length itself', () => {
    const [body, brain, cell, virus] = [400, 12, 0.06, 0.0004];
    expect([50, 0.7, 0.05].map((length) => written(length, body))).to.deep.equal(['50 mm', '0.7 mm', '50 µm']);
    expect([2, 0.2, 0.05].map((length) => written(length, brain))).to.deep.equal(['2 mm', '0.2 mm', '50 µm']);
    expect([0.2, 0.01, 0.001, 0.0005].map((length) => written(length, cell))).to.deep.equal([
      '200 µm',
      '10 µm',
      '1 µm',
      '500 nm',
    ]);
    expect([0.0001, 0.000_000_5].map((length) => written(length, virus))).to.deep.equal(['100 nm', '0.5 nm']);
    expect(written(10 * 1e-4, cell), 'a sum that is a little too small').to.equal('1 µm');
    expect(written(0.1 * 3 - 0.2, body)).to.equal('0.1 mm');
    for (const odd of [0, NaN, Infinity])
      for (const extent of [0, NaN, Infinity, 1e300]) expect(unitOfLength(odd, extent).unit).to.equal('mm');
  });

  it('is one for all places of a volume', () => {
    expect([400, 1, 0.9, 0.001, 0.0009].map((extent) => unitOfPlaces(extent).unit)).to.deep.equal([
      'mm',
      'mm',
      'µm',
      'µm',
      'nm',
    ]);
    expect(unitOfLength(0, 0.05).unit, 'no length').to.equal('µm');
    expect(extentOf({ dimensions: [100, 50, 2], spacing: [0.1, 0.3, 5] })).to.equal(15);
  });

  it('is that of a cube of a volume', () => {
    expect([5, 0.001, 0.0009, 1e-12, 9e-13, 0].map((volume) => unitOfVolume(volume).unit)).to.deep.equal([
      'mm',
      'mm',
      'µm',
      'µm',
      'nm',
      'mm',
    ]);
  });
});
