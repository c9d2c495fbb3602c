// The table of `npm run accuracy -- count`: samples that are needed, and what bounds ask for.
import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { boundingSphere } from '../../../src/volume/grid.ts';
import { countSamples } from '../../accuracy/count-samples.ts';
import type { SamplesResult } from '../../accuracy/count-samples.ts';
import { VoxelBlock } from '../../accuracy/voxel-block.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

const errors = [8, 1] as const;

/** Counted of 24 voxels along each edge, whose length is ten reference lengths. */
function count(value: (i: number, j: number, k: number) => number, stops: string): SamplesResult[] {
  const volume = new VoxelBlock(24, value).toVolume();
  const camera = orbitCamera({ theta: 0.5, phi: 1.2, radius: 60 }, boundingSphere(volume.grid).center, 0.7);
  return countSamples(
    {
      name: 'a cube',
      volume,
      transferFunction: parseTransferFunction(stops, [0, 255]),
      referenceLength: 2.4,
      view: viewMatrix(camera),
      projection: projectionMatrix(camera.fieldOfView, 1, 1, 2),
    },
    errors,
  );
}

describe('samples that are needed', () => {
  it('are one for the longest step where all is even, and bounds ask for no more than its longest there', () => {
    const even = count(() => 100, '0 #fff 4%, 255 #fff 4%');
    for (const { needed, byLargeCells, byLargeCellsAndLight, maxError } of even) {
      expect(needed, `at ${maxError}`).to.be.within(1 / 8, 1 / 4); // The last step of a ray is shorter.
      expect(byLargeCells, `at ${maxError}`).to.equal(maxError === 8 ? 1 / 4 : 1);
      expect(byLargeCellsAndLight, `at ${maxError}`).to.equal(byLargeCells);
    }
  });

  it('are more in noise and for a smaller error, never more than bounds ask for, and fewer by smaller cells around a speck', () => {
    const random = randomNumbers(3);
    const ramp = '0 #234 0, 30 #48c 2%, 140 #c96 20%, 255 white 40%';
    const noise = count(() => 255 * random(), ramp);
    const smooth = count((i) => 100 + 2 * i, ramp);
    for (const [i, { maxError, needed, byLargeCells, byLargeCellsAndLight }] of noise.entries()) {
      expect(needed!, `at ${maxError}`).to.be.above(smooth[i].needed!);
      expect(needed!, `at ${maxError}`).to.be.below(byLargeCellsAndLight);
      expect(byLargeCellsAndLight, `at ${maxError}`).to.be.at.most(byLargeCells);
    }
    const dot = count(
      (i, j, k) => (i === 14 && j === 14 && k === 14 ? 255 : 0),
      '0 #fff 0, 100 #fff 0, 200 #fff 40%, 255 #fff 40%',
    );
    for (const { bySmallCells, byLargeCells, maxError } of dot)
      expect(bySmallCells, `a speck, at ${maxError}`).to.be.below(0.5 * byLargeCells);
    expect(noise[1].needed).to.be.above(noise[0].needed!);
    expect(noise[1].byLargeCellsAndLight, 'light behind noise').to.be.below(noise[1].byLargeCells);
  });
});
