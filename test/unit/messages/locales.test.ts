// The languages that come with the package: each says all that English says, with all that is put into it.
import { expect } from '@esm-bundle/chai';
import { english as authoring } from '../../../src/messages/english-authoring.ts';
import { english as blank } from '../../../src/messages/english-blank.ts';
import { english as clip } from '../../../src/messages/english-clip.ts';
import { english as companions } from '../../../src/messages/english-companions.ts';
import { english as controls } from '../../../src/messages/english-controls.ts';
import { english as curve } from '../../../src/messages/english-curve.ts';
import { english as handles } from '../../../src/messages/english-handles.ts';
import { english as labels } from '../../../src/messages/english-labels.ts';
import { english as measure } from '../../../src/messages/english-measure.ts';
import { english as notices } from '../../../src/messages/english-notices.ts';
import { english as notes } from '../../../src/messages/english-notes.ts';
import { english as plane } from '../../../src/messages/english-plane.ts';
import { english as questions } from '../../../src/messages/english-questions.ts';
import { english as readout } from '../../../src/messages/english-readout.ts';
import { english as slices } from '../../../src/messages/english-slices.ts';
import { english as compare } from '../../../src/messages/english-compare.ts';
import { english as drop } from '../../../src/messages/english-drop.ts';
import { english as tours } from '../../../src/messages/english-tours.ts';
import { english as view } from '../../../src/messages/english-view.ts';
import { loadLanguage } from '../../../src/messages/load-language.ts';

const english: Record<string, unknown> = {
  ...authoring,
  ...blank,
  ...clip,
  ...companions,
  ...controls,
  ...curve,
  ...handles,
  ...labels,
  ...measure,
  ...notes,
  ...notices,
  ...plane,
  ...questions,
  ...readout,
  ...slices,
  ...tours,
  ...compare,
  ...drop,
  ...view,
};
const codes = ['ar', 'de', 'es', 'fr', 'ja', 'pt', 'zh'];

/** All texts of some words, by their path; those with parts are called with marks for them. */
function listTexts(words: unknown, path = ''): [path: string, text: string][] {
  if (typeof words === 'string') return [[path, words]];
  if (typeof words === 'function') {
    const marks = new Proxy({}, { get: (_, name) => `<${String(name)}>` });
    const takesObject = path.endsWith('windowWords');
    const given = takesObject
      ? [marks]
      : Array.from({ length: words.length }, (_, i) => (path.endsWith('scale') && i === 2 ? ['<c>', '<d>'] : `<${i}>`));
    return [[path, (words as (...all: unknown[]) => string)(...given)]];
  }
  return Object.entries(words as object).flatMap(([name, inner]) => listTexts(inner, `${path}.${name}`));
}

const marksIn = (text: string): Set<string> => new Set(text.match(/<[^>\s]+>/g));

describe('the languages of the package', () => {
  const expected = new Map(listTexts(english));

  for (const code of codes) {
    it(`${code} has every text, and puts into it what English puts into it`, async () => {
      const texts = new Map(listTexts(await loadLanguage(code)));
      expect(
        [...expected.keys()].filter((path) => !texts.has(path)),
        'texts that are missing',
      ).to.deep.equal([]);
      expect(
        [...texts.keys()].filter((path) => !expected.has(path)),
        'texts that nobody asks for',
      ).to.deep.equal([]);
      for (const [path, text] of texts) {
        if (path !== '.letter.above') expect(text.trim(), path).to.not.equal('');
        expect(marksIn(text), path).to.deep.equal(marksIn(expected.get(path)!));
      }
    });

    it(`${code} is another language than English`, async () => {
      const texts = listTexts(await loadLanguage(code)).filter(([, text]) => text.length > 6);
      const same = texts.filter(([path, text]) => expected.get(path) === text);
      expect(same.length / texts.length, same.map(([path]) => path).join()).to.be.below(0.05);
    });
  }

  it('are found by any tag of the language, and Chinese in traditional characters is not mistaken for it', async () => {
    expect(await loadLanguage('de-AT')).to.equal(await loadLanguage('de'));
    expect(await loadLanguage('pt-BR')).to.equal(await loadLanguage('pt'));
    expect(await loadLanguage('zh-CN')).to.equal(await loadLanguage('zh'));
    for (const code of ['zh-TW', 'zh-Hant', 'nl', 'xx']) expect(await loadLanguage(code), code).to.equal(null);
  });

  it('keeps the letters of a patient’s sides, which radiologists of all languages know', async () => {
    for (const code of codes) expect((await loadLanguage(code))!.patient).to.deep.equal(readout.patient);
  });
});
