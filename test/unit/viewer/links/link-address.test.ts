import { expect } from '@esm-bundle/chai';
import { VolumeViewAttributes } from '../../../../components/volume-view/volume-view-attributes.ts';
import { readLink, writeLink } from '../../../../src/viewer/links/link-address.ts';
import { linkAttributes } from '../../../../src/viewer/links/link-attributes.ts';

const entries = (hash: string, id = 'heart'): object | null => {
  const link = readLink(hash, id);
  return link && { step: link.step, ...Object.fromEntries(link.attributes) };
};

/** A source of chance that is the same in each run (mulberry32). */
function chance(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

describe('the address of a link', () => {
  it('has the id of the view, a step, and attributes', () => {
    expect(entries('#heart?step=2&camera-orbit=30deg%2070deg+90&look=bone')).to.deep.equal({
      step: 2,
      'camera-orbit': '30deg 70deg 90',
      look: 'bone',
    });
    expect(entries('#heart?')).to.deep.equal({ step: null });
  });

  it('is for one view', () => {
    for (const hash of [
      '',
      '#',
      '#heart',
      '#lung?step=2',
      'heart?step=2',
      '#%E0%A4%A?step=2',
      '#?step=2',
      '#heart%3Fstep=2',
    ])
      expect(entries(hash), hash).to.equal(null);
    expect(entries('#?step=2', ''), 'a view without id').to.equal(null);
    expect(entries('#das%20Herz?step=2', 'das Herz')).to.deep.equal({ step: 2 });
  });

  it('comes back as it was written', () => {
    const attributes = new Map([
      ['transfer-function', '-400 #c98f73 0, 1e+3 rgb(1% 2% 3% / 0.5) 60%'],
      ['camera-orbit', '-30deg 70deg 1.5'],
      ['rings', ''],
      ['region', "1 2 3 4 5 6&step=7#?=+%20'()*!ä"],
    ]);
    for (const step of [null, 0, 3]) {
      const hash = writeLink('das Herz?&', { step, attributes });
      expect(hash).to.match(/^#[\w%.~-]+\?[\w%.~,&=+-]*$/);
      expect(readLink(hash, 'das Herz?&')).to.deep.equal({ step, attributes });
      // An address, as a browser keeps it.
      expect(readLink(new URL(hash, 'https://page.example/').hash, 'das Herz?&')).to.deep.equal({ step, attributes });
    }
  });

  it('takes only attributes of the view, and none that names data or starts something', () => {
    const all = [...VolumeViewAttributes.elementProperties.values()].map(({ attribute }) => attribute);
    expect(all).to.include.members([...linkAttributes]);
    for (const name of [
      'src',
      'poster',
      'moment',
      'stack',
      'spacing',
      'autoplay',
      'auto-rotate',
      'self-check',
      'loading',
      'alt',
      'controls',
    ])
      expect(linkAttributes, name).not.to.include(name);
    expect(
      entries('#heart?src=evil.nii&poster=evil.png&id=x&style=x&onclick=alert(1)&crossorigin&alt=x&autoplay&steps=4'),
    ).to.deep.equal({
      step: null,
    });
  });

  it('takes the first of several values, and no step that is no number', () => {
    expect(entries('#heart?look=bone&look=skin&step=1&step=2')).to.deep.equal({ step: 1, look: 'bone' });
    for (const step of ['', '-1', '1.5', '1e3', '99999', 'x', '2%00', ' 2'])
      expect(entries(`#heart?step=${step}`)).to.deep.equal({ step: null });
  });

  it('is not read where it is too long', () => {
    expect(entries(`#heart?look=bone&x=${'a'.repeat(8000)}`)).to.equal(null);
    expect(entries(`#heart?look=${'a'.repeat(4001)}&region=1`)).to.deep.equal({ step: null, region: '1' });
  });

  it('of a stranger gives allowed attributes with short texts, and throws nothing', () => {
    const random = chance(37);
    const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)];
    const names = [
      ...linkAttributes, ...linkAttributes, 'src', 'SRC', 'srcdoc', 'poster', 'style', 'onerror', 'onload', 'id', 'is', 'slot', '__proto__', 'constructor',
      'prototype', 'toString', 'hasOwnProperty', 'step', 'Step', '', ' look', 'look ', 'look\0', 'LOOK', 'look[]', 'look.src', 'camera-orbit[__proto__]',
    ]; // prettier-ignore
    const texts = [
      'javascript:alert(1)', 'data:text/html,<script>alert(1)</script>', '<img src=x onerror=alert(1)>', '%', '%zz', '%E0%A4%A', '%00', '%u0041', '+', '%2B',
      '__proto__', '{"__proto__":{"x":1}}', 'a'.repeat(3999), 'a'.repeat(5000), '1e999', '-0', 'NaN', '30deg 70deg 90', '\u202e', '\ud800', 'bone', '', ' ', '"><', '&amp;', '#', '?', '=',
    ]; // prettier-ignore
    const shape = Object.getOwnPropertyNames(Object.prototype).join();
    let read = 0;
    for (let i = 0; i < 1000; i++) {
      const pairs = Array.from(
        { length: Math.floor(random() * 9) },
        () => `${pick(names)}${pick(['=', '=', '=', '', '=='])}${pick(texts)}`,
      );
      const hash = `${pick(['#', '#', '#', '', '##'])}${pick(['heart', 'heart', 'heart', 'h%65art', '%', '', '__proto__'])}${pick(['?', '?', '?', '', '??', '&'])}${pairs.join(pick(['&', '&', ';', '#']))}`;
      const link = readLink(hash, 'heart');
      if (!link) continue;
      read++;
      expect(link.step === null || Number.isInteger(link.step), hash).to.equal(true);
      for (const [name, text] of link.attributes) {
        expect(linkAttributes, hash).to.include(name);
        expect(text.length, hash).to.be.at.most(4000);
      }
      expect(readLink(writeLink('heart', link), 'heart') === null, hash).to.equal(
        writeLink('heart', link).length > 8000,
      );
    }
    expect(read).to.be.above(200);
    expect(Object.getOwnPropertyNames(Object.prototype).join()).to.equal(shape);
  });
});
