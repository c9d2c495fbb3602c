// What H5P keeps and asks of a lesson: answers, score and state.
import { expect } from '@esm-bundle/chai';
import { CourseRecord } from '../../../packages/embed/src/course-record.ts';
import type { KeptRecord, Statement } from '../../../packages/embed/src/course-record.ts';

const lesson = 'https://example.org/lesson';
const open = (kept?: KeptRecord): CourseRecord => {
  const record = new CourseRecord(kept, { answered: () => undefined, completed: () => undefined });
  record.questions = 2;
  return record;
};

/** An answer, as the script of the course writes it. */
function answer(record: CourseRecord, id: string, response: string, result: 'correct' | 'incorrect'): void {
  const name = `cmi.interactions.${record.GetValue('cmi.interactions._count')}`;
  record.SetValue(`${name}.id`, id);
  record.SetValue(`${name}.type`, 'choice');
  record.SetValue(`${name}.correct_responses.0.pattern`, 'b');
  record.SetValue(`${name}.learner_response`, response);
  record.SetValue(`${name}.result`, result);
}

const statementsOf = ({ answers }: CourseRecord): [id: string, response: unknown, success: unknown][] =>
  answers.map((write) => {
    const data: { statement: Statement } = { statement: { object: { id: lesson } } };
    write({ data });
    const { object, result } = data.statement;
    const { response, success } = result as { response: unknown; success: unknown };
    return [object.id, response, success];
  });

describe('the record of a lesson in H5P', () => {
  it('has the last answer to each question, also at the next visit, and counts on', () => {
    const first = open();
    answer(first, 'one', 'a', 'incorrect');
    answer(first, 'two', 'c', 'incorrect');
    answer(first, 'one', 'b', 'correct');
    first.SetValue('cmi.score.scaled', '0.5');
    const expected = [
      [`${lesson}?subContentId=one`, 'b', true],
      [`${lesson}?subContentId=two`, 'c', false],
    ];
    expect(statementsOf(first)).to.deep.equal(expected);
    const next = open(JSON.parse(JSON.stringify(first.kept)) as KeptRecord);
    expect(statementsOf(next)).to.deep.equal(expected);
    expect([next.score, next.hasAnswers, next.GetValue('cmi.interactions._count')]).to.deep.equal([1, true, '2']);
    answer(next, 'two', 'b', 'correct');
    expect(statementsOf(next)[1]).to.deep.equal([`${lesson}?subContentId=two`, 'b', true]);
  });

  it('is empty when it is cleared', () => {
    const record = open();
    answer(record, 'one', 'b', 'correct');
    record.SetValue('cmi.score.scaled', '0.5');
    record.SetValue('cmi.completion_status', 'completed');
    record.clear();
    expect(record.kept).to.deep.equal({});
    expect([record.score, record.hasAnswers, record.isComplete, record.answers.length]).to.deep.equal([
      0,
      false,
      false,
      0,
    ]);
  });

  it('takes nothing else from a state that a host gives it', () => {
    const kept = {
      'cmi.interactions.0.id': 'x',
      'cmi.interactions.5.id': 'y',
      'cmi.mode': 'review',
      'cmi.location': 7,
    };
    const record = open(kept as unknown as KeptRecord);
    expect(record.kept).to.deep.equal({ 'cmi.interactions.0.id': 'x' });
    expect(record.GetValue('cmi.mode')).to.equal('');
  });
});
