import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { parseSurfaces, readSurfaces } from '../../../../src/optics/surfaces/parse-surfaces.ts';

const window = [-100, 300] as const;

describe('surface-values', () => {
  it('are values, colours and opacities, sorted by value; an opacity may be left out', () => {
    expect(parseSurfaces('300 white, 25% rgb(255 0 0 / 50%) 60%, -20 #0f0 0.25', window)).to.deep.equal([
      { value: -20, color: [0, 1, 0], opacity: 0.25 },
      { value: 0, color: [1, 0, 0], opacity: 0.3 },
      { value: 300, color: [1, 1, 1], opacity: 1 },
    ]);
    expect(parseSurfaces('  ', window)).to.deep.equal([]);
  });

  for (const [text, words] of [
    ['300', 'surface 1, "300", got 1 part; expected a value, a colour and perhaps an opacity'],
    ['1 red, , 2 blue', 'surface 2, "", got nothing'],
    ['1 red 2 3', 'got 4 parts'],
    ['high red', 'got the value "high"; expected a number in data units or a percentage of the window'],
    ['1 read', 'got the colour "read"; expected a CSS colour'],
    ['1 red 130%', 'got the opacity "130%"; expected 0 to 1, or 0% to 100%'],
    ['1 red -0.1', 'got the opacity "-0.1"'],
    ['1 red, 2 red, 3 red, 4 red, 5 red', 'got 5 surfaces; expected at most 4'],
    [`1 ${'x'.repeat(300)}`, 'of 300 characters; expected at most 200'],
    ['9'.repeat(9000), 'got 9,000 characters; expected at most 3,200'],
  ]) {
    it(`refuses "${text.slice(0, 40)}" in words`, () => {
      expect(() => parseSurfaces(text, window))
        .to.throw(VolumeViewError, words)
        .with.property('code', 'attribute/invalid');
    });
  }

  it('stand alone where nothing is said of a transfer function, and are lit unless that is said', () => {
    const read = (transferFunction: string | null, shading: 'lit' | 'unlit' | null) =>
      readSurfaces('1 red', window, { transferFunction, shading });
    expect(read(null, null)).to.deep.include({ clear: true }).and.not.have.property('plain');
    expect(read('mri', 'lit')).to.have.all.keys('surfaces');
    expect(read('mri', 'unlit')).to.deep.include({ plain: true }).and.not.have.property('clear');
    expect(readSurfaces('', window, { transferFunction: null, shading: null })).to.equal(null);
  });
});
