import { expect } from '@esm-bundle/chai';
import { notInSteps, stepAttributes } from '../../../../src/viewer/tours/step-attributes.ts';
import { readStep } from '../../../../src/viewer/tours/step-value.ts';
import type { Setting, StepTargets } from '../../../../src/viewer/tours/step-value.ts';
import { TourState } from '../../../../src/viewer/tours/tour-state.ts';

/** An element: its attributes, by name. */
type Tag = Map<string, string>;

const tag = (attributes: Record<string, string> = {}): Tag => new Map(Object.entries(attributes));
const listOf = (attributes: Record<string, string>): { name: string; value: string }[] =>
  Object.entries(attributes).map(([name, value]) => ({ name, value }));

/** A page with a view, a slice and three notes. */
function makePage(): { targets: StepTargets<Tag>; tags: Tag[] } {
  const view = tag({ src: 'a.nii', 'camera-orbit': '10deg 80deg 90%', time: '2', alt: 'A head' });
  const slice = tag({ type: 'coronal', hidden: '' });
  const labels = tag({ src: 'atlas.nii', hidden: '' });
  const notes = [tag({ id: 'a', open: '' }), tag({ id: 'b' }), tag({})];
  return {
    targets: { view, slice, labels, notes: notes.map((target) => ({ id: target.get('id') ?? '', target })) },
    tags: [view, slice, labels, ...notes],
  };
}

function write(settings: readonly Setting<Tag>[]): void {
  for (const { target, name, text } of settings) {
    if (text === null) target.delete(name);
    else target.set(name, text);
  }
}

const textsOf = (tags: readonly Tag[]): unknown => tags.map((one) => Object.fromEntries(one));

/** A step sets some of these. */
const possible: readonly (readonly [name: string, texts: readonly string[]])[] = [
  ['camera-orbit', ['0deg 90deg auto', '-40deg 60deg 80%']],
  ['transfer-function', ['bone', '0 #000 0, 1 #fff 50%']],
  ['region', ['0 0 0 1 1 1']],
  ['auto-rotate', ['']],
  ['time', ['0', '1']],
  ['alt', ['', 'From above']],
  ['notes', ['', 'a', 'b a']],
  ['slice', ['axial 20', 'sagittal', 'none']],
  ['labels', ['3 4 ghost', 'all', 'none']],
];

/** Numbers 0 to 1, the same in each run. */
function makeRandom(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

describe('the state of a tour', () => {
  it('is, in any order of steps, what a fresh page with the attributes of the step has', () => {
    const random = makeRandom(37);
    const choose = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)];
    let compared = 0;
    for (let order = 0; order < 200; order++) {
      const steps = Array.from({ length: 7 }, () =>
        Object.fromEntries(possible.filter(() => random() < 0.4).map(([name, texts]) => [name, choose(texts)])),
      );
      const { targets, tags } = makePage();
      const original = textsOf(tags);
      const state = new TourState<Tag>((target, name) => target.get(name) ?? null);
      const read = () => steps.map((step) => readStep(listOf(step), targets));
      for (let moves = 1 + Math.floor(random() * 9); moves > 0; moves--) {
        const i = Math.floor(random() * steps.length);
        const values = read();
        for (const { settings, problem } of values) {
          expect(problem).to.equal(null);
          state.remember(settings);
        }
        write(state.textsIn(values[i].settings));
        const fresh = makePage();
        write(readStep(listOf(steps[i]), fresh.targets).settings);
        expect(textsOf(tags), JSON.stringify(steps[i])).to.deep.equal(textsOf(fresh.tags));
        compared++;
      }
      write(state.textsIn());
      expect(textsOf(tags), 'after the tour').to.deep.equal(original);
    }
    expect(compared).to.be.above(500);
  });

  it('keeps what was before the tour where a note comes later, and where a step gets more attributes', () => {
    const { targets, tags } = makePage();
    const state = new TourState<Tag>((target, name) => target.get(name) ?? null);
    const first = readStep(listOf({ notes: 'b' }), targets);
    state.remember(first.settings);
    write(state.textsIn(first.settings));
    const late = tag({ id: 'c', open: '' });
    const more = { ...targets, notes: [...targets.notes, { id: 'c', target: late }] };
    const second = readStep(listOf({ notes: 'b', rings: '20' }), more);
    state.remember(second.settings);
    write(state.textsIn(second.settings));
    expect([late.has('open'), targets.view.get('rings')]).to.deep.equal([false, '20']);
    write(state.textsIn());
    expect(late.get('open')).to.equal('');
    expect(textsOf(tags)).to.deep.equal(textsOf(makePage().tags));
  });
});

