// A pyramid of labels: which level is read for a volume, and that nothing is ever averaged.
import { expect } from '@esm-bundle/chai';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../../src/volume/grid.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { labelPartOf } from '../../../../src/viewer/attachments/place-labels.ts';
import { labelsIn } from '../../../../src/viewer/loading/label-files.ts';
import { expectError, roomyLimits, valuesOf } from '../../../helpers/decode.ts';
import { pyramidFiles } from '../../../helpers/zarr-bytes.ts';
import type { PyramidCase } from '../../../helpers/zarr-bytes.ts';
import { memoryTree, readStore } from '../../../helpers/zarr-tree.ts';

/** Levels of 20, 10 and 5 voxels along x, of 1, 2 and 4 µm. */
const cells: PyramidCase = {
  shape: [16, 12, 20],
  levels: 3,
  type: 'uint8',
  valueAt: ({ x }) => (x > 9 ? 200 : 3),
  attributes: { 'image-label': { properties: [{ 'label-value': 3, name: 'glass' }] } },
};
const plain: PyramidCase = { ...cells, attributes: {} };
const limits = (maxBytes: number): { limits: typeof roomyLimits } => ({ limits: { ...roomyLimits, maxBytes } });
/** The labels in a volume, which may have numbers of their own. */
function idsOf(volume: Volume): number[] {
  const ids = [...new Set(valuesOf(volume).map((value) => volume.ids?.[value] ?? value))];
  ids.sort((one, other) => one - other);
  return ids;
}

describe('a pyramid of labels', () => {
  it('is read as finely as its volume is, and no finer', async () => {
    for (const [detail, dimensions] of [
      [0.0005, [20, 12, 16]],
      [0.001, [20, 12, 16]],
      [0.0019, [20, 12, 16]],
      [0.002, [10, 6, 8]],
      [0.0039, [10, 6, 8]],
      [1, [5, 3, 4]],
    ] as const) {
      const volume = await readStore(pyramidFiles(cells), { labelDetail: detail });
      expect(volume.grid.dimensions).to.deep.equal(dimensions);
      expect(volume.left).to.equal(undefined);
    }
  });

  it('is read where its volume is', async () => {
    const tree = memoryTree(pyramidFiles({ ...cells, chunk: [4, 4, 4] }));
    const region = [-9, -9, 0, -6, -6, 3].map((one) => one / 1000);
    const volume = await readStore(tree, { labelDetail: 0.001, region });
    expect(volume.grid.dimensions).to.deep.equal([4, 4, 4]);
    expect(tree.asked.filter((path) => /^0\/\d/.test(path))).to.have.length(4);
    expect(tree.parts, 'no coarse one comes first').to.have.length(0);
    const beside = readStore(pyramidFiles(cells), { labelDetail: 0.001, region: [5, 5, 5, 6, 6, 6] });
    const error = await expectError(beside);
    expect([error.code, error.message.includes('no place in common')]).to.deep.equal(['format/unsupported', true]);
  });

  it('is read at the finest level that fits, and says what may be missing', async () => {
    const volume = await finishVolume(
      await readStore(pyramidFiles(cells), { labelDetail: 0.001 }, limits(500)),
      roomyLimits,
    );
    expect(volume.grid).to.deep.include({ dimensions: [10, 6, 8] });
    expect(volume.left).to.deep.equal([
      'the labels are those of 10 x 6 x 8 larger voxels, instead of 20 x 12 x 16: the finer levels have more than 1 GiB, and small labels may be missing',
    ]);
    expect(idsOf(volume)).to.deep.equal([3, 200]);
  });

  it('whose coarsest level is too large is made smaller by what most voxels have, not by means', async () => {
    const few = limits(30);
    const volume = await finishVolume(await readStore(pyramidFiles(cells), { labelDetail: 0.001 }, few), few.limits);
    expect(volume.samples.length).to.be.at.most(30);
    expect(idsOf(volume)).to.deep.equal([3, 200]);
    expect(labelsIn({ ...volume, reduced: undefined }, 'x').found.ids).to.include.members([3, 200]);
  });

  it('that is not said to be one is read at its finest level only: coarser ones may have means', async () => {
    const volume = await readStore(pyramidFiles(plain), { labelDetail: 1 });
    expect(volume.grid.dimensions).to.deep.equal([20, 12, 16]);
    const error = await expectError(readStore(pyramidFiles(plain), { labelDetail: 1 }, limits(500)));
    expect(error.code).to.equal('format/too-large');
    expect(error.message).to.include(
      '20 x 12 x 16 voxels; expected at most 1 GiB of labels, or a pyramid whose metadata',
    );
  });
});

describe('what of a pyramid of labels a volume needs', () => {
  const volumeOf = (more: Partial<Volume>): Volume => ({ format: 'NIfTI-1', unit: '', ...more }) as Volume;

  it('is the box of its voxels, and its shortest side of a voxel', () => {
    const grid = cartesianGrid([4, 3, 2], [2, 0, 0, 10, 0, -1, 0, 5, 0, 0, 8, 0, 0, 0, 0, 1]);
    expect(labelPartOf(volumeOf({ grid }))).to.deep.equal({ region: [9, 2.5, -4, 17, 5.5, 12], labelDetail: 1 });
    const quarter = cartesianGrid([4, 2, 1], [0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    expect(labelPartOf(volumeOf({ grid: quarter }))!.region).to.deep.equal([-1.5, -0.5, -0.5, 0.5, 3.5, 0.5]);
  });

  it('is not known of an image, which has no place', () => {
    const grid = cartesianGrid([4, 3, 2], axialIndexToWorld([4, 3, 2], [1, 1, 1]));
    expect(labelPartOf(volumeOf({ grid, format: 'PNG mosaic' }))).to.equal(undefined);
  });
});
