import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { parseGradientOpacity } from '../../../../src/optics/transfer/parse-gradient-opacity.ts';
import { resolveAppearance } from '../../../../src/viewer/appearance/resolve-appearance.ts';
import { plainAppearance } from '../../../../src/viewer/model/plain-appearance.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

describe('gradient-opacity', () => {
  it('is gradients and factors: a number is one, a percentage is of the window along a reference length', () => {
    expect(parseGradientOpacity('0 0, 12.5 20%,10% 1', 400)).to.deep.equal([
      [0, 0],
      [12.5, 0.2],
      [40, 1],
    ]);
    expect(parseGradientOpacity('  ', 1)).to.deep.equal([]);
  });

  it('is of the window and the reference length that the look has', async () => {
    const volume = syntheticVolume({ dimensions: [8, 8, 8], kind: 'float32' });
    const appearance = {
      ...plainAppearance,
      transferFunction: '0 red 0, 1 red 1',
      window: [10, 30] as const,
      referenceLength: 4,
      gradientOpacity: '50% 0.5',
    };
    expect((await resolveAppearance(appearance, volume)).styles).to.deep.equal([
      { weight: 1, styles: [{ kind: 'gradient', stops: [[2.5, 0.5]] }] },
    ]);
    expect(await resolveAppearance({ ...appearance, gradientOpacity: null }, volume)).to.not.have.property('styles');
  });

  for (const [text, words] of [
    ['10%', 'stop 1, "10%", got 1 part; expected a gradient and a factor, like "10% 1"'],
    ['0 0,', 'stop 2, "", got nothing'],
    ['0 0, 1 1 1', 'stop 2, "1 1 1", got 3 parts'],
    [
      '-1 0',
      'got the gradient "-1"; expected a number from 0 on, in data units per world unit, or a percentage of the window along a reference length',
    ],
    ['steep 1', 'got the gradient "steep"'],
    ['1 120%', 'got the factor "120%"; expected 0 to 1, or 0% to 100%'],
    ['9 0, 8 1', 'stop 2 got a gradient below that of the stop before it; expected gradients that rise'],
    [`1 ${'1'.repeat(300)}`, 'of 300 characters; expected at most 200'],
    ['1 1,'.repeat(80), 'got 81 stops; expected at most 64'],
    ['9'.repeat(30_000), 'got 30,000 characters; expected at most 25,600'],
  ]) {
    it(`refuses "${text.slice(0, 40)}" in words`, () => {
      expect(() => parseGradientOpacity(text, 1))
        .to.throw(VolumeViewError, words)
        .with.property('code', 'attribute/invalid');
    });
  }
});
