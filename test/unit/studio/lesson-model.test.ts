// The lesson of the studio: edits, undo and redo, and the way to HTML and back.
import { expect } from '@esm-bundle/chai';
import { boxAround, readRegion, writeRegion } from '../../../packages/studio/src/model/box.ts';
import type { Box } from '../../../packages/studio/src/model/box.ts';
import { findLacks } from '../../../packages/studio/src/model/check-lesson.ts';
import * as edit from '../../../packages/studio/src/model/edit.ts';
import { change, redo, replace, startHistory, undo } from '../../../packages/studio/src/model/history.ts';
import { emptyLesson } from '../../../packages/studio/src/model/lesson.ts';
import type { Lesson, Question, QuestionType, ViewAttributes } from '../../../packages/studio/src/model/lesson.ts';
import { changesFor, hasLook, looksFor } from '../../../packages/studio/src/model/looks.ts';
import { readLessonHtml } from '../../../packages/studio/src/model/read-lesson.ts';
import { baseView, writeLessonHtml } from '../../../packages/studio/src/model/write-lesson.ts';
import { readLesson, writePageFiles } from '../../../packages/lesson-writers/src/index.ts';
import { named, wholeLesson } from '../../helpers/studio-lesson.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

const withSteps = (...views: ViewAttributes[]): Lesson =>
  views.reduce((lesson, view) => edit.addStep({ ...lesson, view }, null), named);

const idsOf = ({ steps }: Lesson): string[] => steps.map(({ id }) => id);

describe('edits of a lesson', () => {
  it('a step keeps the view, after the step that is open or at the end', () => {
    let lesson = withSteps({ look: 'xray' }, { look: 'mip' });
    lesson = edit.addStep({ ...lesson, view: { region: '0 0 0 1 1 1' } }, 'step-1');
    expect(idsOf(lesson)).to.deep.equal(['step-1', 'step-3', 'step-2']);
    expect(lesson.steps[1].view).to.deep.equal({ region: '0 0 0 1 1 1' });
    // A later change of the picture is none of the step.
    expect(edit.changeView(lesson, { region: null }).steps[1].view).to.deep.equal({ region: '0 0 0 1 1 1' });
  });

  it('steps move to both ends and no farther, and nothing moves where nothing can', () => {
    const lesson = withSteps({}, {}, {});
    expect(idsOf(edit.moveStep(lesson, 'step-3', -1))).to.deep.equal(['step-1', 'step-3', 'step-2']);
    expect(idsOf(edit.moveStep(lesson, 'step-1', 9))).to.deep.equal(['step-2', 'step-3', 'step-1']);
    expect(edit.moveStep(lesson, 'step-1', -1).steps).to.equal(lesson.steps);
    expect(edit.moveStep(lesson, 'step-9', 1).steps).to.equal(lesson.steps);
  });

  it('a deleted note is open in no step any more', () => {
    let lesson = edit.addNote(edit.addNote(named, '1 2 3'), '4 5 6');
    lesson = edit.addStep(lesson, null, ['note-1', 'note-2', 'note-9']);
    expect(lesson.steps[0].notes).to.deep.equal(['note-1', 'note-2']);
    lesson = edit.removeNote(lesson, 'note-1');
    expect(lesson.steps[0].notes).to.deep.equal(['note-2']);
    expect(edit.freeId('note', lesson)).to.equal('note-1');
  });

  it('edits leave the lesson that they were given as it was', () => {
    const lesson = edit.addQuestion(withSteps({}), 'step-1', 'choice');
    const before = JSON.stringify(lesson);
    edit.changeQuestion(lesson, 'question-1', { title: 'x' });
    edit.removeQuestion(lesson, 'question-1');
    edit.changeStep(lesson, 'step-1', { title: 'x' });
    edit.removeStep(lesson, 'step-1');
    expect(JSON.stringify(lesson)).to.equal(before);
  });
});

