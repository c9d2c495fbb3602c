import { expect } from '@esm-bundle/chai';
import { comparePictures } from '../../../src/prepare/compare-pictures.ts';
import { writeMosaic } from '../../../src/prepare/write-mosaic.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const dimensions = [32, 32, 32] as const;
const size = 48;

/** A ball in a corner of an empty box, and a speck in the opposite corner. */
const ballAnd = (speck: number) =>
  syntheticVolume({
    dimensions,
    kind: 'uint8',
    slope: 1,
    intercept: 0,
    field: (x, y, z) => (Math.hypot(x - 0.3, y - 0.3, z - 0.3) < 0.2 ? 200 : Math.min(x, y, z) > 0.95 ? speck : 0),
  });

describe('pictures of a volume and of what a lossy form made of it', () => {
  it('have one camera: a speck in an empty corner changes few pixels, though it would move the camera', async () => {
    const { image, manifest } = writeMosaic(ballAnd(200));
    const { rms, max } = await comparePictures(ballAnd(0), image, manifest, size);
    expect(max, 'the speck shows').to.be.above(20);
    expect(rms).to.be.below(50); // With a camera for each picture 150: the ball stands in another place.
  });

  it('are equal where the volumes are', async () => {
    const { image, manifest } = writeMosaic(ballAnd(0));
    expect(await comparePictures(ballAnd(0), image, manifest, size)).to.deep.equal({ rms: 0, p99: 0, max: 0 });
  });
});
