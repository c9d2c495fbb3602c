// What a question asks, and which responses are right.
import { expect } from '@esm-bundle/chai';
import {
  foldText,
  isRight,
  readNumbers,
  readQuestion,
  takesSeveral,
} from '../../../../src/viewer/questions/question.ts';
import type { Choice, Response } from '../../../../src/viewer/questions/question.ts';

const read = (attributes: Record<string, string>, choices: readonly Choice[] = []) =>
  readQuestion((name) => attributes[name] ?? null, choices);
const choice = (text: string, isCorrect = false): Choice => ({ text, isCorrect });
const problemOf = (attributes: Record<string, string>, choices: readonly Choice[] = []): string => {
  try {
    read(attributes, choices);
  } catch (error) {
    return `${(error as { code: string }).code}: ${(error as Error).message}`;
  }
  return 'none';
};

describe('a question', () => {
  it('takes the one right choice, or all of several, and no other', () => {
    const one = read({}, [choice('a'), choice('b', true), choice('c')]);
    expect(takesSeveral(one)).to.equal(false);
    expect([[0], [1], [2], [], [0, 1]].map((chosen) => isRight(one, { chosen }, null))).to.deep.equal([
      false,
      true,
      false,
      false,
      false,
    ]);
    const two = read({ type: 'choice' }, [choice('a', true), choice('b', true), choice('c')]);
    expect(takesSeveral(two)).to.equal(true);
    expect([[0], [1, 0], [0, 1, 2], [2]].map((chosen) => isRight(two, { chosen }, null))).to.deep.equal([
      false,
      true,
      false,
      false,
    ]);
  });

  it('finds a place within its radius, to the edge', () => {
    const question = read({ type: 'find', position: '10 20 30', radius: '5' });
    const at = (x: number): Response => ({ position: [x, 20, 30] });
    expect([5, 4.99, 15, 15.01].map((x) => isRight(question, at(x), [10, 20, 30]))).to.deep.equal([
      true,
      false,
      true,
      false,
    ]);
    expect(isRight(question, at(10), null), 'while the place is not known').to.equal(false);
  });

  it('finds any of its labels', () => {
    const question = read({ type: 'find', of: '10 49' });
    const labels = ['10', '49', '1', undefined];
    expect(
      labels.map((label) => isRight(question, { position: [0, 0, 0], ...(label && { label }) }, null)),
    ).to.deep.equal([true, true, false, false]);
    expect(question.place).to.deep.equal({ kind: 'label', id: 10 });
  });

  it('takes a name without regard to case, accents, blanks and hyphens', () => {
    const question = read({ type: 'label', of: '3', answer: 'Hémisphère droit, right hemisphere' });
    const right = ['hemisphere droit', ' HÉMISPHÈRE  DROIT ', 'Right-Hemisphere', 'hémisphe\u0300re droit'];
    expect(right.filter((text) => !isRight(question, { text }, null))).to.deep.equal([]);
    expect(['hemisphere', 'left hemisphere', ''].filter((text) => isRight(question, { text }, null))).to.deep.equal([]);
    expect(foldText('がく'), 'another letter, not an accent').to.not.equal(foldText('かく'));
    expect(foldText('Ελλάδα')).to.equal(foldText('ελλαδα'));
  });

  it('takes a value within its tolerance, as people write numbers', () => {
    const question = read({ type: 'value', answer: '0.3', tolerance: '0.1' });
    const right = ['0.3', '0,25', '.4', '0.2 dBZ', '٠٫٣', '3e-1'];
    expect(right.filter((text) => !isRight(question, { text }, null))).to.deep.equal([]);
    const wrong = ['0.41', '-0.3', 'a third', '', '0.3 0.3', '1e999'];
    expect(wrong.filter((text) => isRight(question, { text }, null))).to.deep.equal([]);
    expect(readNumbers('−12,5')).to.deep.equal([-12.5]);
    const thousands: [string, number[]][] = [
      ['1,000', [1, 1000]],
      ['1.000 m', [1, 1000]],
      ['1 000', [1000]],
      ['12.345.678', [12345678]],
      ['1,234.5', [1234.5]],
      ['1.234,5', [1234.5]],
      ['0,500', [0.5]],
      ['1,0000', [1]],
      ['1000', [1000]],
    ];
    for (const [text, numbers] of thousands) expect([text, readNumbers(text)]).to.deep.equal([text, numbers]);
    expect(isRight(read({ type: 'value', answer: '45' }), { text: '45.0' }, null)).to.equal(true);
  });

  it('says in words what its author can mend', () => {
    const two = [choice('a', true), choice('b')];
    const problems: [Record<string, string>, RegExp, (readonly Choice[])?][] = [
      [{ type: 'quiz' }, /type of <volume-question> got "quiz"; expected choice or find or label or value/],
      [{}, /got a list of 0 answers; expected a list between its tags/],
      [{}, /got no answer that is correct/, [choice('a'), choice('b')]],
      [{ type: 'find' }, /<volume-question> got no place/],
      [{ type: 'find', position: '1 2 3' }, /radius of <volume-question> got ""; expected a number above 0/],
      [{ type: 'find', position: '1 2 3', radius: '-1' }, /radius/],
      [{ type: 'find', position: '1 2', radius: '1' }, /position of <volume-question> got "1 2"/],
      [{ type: 'find', of: 'thalamus' }, /of of <volume-question> got "thalamus"; expected numbers of labels/],
      [{ type: 'label' }, /answer of <volume-question> got ""; expected the right names/],
      [{ type: 'label', answer: ' , ' }, /answer/],
      [{ type: 'value', answer: 'many' }, /answer of <volume-question> got "many"; expected the right value/],
      [
        { type: 'value', answer: '4', tolerance: '-1' },
        /tolerance of <volume-question> got "-1"; expected a number from 0/,
      ],
      [{ tries: '0' }, /tries of <volume-question> got "0"; expected a whole number from 1/, two],
      [{ remember: '' }, /remember without an id/, two],
    ];
    for (const [attributes, expected, choices] of problems) {
      const problem = problemOf(attributes, choices);
      expect(problem, JSON.stringify(attributes)).to.match(expected);
      expect(problem).to.match(/^attribute\/invalid/);
    }
    expect(problemOf({ remember: '', id: 'q' }, two)).to.equal('none');
  });

  it('reads no names of a prototype and no endless texts', () => {
    expect(problemOf({ type: '__proto__' })).to.match(/attribute\/invalid/);
    const long = 'x'.repeat(1e6);
    expect(foldText(long).length).to.be.at.most(500);
    expect(problemOf({ type: long }).length).to.be.below(300);
  });
});
