// The editor of boxes and Gaussians: its edits, its history, and the histogram that it shows.
import { expect } from '@esm-bundle/chai';
import { boxBetween, moveGrip, newPatch, placeOfGrip, withNumber } from '../../../src/editor/patch-edits.ts';
import type { PlaneRange } from '../../../src/editor/patch-edits.ts';
import { chooseSteepest, countJointly } from '../../../src/editor/joint-histogram.ts';
import type { PlaneSamples } from '../../../src/editor/joint-histogram.ts';
import { PatchEditor } from '../../../src/editor/patch-editor.ts';
import { EditSession } from '../../../src/editor/transfer-function-session.ts';
import type { Appearance, EditedView } from '../../../src/editor/transfer-function-session.ts';
import { parsePatches } from '../../../src/optics/transfer/parse-patches.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import type { Patch } from '../../../src/optics/transfer/patches.ts';
import { writePatches } from '../../../src/optics/transfer/write-patches.ts';
import { collectSamples, samplePlane } from '../../../src/viewer/tools/sample-plane.ts';
import { cloudVolume } from '../../helpers/polar-cloud.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const box: Patch = { kind: 'box', values: [40, 120], gradients: [5, 30], color: [1, 0.4, 0], opacity: 0.6 };
const bell: Patch = { kind: 'gaussian', value: 200, gradient: 20, widths: [15, 8], color: [0, 0, 1], opacity: 0.25 };
const range: PlaneRange = { domain: [0, 1000], steepest: 100 };
const units = { window: [0, 1] as const, steepest: 1 };

describe('edits of boxes and Gaussians', () => {
  it('are written as they are read', () => {
    expect(writePatches([box, bell])).to.equal('box 40 120 5 30 #ff6600 60%, gaussian 200 20 15 8 #0000ff 25%');
    expect(parsePatches(writePatches([box, bell]), units)).to.deep.equal([box, bell]);
  });

  it('move all of one by its middle, not below no gradient, and within the chart', () => {
    expect(placeOfGrip(box, 'middle')).to.deep.equal([80, 17.5]);
    expect(moveGrip(box, 'middle', [500, 50], range)).to.deep.include({ values: [460, 540], gradients: [37.5, 62.5] });
    expect(moveGrip(box, 'middle', [500, -50], range)).to.deep.include({ gradients: [0, 25] });
    expect(moveGrip(bell, 'middle', [2000, 300], range)).to.deep.include({
      value: 1000,
      gradient: 100,
      widths: [15, 8],
    });
  });

  it('change the size by the corner: a box keeps its low one, a Gaussian its middle; neither vanishes', () => {
    expect(moveGrip(box, 'size', [300, 60], range)).to.deep.include({ values: [40, 300], gradients: [5, 60] });
    expect(moveGrip(box, 'size', [0, 0], range)).to.deep.include({ values: [40, 44], gradients: [5, 5.4] });
    expect(moveGrip(bell, 'size', [260, 60], range)).to.deep.include({ value: 200, gradient: 20, widths: [30, 20] });
    expect(moveGrip(bell, 'size', [0, 0], range)).to.deep.include({ widths: [4, 0.4] });
    expect(boxBetween([300, 60], [100, 20], box, range)).to.deep.equal({
      ...box,
      values: [100, 300],
      gradients: [20, 60],
    });
  });

  it('take numbers that make one, and leave it else', () => {
    expect(withNumber(box, 1, 90)).to.deep.include({ values: [40, 90] });
    for (const [which, number] of [
      [1, 40],
      [2, -1],
      [3, 5],
    ])
      expect(withNumber(box, which, number)).to.equal(box);
    expect(withNumber(bell, 3, 9)).to.deep.include({ widths: [15, 9] });
    for (const [which, number] of [
      [1, -1],
      [2, 0],
      [3, -2],
    ])
      expect(withNumber(bell, which, number)).to.equal(bell);
  });

  it('are written with enough digits to distinguish a narrow one from none', () => {
    const narrow: Patch[] = [
      { ...box, values: [101325.2, 101325.4], gradients: [5000.001, 5000.002] },
      { ...bell, value: 2000000.25, widths: [0.125, 8] },
    ];
    expect(parsePatches(writePatches(narrow), units).map((patch) => ({ ...patch, color: 0 }))).to.deep.equal(
      narrow.map((patch) => ({ ...patch, color: 0 })),
    );
    expect(withNumber(box, 1, 1e305), 'more than the attribute takes').to.equal(box);
  });

  it('begin with what can be read again', () => {
    for (const kind of ['box', 'gaussian'] as const)
      expect(parsePatches(writePatches([newPatch(kind, 3, range)]), units)).to.have.length(1);
  });
});

