import { expect } from '@esm-bundle/chai';
import { findDetail, readCode } from '../../../../src/optics/cells/cell-detail.ts';
import type { SeenVolume } from '../../../../src/optics/cells/cell-detail.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

/** One cell of 8 voxels, with a speck of 2 x 2 x 2; opacities of a voxel. */
function seenOf(speck: number, opacity: string, more: Partial<SeenVolume> = {}): SeenVolume {
  const edge = 8;
  const middle = (edge - 1) / 2;
  const volume = syntheticVolume({
    dimensions: [edge, edge, edge],
    field: (x, y, z) => (Math.hypot(x - 0.5, y - 0.5, z - 0.5) * edge < middle / 4 ? speck : 0.2),
  });
  return {
    volume,
    cells: Uint8Array.of(1),
    transferFunction: parseTransferFunction(`0 #fff 0, 1 #fff ${opacity}`, [0, 1]),
    opticalScale: 1,
    ...more,
  };
}

/** Voxels in a step of the cell. */
function stepOf(seen: SeenVolume, maxError: number, isLong = true): number {
  const { samples, longer } = readCode(findDetail(seen, (10 * maxError) / 255, isLong)[0]);
  return longer / samples;
}

describe('the length of steps in a cell', () => {
  it('is more than a voxel where nothing that stands out by eight times `max-error` can be in it', () => {
    const smooth = seenOf(0.2, '10%');
    expect([stepOf(smooth, 8), stepOf(smooth, 8, false)]).to.deep.equal([4, 1]);
    const steps = ['1%', '5%', '30%', '99%'].map((opacity) => stepOf(seenOf(1, opacity), 8));
    expect(steps[0]).to.equal(4);
    expect(steps[3]).to.be.at.most(1);
    for (const [n, voxels] of steps.entries()) if (n > 0) expect(voxels).to.be.at.most(steps[n - 1]);
    for (const maxError of [2, 4, 8, 16])
      for (const opacity of ['1%', '2%', '4%', '8%', '16%', '32%']) {
        const seen = seenOf(1, opacity);
        // A thing that is as long as the step.
        const most = 1 - (1 - Number.parseFloat(opacity) / 100) ** (0.8 * stepOf(seen, maxError));
        if (stepOf(seen, maxError) > 1) expect(255 * most).to.be.at.most(8 * maxError);
      }
  });

  it('is no more than a voxel where rays meet something between samples, or where voxels may lack data', () => {
    for (const more of [
      { hasSurfaces: true },
      { jumps: [() => 0] },
      { found: [0.5] },
      { functions: [] },
      { more: () => 0 },
    ] as Partial<SeenVolume>[])
      expect(stepOf(seenOf(0.2, '1%', more), 8), Object.keys(more)[0]).to.be.at.most(1);
    const seen = seenOf(0.2, '80%');
    expect(stepOf(seen, 8)).to.equal(4);
    expect(stepOf({ ...seen, volume: { ...seen.volume, hasNoData: true } }, 8)).to.be.at.most(1);
  });
});