describe('undo and redo', () => {
  it('goes back and forth, and a new change ends what was undone', () => {
    let history = startHistory(0);
    for (const next of [1, 2, 3]) history = change(history, next, null);
    history = undo(undo(history)!)!;
    expect([history.present, history.past, history.future]).to.deep.equal([1, [0], [2, 3]]);
    expect(redo(history)!.present).to.equal(2);
    expect(change(history, 9, null).future).to.deep.equal([]);
    expect(undo(startHistory(0))).to.equal(null);
    expect(redo(startHistory(0))).to.equal(null);
  });

  it('typing in one field is one step, until something else is changed or undone', () => {
    let history = startHistory('');
    for (const text of ['a', 'ab', 'abc']) history = change(history, text, 'title');
    history = change(history, 'x', 'text');
    expect(history.past).to.deep.equal(['', 'abc']);
    history = change(undo(history)!, 'abcd', 'title');
    expect(history.past).to.deep.equal(['', 'abc']);
    expect(replace(history, 'shown').past).to.deep.equal(['', 'abc']);
  });

  it('2,000 random edits are all taken back, as far as 200 reach, and made again', () => {
    const next = randomNumbers(5);
    const below = (n: number): number => Math.floor(next() * n);
    let history = startHistory<Lesson>(named);
    const all: Lesson[] = [named];
    for (let i = 0; i < 2000; i++) {
      const lesson = history.present;
      const step = lesson.steps[below(Math.max(1, lesson.steps.length))]?.id ?? '';
      const ways = [
        () => edit.addStep(lesson, step),
        () => edit.moveStep(lesson, step, below(5) - 2),
        () => edit.removeStep(lesson, step),
        () => edit.addNote(lesson, `${below(9)} 0 0`),
        () => edit.removeNote(lesson, lesson.notes[0]?.id ?? ''),
        () => edit.addQuestion(lesson, step, 'find'),
        () => edit.changeView(lesson, { look: below(2) ? 'mip' : null }),
      ];
      history = change(history, ways[below(ways.length)](), null);
      all.push(history.present);
      const ids = history.present.steps.flatMap(({ id, questions }) => [id, ...questions.map((one) => one.id)]);
      expect(new Set(ids).size).to.equal(ids.length);
    }
    for (let back = 0; back < 200; back++) history = undo(history)!;
    expect(undo(history)).to.equal(null);
    expect(history.present).to.equal(all[all.length - 201]);
    for (let forth = 0; forth < 200; forth++) history = redo(history)!;
    expect(history.present).to.equal(all.at(-1));
  });
});

describe('the HTML of a lesson', () => {
  it('the view has what all steps have, and each step the rest: so each step shows what it kept', () => {
    const lesson = withSteps(
      { look: 'xray', region: '0 0 0 1 1 1' },
      { look: 'xray' },
      { look: 'xray', shading: 'lit' },
    );
    const base = baseView(lesson);
    expect(base).to.deep.equal({ look: 'xray' });
    const html = writeLessonHtml(lesson, 'volume.json');
    expect(html).to.include('<volume-view id="volume" src="volume.json" alt="A head, MRI" look="xray" controls');
    expect(html).to.include('<volume-step region="0 0 0 1 1 1">');
    expect(html).to.include('<volume-step>');
    expect(html).to.include('<volume-step shading="lit">');
  });

  it('a slice that one step shows is hidden in the others', () => {
    const html = writeLessonHtml(withSteps({ slice: 'axial 20' }, {}), 'volume.json');
    expect(html).to.include('<volume-slice hidden></volume-slice>');
    expect(html).to.include('<volume-step slice="axial 20">');
  });

  it('the writers take it, and all its texts are escaped', () => {
    const lesson = wholeLesson();
    const html = writeLessonHtml(lesson, 'volume.json');
    expect(readLesson(html).problems).to.deep.equal([]);
    expect(html).to.include('From &lt;outside&gt;').and.not.include('<outside>');
    const files = writePageFiles({ ...lesson, html, files: [{ path: 'volume.json', bytes: new Uint8Array() }] }, [
      { path: 'volume-view.iife.js', bytes: new Uint8Array() },
    ]);
    expect(files.map(({ path }) => path)).to.include('index.html');
  });

  it('it is read again as it was, from the HTML and from the page of the writers', () => {
    const lesson = wholeLesson();
    const html = writeLessonHtml(lesson, 'volume.json');
    const [page] = writePageFiles({ ...lesson, html, files: [{ path: 'volume.json', bytes: new Uint8Array() }] }, [
      { path: 'volume-view.iife.js', bytes: new Uint8Array() },
    ]).filter(({ path }) => path === 'index.html');
    const read = readLessonHtml(new TextDecoder().decode(page.bytes))!;
    expect(read.left).to.deep.equal([]);
    expect(read.src).to.equal('data/volume.json');
    expect({ ...read.lesson, data: lesson.data, view: lesson.view }).to.deep.equal(lesson);
    expect(writeLessonHtml({ ...read.lesson, data: lesson.data }, 'volume.json')).to.equal(html);
  });

  it('1,000 lessons of hostile texts are written and read again, without a tag of their own', () => {
    const next = randomNumbers(7);
    const pieces = [
      '<script>',
      '</volume-step>',
      '"',
      "' onclick='x",
      '&lt;',
      '<!--',
      ']]>',
      '\u2028',
      '😀',
      'a b',
      '\\',
      '<br>',
    ];
    const text = (): string =>
      Array.from({ length: 1 + Math.floor(next() * 4) }, () => pieces[Math.floor(next() * pieces.length)]).join('x');
    for (let i = 0; i < 1000; i++) {
      let lesson = edit.addStep({ ...named, title: text(), alt: text() }, null);
      lesson = edit.addNote(edit.changeStep(lesson, 'step-1', { title: text(), text: text() }), '1 2 3');
      lesson = edit.changeNote(lesson, 'note-1', { label: text(), text: text() });
      lesson = edit.addQuestion(lesson, 'step-1', 'choice');
      lesson = edit.changeQuestion(lesson, 'question-1', {
        title: text(),
        hint: text(),
        answers: [
          { text: text(), isCorrect: true },
          { text: text(), isCorrect: false },
        ],
      });
      const html = writeLessonHtml(lesson, 'volume.json');
      expect(readLesson(html).problems, html).to.deep.equal([]);
      const read = readLessonHtml(html)!;
      expect(read.lesson.steps[0].questions[0].answers.map((one) => one.isCorrect)).to.deep.equal([true, false]);
      expect(readLessonHtml(writeLessonHtml(read.lesson, 'volume.json'))).to.deep.equal(read);
    }
  });

  it('HTML without a view, or without its data, is no lesson; what the studio does not keep is named', () => {
    for (const html of ['', '<p>x</p>', '<volume-view></volume-view>', '\0\0', '<!--'])
      expect(readLessonHtml(html)).to.equal(null);
    const read = readLessonHtml(
      '<volume-view src="a.nii"><volume-labels src="b.nii"></volume-labels></volume-view><iframe></iframe>',
    )!;
    expect(read.left).to.have.members(['iframe', 'volume-labels']);
  });
});