/** A <volume-view> that does what it is told. */
function viewOf(transferFunction2d: string | null): EditedView & { appearance: Appearance } {
  return {
    appearance: { transferFunction: null, transferFunction2d, opacityFactor: null, lightFactor: null },
    get optics() {
      const text = this.appearance.transferFunction2d ?? '';
      return {
        transferFunction: [
          { value: 0, color: [0, 0, 0] as const, opacity: 0 },
          { value: 1, color: [1, 1, 1] as const, opacity: 1 },
        ],
        patches: parsePatches(text, units),
        opacityFactor: 1,
        lightFactor: 1,
      };
    },
  };
}

describe('a session of edits by value and gradient', () => {
  const open = (
    text: string | null,
  ): { view: ReturnType<typeof viewOf>; session: EditSession; editor: PatchEditor; focused: unknown[] } => {
    const [view, focused] = [viewOf(text), [] as unknown[]];
    const session = new EditSession(() => session.follow(view));
    session.follow(view);
    const editor = new PatchEditor(session, { changed: () => {}, focus: (taken) => focused.push(taken) });
    editor.span([0, 1000], null);
    return { view, session, editor, focused };
  };

  it('adds, changes, removes, and undoes and copies that; without any the attribute is gone', () => {
    const { view, session, editor, focused } = open(writePatches([box]));
    editor.add('gaussian');
    expect(focused).to.deep.equal([{ index: 1, grip: 'middle' }]);
    editor.changeAppearance(1, { color: '#00ff00', opacity: 7 });
    session.commit();
    expect(editor.patches[1]).to.deep.include({ color: [0, 1, 0], opacity: 1 });
    expect(session.writeAttributes()).to.equal(`transfer-function-2d="${writePatches(editor.patches)}"`);
    editor.remove(0);
    editor.remove(0);
    expect(view.appearance).to.deep.equal({
      transferFunction: null,
      transferFunction2d: null,
      opacityFactor: null,
      lightFactor: null,
    });
    for (let i = 0; i < 4; i++) session.undo();
    expect(view.appearance.transferFunction2d).to.equal(writePatches([box]));
    expect(session.canUndo).to.equal(false);
    session.redo();
    expect(editor.patches.map(({ kind }) => kind)).to.deep.equal(['box', 'gaussian']);
  });

  it('has keys at its grips, and no more than eight parts', () => {
    const { session, editor } = open(writePatches([box]));
    const press = (key: string, index = 0, shiftKey = false): boolean =>
      editor.press(new KeyboardEvent('keydown', { key, shiftKey }), { index, grip: 'middle' });
    press('ArrowRight');
    press('ArrowRight', 0, true);
    expect((editor.patches[0] as typeof box & { kind: 'box' }).values).to.deep.equal([150, 230]);
    expect(press('a')).to.equal(false);
    for (let i = 0; i < 9; i++) press('Insert');
    expect(editor.patches).to.have.length(8);
    press('Delete', 7);
    expect(editor.patches).to.have.length(7);
    session.follow(null);
    expect(editor.patches).to.have.length(0);
  });

  it('lets go of a part that is deleted while it is held, and leaves the focus where one can be added', () => {
    const { editor, focused } = open(writePatches([box, bell]));
    editor.remove(1);
    editor.input.listener.drag({ index: 1, grip: 'middle' }, { share: 0.5, height: 0.5 });
    editor.changeNumber(1, 0, 7);
    expect(editor.patches).to.deep.equal([box]);
    focused.length = 0;
    editor.remove(0);
    expect(focused).to.deep.equal([{ index: 0, grip: 'middle' }]);
  });

  it('spans the same while another scan is counted', () => {
    const { editor } = open(writePatches([{ ...box, gradients: [5, 3000] }]));
    const samples = { values: Float32Array.of(1, 2), gradients: Float32Array.of(100, 100) };
    editor.span([0, 1000], samples);
    const { steepest } = editor.range;
    expect(steepest).to.be.above(100);
    for (const next of [null, { ...samples }, null]) {
      editor.span([0, 1000], next);
      expect(editor.range.steepest).to.equal(steepest);
    }
  });

  it('keeps the stops that wait next to it, and so the chart stays', () => {
    const { view, session, editor } = open(null);
    const before = session.look!.stops;
    editor.add('box');
    Object.defineProperty(view, 'optics', {
      value: { ...view.optics, transferFunction: [{ value: 7, color: [1, 1, 1], opacity: 1 }] },
    });
    session.follow(view);
    expect(session.look!.stops).to.deep.equal(before);
  });

  it('takes over what the page says again', () => {
    const { view, session, editor } = open(writePatches([box]));
    view.appearance = { ...view.appearance, transferFunction2d: writePatches([bell]) };
    session.follow(view);
    expect(editor.patches).to.deep.equal([bell]);
    expect(session.canUndo).to.equal(false);
  });
});

