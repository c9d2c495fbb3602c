import { expect } from '@esm-bundle/chai';
import { directionOf } from '../../../packages/lesson-writers/src/direction-of.ts';

describe('the direction of a language', () => {
  it('is that of its usual script, or of the one that it names', () => {
    const rightToLeft = ['ar', 'ar-EG', 'fa', 'he', 'HE-il', 'ur', 'ps', 'az-Arab', 'ku-Arab-IQ'];
    const leftToRight = ['en', 'de', 'pt-BR', 'zh-Hant', 'ja', 'az', 'ku', 'ur-Latn', 'ar-Latn-EG', 'x'];
    expect(rightToLeft.map(directionOf)).to.deep.equal(rightToLeft.map(() => 'rtl'));
    expect(leftToRight.map(directionOf)).to.deep.equal(leftToRight.map(() => 'ltr'));
  });

  // Not dv: V8 says left to right, its data know no direction of Thaana.
  it('is what the browser says, where it says so', () => {
    const textInfo = (language: string): string | undefined => {
      const locale = new Intl.Locale(language) as Intl.Locale & { textInfo?: { direction?: string } };
      return locale.textInfo?.direction;
    };
    const languages = ['ar', 'fa', 'he', 'ur', 'ckb', 'ug', 'sd', 'yi', 'en', 'de', 'ja', 'hi', 'tr'];
    expect(languages.map(directionOf)).to.deep.equal(languages.map((one) => textInfo(one) ?? directionOf(one)));
  });
});
