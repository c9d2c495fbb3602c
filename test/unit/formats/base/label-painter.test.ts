import { expect } from '@esm-bundle/chai';
import { LabelPainter } from '../../../../src/formats/base/label-painter.ts';

describe('a painter of labels', () => {
  it('says which labels hide others, and of many only the first ones', () => {
    const painter = new LabelPainter(new Uint8Array(20));
    for (let voxel = 0; voxel < 10; voxel++) {
      painter.paint(voxel, voxel + 1);
      painter.paint(voxel, voxel + 100);
    }
    const said = painter.describeHidden((id) => `segment ${id}`);
    expect(said).to.have.length(9);
    expect(said[0]).to.equal('1 of the 1 voxels of segment 1 are hidden by segment 100, which overlaps it');
    expect(said[8]).to.equal('the same of 2 other pairs of them');
    expect(Array.from(painter.samples.subarray(0, 10))).to.deep.equal(Array.from({ length: 10 }, (_, i) => i + 100));
  });
});