describe('a histogram of values and gradients', () => {
  const run = (volume: Parameters<typeof samplePlane>[0], max: number): PlaneSamples => {
    const work = samplePlane(volume, max);
    for (;;) {
      const step = work.next();
      if (step.done) return step.value!;
    }
  };

  it('has the gradient of a linear field, per world unit', () => {
    const volume = syntheticVolume({
      dimensions: [20, 20, 20],
      kind: 'float32',
      spacing: [2, 2, 2],
      field: (x, y) => 30 * x + 40 * y,
    });
    const samples = run(volume, 2000);
    expect(samples.values.length).to.equal(2000);
    const inside = samples.gradients.filter((g) => Math.abs(g - 50 / 40) < 1e-4).length;
    expect(inside / 2000, 'all but those at the bounds').to.be.above(0.6);
    expect(chooseSteepest(samples)).to.be.closeTo(1.2 * 1.25, 1e-3);
    const counts = countJointly(samples, { domain: [0, 70], steepest: 2.5 }, [7, 5]);
    expect(counts.reduce((sum, count) => sum + count, 0)).to.be.within(1990, 2000);
    expect(Math.max(...counts.slice(14, 21))).to.equal(Math.max(...counts));
  });

  it('is of radars too, of places with data; labels have none; what is not wanted any more ends', async () => {
    const samples = run(cloudVolume(1), 500);
    expect(samples.values.length).to.be.above(100);
    expect(Math.max(...samples.gradients)).to.be.within(1e-5, 3e-4);
    const volume = syntheticVolume({ dimensions: [8, 8, 8], kind: 'uint16' });
    expect(samplePlane({ ...volume, isDiscrete: true }).next()).to.deep.equal({ done: true, value: null });
    const control = new AbortController();
    control.abort();
    expect(await collectSamples(volume, control.signal)).to.equal(null);
  });
});

describe('the first edit of a scan that the view has lit by itself', () => {
  const stops = parseTransferFunction('0 black 0, 1 white 50%', [0, 1]);
  const begin = (given: Partial<Appearance> = {}): { session: EditSession; view: EditedView } => {
    const none: Appearance = { transferFunction: null, opacityFactor: null, lightFactor: null, shading: null };
    const optics = { transferFunction: stops, opacityFactor: 6, lightFactor: 1, shading: 'lit' };
    const view: EditedView = { appearance: { ...none, ...given }, optics };
    const session = new EditSession(() => {});
    session.follow(view);
    return { session, view };
  };

  it('writes light and density too, because stops of the page take them away', () => {
    const { session, view } = begin();
    session.setStops(parseTransferFunction('0 black 0, 1 red 50%', [0, 1]));
    session.commit();
    expect(view.appearance).to.include({ opacityFactor: 6, shading: 'lit' });
    expect(session.writeAttributes()).to.contain('opacity-factor="6"').and.to.contain('shading="lit"');
    session.undo();
    expect(view.appearance, 'what the page said').to.include({ opacityFactor: null, shading: null });
  });

  it('can be copied before the first edit', () => {
    expect(begin().session.writeAttributes()).to.contain('opacity-factor="6"').and.to.contain('shading="lit"');
  });

  it('writes nothing that the page says itself', () => {
    const { session, view } = begin({ opacityFactor: 6, shading: 'lit' });
    session.setFactor('lightFactor', 2);
    session.commit();
    expect(view.appearance).to.deep.equal({
      transferFunction: null,
      opacityFactor: 6,
      lightFactor: 2,
      shading: 'lit',
    });
  });
});