describe('a step of a tour', () => {
  const { targets } = makePage();
  const problemOf = (attributes: Record<string, string>): string | undefined =>
    readStep(listOf(attributes), targets).problem?.message;

  it('copies the texts of attributes, of any length, and leaves them to the element that reads them', () => {
    const long = 'x'.repeat(2 ** 20);
    const { settings, problem } = readStep(listOf({ 'camera-orbit': 'nonsense', 'transfer-function': long }), targets);
    expect(problem).to.equal(null);
    expect(settings).to.deep.equal([
      { target: targets.view, name: 'camera-orbit', text: 'nonsense' },
      { target: targets.view, name: 'transfer-function', text: long },
    ]);
  });

  it('never sets what is not for steps, and says so', () => {
    for (const name of notInSteps) {
      const { settings, problem } = readStep(listOf({ [name]: 'x' }), targets);
      expect(settings, name).to.deep.equal([]);
      expect(problem?.message, name).to.match(
        name === 'poster'
          ? /got the attribute poster; expected a picture between its tags, <img slot="poster"/
          : /^<volume-step> got the attribute .*; it belongs on/,
      );
      expect(problem?.code).to.equal('attribute/invalid');
    }
    expect(stepAttributes).to.not.include('src');
    expect(stepAttributes.filter((name) => notInSteps.includes(name))).to.deep.equal([]);
  });

  it('sets nothing by names of strangers', () => {
    for (const name of ['__proto__', 'constructor', 'onclick', 'onload', 'style', 'srcdoc', 'xlink:href', 'id'])
      expect(readStep([{ name, value: 'alert(1)' }], targets).settings, name).to.deep.equal([]);
  });

  it('says which attribute it does not know, and leaves those of HTML and of libraries alone', () => {
    expect(problemOf({ 'camera-orbitt': '0deg' })).to.equal(
      '<volume-step> got the attribute camera-orbitt; expected an attribute of <volume-view>, or labels, notes, slice, label.',
    );
    for (const name of ['id', 'class', 'lang', 'hidden', 'data-x', 'aria-label', 'label', 'v-cloak', '_ngcontent-abc'])
      expect(problemOf({ [name]: 'x' }), name).to.equal(undefined);
  });

  it('goes on with its other attributes where one can not be read', () => {
    const { settings, problem } = readStep(listOf({ notes: 'zz', region: '0 0 0 1 1 1' }), targets);
    expect(problem?.message).to.equal(
      'notes of <volume-step> got "zz"; expected the id of a <volume-note> of the same view.',
    );
    expect(settings.map(({ name }) => name)).to.deep.equal(['region']);
  });

  it('moves the first slice, and says what is missing', () => {
    expect(readStep(listOf({ slice: ' axial  -20.5 ' }), targets).settings).to.deep.equal([
      { target: targets.slice, name: 'hidden', text: null },
      { target: targets.slice, name: 'type', text: 'axial' },
      { target: targets.slice, name: 'at', text: '-20.5' },
    ]);
    expect(readStep(listOf({ slice: 'none' }), targets).settings).to.deep.equal([
      { target: targets.slice, name: 'hidden', text: '' },
    ]);
    expect(problemOf({ slice: '' })).to.match(/expected a type and a position, like "axial 20", or none/);
    expect(problemOf({ slice: 'axial 2 3' })).to.match(/got "axial 2 3"; expected a type and a position/);
    expect(readStep(listOf({ slice: 'axial 2' }), { ...targets, slice: null }).problem?.message).to.match(
      /expected a <volume-slice> in the <volume-view>/,
    );
  });

  it('shows some labels, all, or none of them', () => {
    const settingsOf = (labels: string): unknown =>
      readStep(listOf({ labels }), targets).settings.map(({ target, name, text }) => [
        target === targets.labels,
        name,
        text,
      ]);
    expect(settingsOf('3 4 ghost')).to.deep.equal([
      [true, 'hidden', null],
      [true, 'only', '3 4 ghost'],
    ]);
    expect(settingsOf('all')).to.deep.equal([
      [true, 'hidden', null],
      [true, 'only', null],
    ]);
    expect(settingsOf(' None ')).to.deep.equal([
      [true, 'hidden', ''],
      [true, 'only', null],
    ]);
    expect(readStep(listOf({ labels: '3' }), { ...targets, labels: null }).problem?.message).to.equal(
      'labels of <volume-step> got "3"; expected a <volume-labels> in the <volume-view>.',
    );
  });
});
