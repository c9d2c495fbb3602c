import { expect } from '@esm-bundle/chai';
import { millimetresOf } from '../../../../src/formats/base/length-units.ts';

describe('units of length', () => {
  it('are symbols, whose case counts, and words in any case, singular or plural', () => {
    const known: [unit: string, millimetres: number][] = [
      ['mm', 1],
      ['\u00b5m', 1e-3],
      ['\u03bcm', 1e-3],
      ['um', 1e-3],
      ['\u00c5', 1e-7],
      [' Micrometers ', 1e-3],
      ['micrometre', 1e-3],
      ['MILLIMETER', 1],
      ['millimetres', 1],
      ['inch', 25.4],
      ['pt', 25.4 / 72],
    ];
    for (const [unit, millimetres] of known) expect(millimetresOf(unit), unit).to.equal(millimetres);
  });

  it('are unknown where they are none, or a megametre', () => {
    for (const unit of ['pixel', 'Mm', '', 's', 3, null, undefined, 'constructor'])
      expect(millimetresOf(unit), String(unit)).to.equal(undefined);
  });
});
