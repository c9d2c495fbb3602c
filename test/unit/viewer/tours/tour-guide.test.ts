import { expect } from '@esm-bundle/chai';
import { socketOf } from '../../../../src/viewer/model/view-socket.ts';
import type { SocketView } from '../../../../src/viewer/model/view-socket.ts';
import { readStep } from '../../../../src/viewer/tours/step-value.ts';
import type { Setting, StepValue } from '../../../../src/viewer/tours/step-value.ts';
import { TourGuide } from '../../../../src/viewer/tours/tour-guide.ts';

/** An element without a page: its attributes, and all that was written. */
class Tag {
  readonly written: string[] = [];

  constructor(readonly attributes: Map<string, string>) {}

  getAttribute(name: string): string | null {
    return this.attributes.get(name) ?? null;
  }

  setAttribute(name: string, text: string): void {
    this.written.push(`${name}=${text}`);
    this.attributes.set(name, text);
  }

  removeAttribute(name: string): void {
    this.written.push(`no ${name}`);
    this.attributes.delete(name);
  }
}

const replaced = ['requestAnimationFrame', 'cancelAnimationFrame', 'matchMedia', 'performance'] as const;

/** Numbers 0 to 1, the same in each run. */
function makeRandom(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

describe('the guide of a tour', () => {
  const originals = replaced.map((name) => Object.getOwnPropertyDescriptor(globalThis, name));
  let now = 0;
  let frames = new Map<number, () => void>();
  let wantsLessMotion = false;

  beforeEach(() => {
    [now, frames, wantsLessMotion] = [0, new Map(), false];
    let count = 0;
    const stand: Record<(typeof replaced)[number], unknown> = {
      requestAnimationFrame: (act: () => void) => {
        frames.set(++count, act);
        return count;
      },
      cancelAnimationFrame: (id: number) => frames.delete(id),
      matchMedia: () => ({ matches: wantsLessMotion }),
      performance: { now: () => now },
    };
    for (const name of replaced)
      Object.defineProperty(globalThis, name, { value: stand[name], configurable: true, writable: true });
  });

  afterEach(() => {
    replaced.forEach((name, i) => {
      const original = originals[i];
      if (original) Object.defineProperty(globalThis, name, original);
      else Reflect.deleteProperty(globalThis, name);
    });
  });

  /** Let time pass, and draw a frame. */
  function pass(ms: number): void {
    now += ms;
    const due = [...frames.values()];
    frames.clear();
    for (const act of due) act();
  }

  function start(attributes: Record<string, string>, hasPicture = true) {
    const tag = new Tag(new Map(Object.entries(attributes)));
    const element = tag as unknown as HTMLElement;
    if (hasPicture) socketOf(element).view = { viewer: { scene: {} } } as unknown as SocketView;
    const stepOf = (texts: Record<string, string>): StepValue<Element> => ({
      problem: null,
      settings: Object.entries(texts).map(([name, text]): Setting<Element> => ({ target: element, name, text })),
    });
    return { tag, guide: new TourGuide(element), stepOf };
  }

  it('writes the place of the camera again, though its text is the same, and no other attribute', () => {
    const { tag, guide, stepOf } = start({ 'camera-orbit': '1deg 2deg 3', region: '0 0 0 1 1 1' });
    const steps = [
      stepOf({ 'camera-orbit': '1deg 2deg 3', region: '0 0 0 1 1 1' }),
      stepOf({ 'camera-target': '0 0 0' }),
    ];
    guide.open(steps[0], steps, 600);
    // An absent place is written too: a person may have moved the camera.
    expect(tag.written).to.deep.equal(['camera-orbit=1deg 2deg 3', 'camera-target=', 'no camera-target']);
  });

  it('mixes colours on the way, and ends with the text of the step', () => {
    const { tag, guide, stepOf } = start({ 'transfer-function': '0 #000000 0, 1 #000000 100%' });
    const step = stepOf({ 'transfer-function': '0 #ffffff 0, 1 #fff 0' });
    guide.open(step, [step], 600);
    pass(150);
    expect(tag.getAttribute('transfer-function')).to.equal('0 #404040 0%, 1 #404040 75%');
    pass(300);
    expect(tag.getAttribute('transfer-function')).to.equal('0 #bfbfbf 0%, 1 #bfbfbf 25%');
    pass(150);
    expect(tag.getAttribute('transfer-function')).to.equal('0 #ffffff 0, 1 #fff 0');
    expect(frames.size).to.equal(0);
  });

  it('changes any other look in the middle of the way, all of it at once', () => {
    const { tag, guide, stepOf } = start({ 'transfer-function': 'bone', alt: 'Before' });
    const step = stepOf({ 'transfer-function': '0 red 0, 1 red 1', 'opacity-factor': '2', alt: 'After' });
    guide.open(step, [step], 600);
    expect(tag.written).to.deep.equal(['alt=After']);
    pass(290);
    expect(tag.written).to.have.length(1);
    pass(10);
    expect(tag.written.slice(1)).to.deep.equal(['transfer-function=0 red 0, 1 red 1', 'opacity-factor=2']);
    expect(frames.size).to.equal(0);
  });

  it('jumps without a duration, without a picture, and where a person wants less motion', () => {
    const cases: readonly (() => number)[] = [
      () => 0,
      () => -1,
      () => {
        wantsLessMotion = true;
        return 600;
      },
    ];
    for (const [i, prepare] of [...cases, () => 600].entries()) {
      wantsLessMotion = false;
      const { tag, guide, stepOf } = start({}, i < cases.length);
      const step = stepOf({ 'transfer-function': 'bone' });
      guide.open(step, [step], prepare());
      expect(tag.getAttribute('transfer-function'), `${i}`).to.equal('bone');
      expect(frames.size).to.equal(0);
    }
  });

  it('goes from the middle of a move to another step, and leaves from there, with nothing left', () => {
    const before = { 'transfer-function': '0 #000000 0, 1 #000000 100%' };
    const { tag, guide, stepOf } = start(before);
    const steps = [stepOf({ 'transfer-function': '0 #ffffff 0, 1 #ffffff 0' }), stepOf({ 'light-factor': '2' })];
    guide.open(steps[0], steps, 600);
    pass(300);
    guide.open(steps[1], steps, 600);
    pass(400);
    expect(Object.fromEntries(tag.attributes)).to.deep.equal({ ...before, 'light-factor': '2' });
    guide.open(steps[0], steps, 600);
    pass(100);
    guide.leave();
    pass(1000);
    expect(Object.fromEntries(tag.attributes)).to.deep.equal(before);
    expect(frames.size).to.equal(0);
  });

  it('ends forwards, backwards and after 200 random jumps, some in the middle of a move, where fresh tags with the attributes of the step are', () => {
    /** A storm of labels, slices, surfaces, cuts and scans: each step sets something else. */
    const lesson: readonly Record<string, string>[] = [
      {},
      { 'camera-orbit': '90deg 80deg auto', 'transfer-function': '0 #ffffff 0, 1 #ffffff 0', notes: 'a' },
      { 'surface-values': '300', 'transfer-function': 'bone', slice: 'axial 20', labels: 'none' },
      { time: '2', region: '0 0 0 1 1 1', notes: '' },
      { cutout: '0 0 0 9 9 9', labels: '3 7 ghost', 'opacity-factor': '2' },
      { labels: '7', slice: 'none', notes: 'b a', 'field-of-view': '20deg' },
      { labels: 'all', slice: 'sagittal', time: '1', 'surface-values': '100 300', look: 'glass' },
    ];
    const makePage = () => {
      const begun = start({ 'transfer-function': '0 #000000 0, 1 #000000 100%', time: '0', alt: 'A head' });
      const [slice, labels, a, b] = [{ type: 'coronal', hidden: '' }, { hidden: '' }, { open: '' }, {}].map(
        (attributes) => new Tag(new Map(Object.entries(attributes))),
      );
      const elementOf = (one: Tag): Element => one as unknown as Element;
      const targets = {
        view: elementOf(begun.tag),
        slice: elementOf(slice),
        labels: elementOf(labels),
        notes: [
          { id: 'a', target: elementOf(a) },
          { id: 'b', target: elementOf(b) },
        ],
      };
      const steps = lesson.map((step) =>
        readStep(
          Object.entries(step).map(([name, value]) => ({ name, value })),
          targets,
        ),
      );
      const tags = [begun.tag, slice, labels, a, b];
      return {
        guide: begun.guide,
        steps,
        tags,
        state: () => tags.map(({ attributes }) => Object.fromEntries(attributes)),
      };
    };
    const { guide, steps, tags, state } = makePage();
    expect(steps.map(({ problem }) => problem)).to.deep.equal(lesson.map(() => null));
    const before = state();
    const freshState = lesson.map((_, i) => {
      const fresh = makePage();
      for (const { target, name, text } of fresh.steps[i].settings) {
        const one = target as unknown as Tag;
        if (text === null) one.removeAttribute(name);
        else one.setAttribute(name, text);
      }
      return fresh.state();
    });
    const random = makeRandom(41);
    const order = [
      ...lesson.keys(),
      ...lesson.map((_, i) => lesson.length - 1 - i),
      ...Array.from({ length: 200 }, () => Math.floor(random() * lesson.length)),
    ];
    let interrupted = 0;
    for (const [jump, i] of order.entries()) {
      // A script or a person changes something on the way: the label list, a note.
      if (random() < 0.2) tags[3].setAttribute('open', '');
      guide.open(steps[i], steps, 600);
      if (random() < 0.4) {
        pass(random() * 590); // The next jump comes before this move ends.
        if (frames.size > 0) interrupted++;
        if (jump < order.length - 1) continue;
      }
      pass(300);
      pass(300);
      expect(state(), `${jump}: step ${i}`).to.deep.equal(freshState[i]);
      expect(frames.size).to.equal(0);
    }
    expect(interrupted).to.be.above(20);
    guide.leave();
    expect(state()).to.deep.equal(before);
  });

  it('writes the labels that are shown again, as a person may have chosen others', () => {
    const { guide, stepOf } = start({});
    const labels = new Tag(new Map());
    const step = (text: string | null): StepValue<Element> => ({
      problem: null,
      settings: [{ target: labels as unknown as Element, name: 'only', text }],
    });
    const steps = [step('3'), step('3'), stepOf({})];
    for (const one of steps) guide.open(one, steps, 0);
    expect(labels.written).to.deep.equal(['only=3', 'only=3', 'only=', 'no only']);
  });
});
