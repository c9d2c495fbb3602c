// Answers that a page keeps.
import { expect } from '@esm-bundle/chai';
import { KeptAnswers } from '../../../../src/viewer/questions/kept-answers.ts';

const answer = { asked: 'A', response: 'b', chosen: [1], correct: true, tries: 2 };

function makeStore(): { texts: Map<string, string>; kept: KeptAnswers } {
  const texts = new Map<string, string>();
  const store = {
    getItem: (key: string) => texts.get(key) ?? null,
    setItem: (key: string, text: string) => void texts.set(key, text),
    removeItem: (key: string) => void texts.delete(key),
  };
  return { texts, kept: new KeptAnswers(() => store, '/lesson.html') };
}

describe('kept answers', () => {
  it('are there again, for the same question of the same page only', () => {
    const { texts, kept } = makeStore();
    kept.keep('q', answer);
    expect(kept.recall('q', 'A')).to.deep.equal(answer);
    expect(kept.recall('q', 'another question')).to.equal(null);
    expect(kept.recall('other', 'A')).to.equal(null);
    expect([...texts.keys()]).to.deep.equal(['volume-question /lesson.html#q']);
    kept.forget('q');
    expect(kept.recall('q', 'A')).to.equal(null);
  });

  it('that are damaged, or of another hand, are none', () => {
    const { texts, kept } = makeStore();
    const damaged = [
      '',
      '{',
      'null',
      '[]',
      '"x"',
      '{"asked":"A"}',
      JSON.stringify({ ...answer, tries: -1 }),
      JSON.stringify({ ...answer, chosen: ['a'] }),
      JSON.stringify({ ...answer, response: { x: 1 } }),
    ];
    for (const text of damaged) {
      texts.set('volume-question /lesson.html#q', text);
      expect(kept.recall('q', 'A'), text).to.equal(null);
    }
  });

  it('are none where the page has no storage', () => {
    const kept = new KeptAnswers(() => {
      throw new DOMException('no', 'SecurityError');
    }, '/');
    kept.keep('q', answer);
    kept.forget('q');
    expect(kept.recall('q', 'A')).to.equal(null);
  });
});
