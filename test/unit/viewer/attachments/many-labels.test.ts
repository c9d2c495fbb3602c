// Choices among as many labels as there can be: the work is counted, not timed.
import { expect } from '@esm-bundle/chai';
import { LabelController } from '../../../../src/viewer/attachments/label-controller.ts';
import type { LabelTarget } from '../../../../src/viewer/attachments/label-target.ts';
import type { ViewLabels } from '../../../../src/viewer/model/view-labels.ts';
import { maxLabels } from '../../../../src/volume/index-numbers.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

/** A volume of which each voxel has a label of its own. */
const whole = syntheticVolume({ dimensions: [64, 32, 32], kind: 'uint16' });
const volume: Volume = {
  ...whole,
  samples: Uint16Array.from({ length: maxLabels }, (_, i) => i),
  slope: 1,
  intercept: 0,
  isDiscrete: true,
  named: [{ id: 7, name: 'seven', color: null }],
};

/** A controller that has the labels, and how often the author's children were read. */
async function loaded(): Promise<{
  controller: LabelController;
  counts: { said: number };
  settle: () => Promise<void>;
}> {
  const work: Promise<unknown>[] = [];
  const counts = { said: 0 };
  const target = {
    volume,
    awake: true,
    file: 'a.nii',
    window: null,
    showsGhosts: true,
    track: (one: Promise<unknown>) => void work.push(one),
    failed: (error: unknown) => {
      throw error;
    },
    cleared: () => {},
    reportFiles: () => {},
    show: (_labels: ViewLabels | null) => Promise.resolve(),
    replaceTransferFunction: () => {},
    takeAsLabels: () => Promise.resolve(),
  } satisfies LabelTarget;
  const controller = new LabelController({
    said: () => {
      counts.said++;
      return { overrides: new Map([[9, { opacity: 0.5 }]]), error: null };
    },
    wanted: () => ({ src: null, table: null, hidden: false, transferFunction: null }),
    changed: () => {},
    target: () => target,
    failed: (error) => {
      throw error;
    },
  });
  const settle = async (): Promise<void> => void (await Promise.all(work.splice(0)));
  controller.refresh();
  await settle();
  return { controller, counts, settle };
}

describe('a choice among 65,536 labels', () => {
  it('makes new entries only for labels that it changes, and reads nothing else again', async () => {
    const { controller, counts, settle } = await loaded();
    const only = async (id: number): Promise<void> => {
      controller.choose(
        controller.entries.flatMap((entry) => (entry.id === id ? [] : [entry.id])),
        true,
      );
      await settle();
    };
    expect(controller.entries).to.have.lengthOf(maxLabels - 1); // Without the one that stands for no label.
    const { said } = counts;
    await only(7);
    const before = controller.entries;
    expect(before.filter(({ hidden }) => !hidden).map(({ name }) => name)).to.deep.equal(['seven']);
    expect(before.every(({ hidden, isGhost = false }) => hidden === isGhost)).to.equal(true);
    await only(9);
    const after = controller.entries;
    expect(after.filter((entry, i) => entry !== before[i]).map(({ id }) => id)).to.deep.equal([7, 9]);
    expect(after[8]).to.deep.include({ id: 9, hidden: false, opacity: 0.5 }).and.not.have.property('isGhost');
    expect(counts.said).to.equal(said);
    // The author's settings hold again for what is restyled.
    controller.restyle();
    await settle();
    expect(counts.said).to.equal(said + 1);
    expect(controller.entries.filter(({ hidden }) => !hidden).map(({ id }) => id)).to.deep.equal([9]);
  });

  it('without ghosts leaves none', async () => {
    const { controller, settle } = await loaded();
    controller.choose([7, 9], true);
    await settle();
    controller.choose([7], false);
    await settle();
    expect(controller.entries.filter(({ hidden, isGhost }) => hidden || isGhost)).to.have.lengthOf(1);
    expect(controller.entries[6]).to.deep.include({ id: 7, hidden: true }).and.not.have.property('isGhost');
  });
});
