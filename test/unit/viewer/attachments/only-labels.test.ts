// Which labels an author shows, and what a person chooses after that.
import { expect } from '@esm-bundle/chai';
import { readOnly } from '../../../../src/viewer/attachments/label-children.ts';
import { LabelController } from '../../../../src/viewer/attachments/label-controller.ts';
import type { LabelTarget } from '../../../../src/viewer/attachments/label-target.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const whole = syntheticVolume({ dimensions: [4, 2, 1], kind: 'uint16' });
const volume: Volume = {
  ...whole,
  samples: Uint16Array.from({ length: 8 }, (_, i) => i),
  slope: 1,
  intercept: 0,
  isDiscrete: true,
  named: [{ id: 7, name: 'seven', color: null }],
};

/** A controller of labels 1 to 7. */
function makeLabels({ showsGhosts = true } = {}) {
  const wanted = { src: null, table: null, hidden: false, transferFunction: null, only: null as string | null };
  const work: Promise<unknown>[] = [];
  const failures: string[] = [];
  const target = {
    volume,
    awake: true,
    file: 'a.nii',
    window: null,
    showsGhosts,
    track: (one: Promise<unknown>) => void work.push(one),
    failed: (error: unknown) => void failures.push((error as Error).message),
    cleared: () => {},
    reportFiles: () => {},
    show: () => Promise.resolve(),
    replaceTransferFunction: () => {},
    takeAsLabels: () => Promise.resolve(),
  } satisfies LabelTarget;
  const controller = new LabelController({
    said: () => ({ overrides: new Map([[2, { hidden: true }]]), error: null }),
    wanted: () => wanted,
    changed: () => {},
    target: () => target,
    failed: () => {},
  });
  const settle = async (): Promise<void> => void (await Promise.all(work.splice(0)));
  return {
    controller,
    failures,
    settle,
    /** Set the attribute, as the element does. */
    write: async (text: string | null) => {
      wanted.only = text;
      controller.forgetChoices();
      controller.restyle();
      await settle();
    },
    load: async () => {
      controller.refresh();
      await settle();
    },
    shown: () => controller.entries.filter(({ hidden }) => !hidden).map(({ id }) => id),
    ghosts: () => controller.entries.filter(({ isGhost }) => isGhost).map(({ id }) => id),
  };
}

describe('the labels that an author shows', () => {
  it('are these and no others; without the attribute all but those with `hidden`', async () => {
    const { load, write, shown, ghosts } = makeLabels();
    await load();
    expect(shown()).to.deep.equal([1, 3, 4, 5, 6, 7]);
    await write('2 7');
    expect([shown(), ghosts()]).to.deep.equal([[2, 7], []]);
    await write(' 3,  ghost ');
    expect([shown(), ghosts()]).to.deep.equal([[3], [1, 2, 4, 5, 6, 7]]);
    await write(null);
    expect([shown(), ghosts()]).to.deep.equal([[1, 3, 4, 5, 6, 7], []]);
  });

  it('give way to the choice of a person, until the attribute is set again', async () => {
    const { controller, load, write, settle, shown, ghosts } = makeLabels();
    await load();
    await write('3 ghost');
    controller.choose(controller.entries.map(({ id }) => id).filter((id) => id !== 3 && id !== 4));
    await settle();
    expect([shown(), ghosts()]).to.deep.equal([
      [3, 4],
      [1, 2, 5, 6, 7],
    ]);
    controller.choose([], false);
    await settle();
    expect([shown(), ghosts()]).to.deep.equal([[1, 2, 3, 4, 5, 6, 7], []]);
    await write('3 ghost');
    expect([shown(), ghosts()]).to.deep.equal([[3], [1, 2, 4, 5, 6, 7]]);
  });

  it('leave no trace of the others in a projection', async () => {
    const { load, write, shown, ghosts } = makeLabels({ showsGhosts: false });
    await load();
    await write('3 ghost');
    expect([shown(), ghosts()]).to.deep.equal([[3], []]);
  });

  it('are all of them where the text can not be read, with words that say why', async () => {
    const { load, write, shown, failures } = makeLabels();
    await load();
    await write('3 heart');
    await write('3 99');
    await write('');
    expect(shown()).to.deep.equal([1, 3, 4, 5, 6, 7]);
    const rest =
      'expected ids of labels in the file, like "17 18", or "17 18 ghost", which shows the rest as a grey trace.';
    expect(failures).to.deep.equal(['heart', '99', ''].map((text) => `only of <volume-labels> got "${text}"; ${rest}`));
    expect(readOnly('ghost', [0, 1]).error?.message).to.contain('got "ghost"');
    expect(readOnly('heart', [])).to.deep.equal({ value: null, error: null }); // Before the file is there.
    expect(readOnly('__proto__', [0, 1]).value).to.equal(null);
  });
});
