import { expect } from '@esm-bundle/chai';
import type { VolumeViewError } from '../../../../src/core/errors.ts';
import type { ScanModel } from '../../../../src/viewer/model/scan-model.ts';
import { checkAttribute } from '../../../../src/viewer/links/check-attribute.ts';
import { linkAttributes } from '../../../../src/viewer/links/link-attributes.ts';

/** For each attribute that a link may have: a good text, and one that can't be read. */
const texts: Readonly<Record<string, readonly [good: string, bad: string]>> = {
  look: ['bone', 'shiny'],
  'transfer-function': ['0 #000 0, 50% red 1', 'javascript:alert(1)'],
  'transfer-function-2d': ['box 0 1 0 1 red 50%', 'box 0'],
  'value-window': ['-150 250', '250 -150'],
  'reference-length': ['2', '0'],
  'opacity-factor': ['0.5', '-1'],
  'light-factor': ['2', '1e99'],
  projection: ['max', 'constructor'],
  shading: ['lit', '__proto__'],
  'surface-values': ['100 red 50%', '100 nocolor'],
  'gradient-opacity': ['0 0, 10% 1', '1'],
  'camera-orbit': ['30deg 70deg 110%', '30px'],
  'camera-target': ['1 2 3', '1 2'],
  'field-of-view': ['30deg', '200deg'],
  time: ['2018-12-20T06:06:28Z', 'yesterday'],
  cursor: ['1 2 3', 'x y z'],
  cutout: ['0 0 0 1 1 1', '0 0 0'],
  crosshair: ['none', 'maybe'],
  region: ['0 0 0 1 1 1', '1'],
  rings: ['25', '-25'],
};

describe('a text that a link gives to an attribute', () => {
  it('may name a window, which the file has to have as soon as it is there', async () => {
    expect(await checkAttribute('value-window', 'lung', null)).to.equal(null);
    const windows = [{ name: 'lung', from: -1350, to: 149, width: 1500, level: -600 }];
    const volume = { unit: 'HU', grid: { kind: 'cartesian' }, range: [0, 1], referenceLength: 1, windows };
    expect(await checkAttribute('value-window', 'lung', volume as unknown as ScanModel)).to.equal(null);
    expect((await checkAttribute('value-window', 'bone', volume as unknown as ScanModel))?.aspect).to.equal('optics');
  });

  it('is known for all of them', () => {
    expect(Object.keys(texts)).to.have.members([...linkAttributes]);
  });

  for (const [name, [good, bad]] of Object.entries(texts)) {
    it(`${name} is read as the view reads it`, async () => {
      expect(await checkAttribute(name, good, null)).to.equal(null);
      const problem = await checkAttribute(name, bad, null);
      const { code, message } = problem!.error as VolumeViewError;
      expect(code).to.be.oneOf(['attribute/invalid', 'transfer-function/syntax']);
      expect(message).to.include(name);
    });
  }
});