describe('what is missing before an export', () => {
  it('nothing of a whole lesson', () => expect(findLacks(wholeLesson())).to.deep.equal([]));

  it('each lack is found, with its step', () => {
    const kinds = (lesson: Lesson): string[] => findLacks(lesson).map(({ kind }) => kind);
    expect(kinds(emptyLesson)).to.deep.equal(['data', 'title', 'credits', 'licence']);
    expect(kinds({ ...named, language: 'English, please' })).to.deep.equal(['language']);
    expect(kinds(edit.addNote(named, '1 2'))).to.deep.equal(['note-place']);
    const lesson = edit.changeStep(withSteps({}), 'step-1', { title: 'x' });
    const lacksOf = (type: QuestionType, fields: Partial<Question>): string[] =>
      kinds(edit.changeQuestion(edit.addQuestion(lesson, 'step-1', type), 'question-1', { title: 'x', ...fields }));
    expect(lacksOf('choice', {})).to.deep.equal(['question-answers']);
    expect(
      lacksOf('choice', {
        answers: [
          { text: 'a', isCorrect: false },
          { text: 'b', isCorrect: false },
        ],
      }),
    ).to.deep.equal(['question-correct']);
    expect(lacksOf('find', { radius: '0' })).to.deep.equal(['question-place', 'question-radius']);
    expect(lacksOf('label', {})).to.deep.equal(['question-place', 'question-answer']);
    expect(lacksOf('value', { answer: 'much' })).to.deep.equal(['question-number']);
    expect(lacksOf('value', { answer: '3', tolerance: '-1' })).to.deep.equal(['question-number']);
    expect(lacksOf('value', { answer: '3', tries: '0' })).to.deep.equal(['question-tries']);
  });
});

describe('looks and boxes', () => {
  it('a look takes the one before away, with its window and its light', () => {
    const [auto, textbook] = looksFor({ unit: '', range: [0, 255], isRadar: false });
    const lesson = edit.changeView(
      { ...named, view: { look: 'xray', shading: 'lit', 'value-window': '0 9', region: 'r' } },
      changesFor(textbook),
    );
    expect(lesson.view).to.deep.equal({ look: 'textbook', region: 'r' });
    expect([hasLook(lesson.view, textbook), hasLook(lesson.view, auto)]).to.deep.equal([true, false]);
  });

  it('CT has its presets, whether its file says so or its values do; radar has its own', () => {
    const namesOf = (unit: string, range: [number, number], isRadar = false): string[] =>
      looksFor({ unit, range, isRadar }).map(({ name }) => name);
    expect(namesOf('HU', [-1000, 2000])).to.include.members(['bone', 'ct-lung']);
    expect(namesOf('', [-1024, 3071]))
      .to.include('ct-lung')
      .and.not.include('diverging');
    expect(namesOf('', [0, 255])).to.not.include('bone');
    expect(namesOf('', [-5, 5])).to.include('diverging');
    expect(namesOf('dBZ', [-30, 60], true))
      .to.include('radar-dbz')
      .and.not.include('textbook');
  });

  it('the box of a volume reaches to the sides of its voxels, also where axes are swapped', () => {
    // Voxels of 2 x 3 x 4; i goes down along y, j along x, k along z.
    const box = boxAround([10, 5, 2], [0, 3, 0, 10, -2, 0, 0, 20, 0, 0, 4, 30, 0, 0, 0, 1]);
    expect(box).to.deep.equal([8.5, 1, 28, 23.5, 21, 36]);
    expect(readRegion(undefined, box)).to.equal(box);
    expect(readRegion('1 2 x', box)).to.equal(box);
    expect(writeRegion(box, box)).to.equal(null);
    const half = [10, 1, 28, 23.5, 21, 36] as Box;
    expect(readRegion(writeRegion(half, box)!, box)).to.deep.equal(half);
  });
});
