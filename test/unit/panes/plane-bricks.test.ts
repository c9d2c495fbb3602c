// Which level of a pyramid a pane reads, and which of its bricks; and the values that it then has.
import { expect } from '@esm-bundle/chai';
import { brickSide } from '../../../src/bricks/brick-data.ts';
import { listBricks } from '../../../src/bricks/pyramid.ts';
import { fillRows } from '../../../src/panes/fill-slice.ts';
import { brickSampler } from '../../../src/panes/brick-field.ts';
import { chooseLevelOfPlane } from '../../../src/panes/plane-bricks.ts';
import { linearSampler, nearestSampler } from '../../../src/panes/sample-at.ts';
import type { ViewedPlane } from '../../../src/volume/finer-voxels.ts';
import { add, cross, invertAffine, normalize, scale, transformPoint } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { cutIntoBricks, gridOf, readBrick } from '../../helpers/bricks.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

const dimensions: Vector3 = [150, 100, 70];
const random = randomNumbers(3);
const whole = syntheticVolume({
  dimensions,
  // Axes that are turned and of different lengths.
  indexToWorld: [0.8, -0.4, 0.1, -40, 0.3, 1.1, -0.2, 20, 0, 0.1, 1.7, 5, 0, 0, 0, 1],
  field: () => random(),
});
const { pyramid, volume, layout } = cutIntoBricks(whole, 3, () => false);
const levels = layout.levels.map((frame, level) => ({ ...gridOf(whole, pyramid, level), ...frame }));
const unlimited = 10_000;

/** A plane through the middle of the volume, pixels of so many world units. */
function planeOf(normal: Vector3, pixel: number, more: Partial<ViewedPlane> & { readonly thickness?: number } = {}) {
  const along = normalize(normal);
  const right = normalize(cross(along, Math.abs(along[2]) > 0.9 ? [0, 1, 0] : [0, 0, 1]));
  const down = cross(along, right);
  const { width = 64, height = 48, thickness = 0 } = more;
  const middle = transformPoint(whole.grid.indexToWorld, scale(dimensions, 0.5));
  const first = add(middle, add(scale(right, (-pixel * (width - 1)) / 2), scale(down, (-pixel * (height - 1)) / 2)));
  return {
    width,
    height,
    first,
    across: scale(right, pixel),
    down: scale(down, pixel),
    way: scale(along, thickness),
    isNearest: false,
    ...more,
  } satisfies ViewedPlane;
}

const randomNormal = (): Vector3 => [random() - 0.5, random() - 0.5, random() - 0.5];

describe('the level that a pane reads', () => {
  it('is the coarsest whose voxels are no larger than the pixels, and none where the volume is as fine', () => {
    const levelFor = (pixel: number): number | undefined =>
      chooseLevelOfPlane(levels, volume.grid, planeOf([0, 0, 1], pixel), unlimited)?.level;
    expect([0.1, 0.8, 2.3, 3, 4.6, 40].map(levelFor)).to.deep.equal([0, 0, 1, 1, undefined, undefined]);
  });

  it('is a coarser one where a finer one needs more bricks than have room', () => {
    const plane = planeOf([0, 0, 1], 0.8, { width: 160, height: 160 });
    const all = chooseLevelOfPlane(levels, volume.grid, plane, unlimited)!;
    expect([all.level, all.bricks.length > 12]).to.deep.equal([0, true]);
    const fewer = chooseLevelOfPlane(levels, volume.grid, plane, all.bricks.length - 1)!;
    expect([fewer.level, fewer.bricks.length < all.bricks.length]).to.deep.equal([1, true]);
    expect(chooseLevelOfPlane(levels, volume.grid, plane, 1)).to.equal(null);
  });
});

describe('the bricks that a pane reads', () => {
  it('are all that its pixels meet, also of oblique planes and slabs, and few others', () => {
    let [needed, listed] = [0, 0];
    for (let n = 0; n < 60; n++) {
      const thickness = n % 3 === 0 ? 30 * random() : 0;
      const plane = planeOf(n % 5 === 0 ? [0, 0, 1] : randomNormal(), 0.7, { thickness });
      const { level, worldToIndex, bricks } = chooseLevelOfPlane(levels, volume.grid, plane, unlimited)!;
      expect(level).to.equal(0);
      const keys = new Set(bricks.map(({ at }) => String(at)));
      expect(keys.size).to.equal(bricks.length);
      const met = new Set<string>();
      for (let row = 0; row < plane.height; row++)
        for (let column = 0; column < plane.width; column++)
          for (const share of thickness > 0 ? [-0.5, -0.25, 0, 0.25, 0.5] : [0]) {
            const world = add(
              add(plane.first, scale(plane.way, share)),
              add(scale(plane.across, column), scale(plane.down, row)),
            );
            const index = transformPoint(worldToIndex, world);
            if (index.every((x, axis) => x >= -0.5 && x < dimensions[axis] - 0.5))
              met.add(String(index.map((x) => Math.floor((x + 0.5) / brickSide))));
          }
      for (const key of met) expect(keys.has(key), `${key} of plane ${n}`).to.equal(true);
      needed += met.size;
      listed += keys.size;
    }
    console.log(`needed ${needed}, listed ${listed}`);
    expect(listed / needed).to.be.below(1.5);
  });

  it('come from the middle of the pane outwards; a plane outside the volume needs none', () => {
    const { bricks } = chooseLevelOfPlane(levels, volume.grid, planeOf([0, 0, 1], 0.8, { width: 150 }), unlimited)!;
    expect(bricks[0].at).to.deep.equal([2, 1, 1]);
    const away = planeOf([0, 0, 1], 0.8, { first: [5000, 0, 0] });
    expect(chooseLevelOfPlane(levels, volume.grid, away, unlimited)!.bricks).to.deep.equal([]);
  });
});

describe('the values of a pane that reads bricks', () => {
  const samples = (level: number, isThere: (at: Vector3) => boolean) => {
    const known = new Map(
      listBricks(pyramid, level)
        .filter(({ at }) => isThere(at))
        .map((brick) => [String(brick.at), readBrick(pyramid, brick, false).samples]),
    );
    return (at: Vector3) => known.get(String(at));
  };
  const coarse = { ...volume, dimensions: volume.grid.dimensions, indexToWorld: volume.grid.indexToWorld };
  const fill = (sampleAt: (x: number, y: number, z: number) => number, plane: ViewedPlane): Float64Array => {
    const values = new Float64Array(plane.width * plane.height);
    const field = { sampleAt, worldToIndex: invertAffine(whole.grid.indexToWorld)! };
    fillRows({ field, pixels: plane, slab: { normal: [0, 0, 1], thickness: 0, projection: 'max' } }, values, [
      0,
      plane.height,
    ]);
    return values;
  };

  for (const isNearest of [false, true])
    it(`are those of the whole level, up to its ends${isNearest ? ', of the nearest voxel' : ''}`, () => {
      const level = { ...levels[0], samplesOf: samples(0, () => true) };
      const block = { samples: whole.samples, dimensions, hasNoData: false };
      const expected = isNearest ? nearestSampler(block) : linearSampler(block);
      for (let n = 0; n < 6; n++) {
        const plane = planeOf(randomNormal(), 1.9, { width: 90, height: 90 });
        const [got, want] = [brickSampler(level, coarse, isNearest), expected].map((sampleAt) => fill(sampleAt, plane));
        let inside = 0;
        for (let i = 0; i < got.length; i++) {
          if (Number.isNaN(want[i])) expect(Number.isNaN(got[i])).to.equal(true);
          else expect(Math.abs(got[i] - want[i])).to.be.below(1e-9);
          inside += Number(!Number.isNaN(want[i]));
        }
        expect(inside).to.be.above(500);
      }
    });

  it('are those of the volume where a brick has not come, at the same places', () => {
    const level = { ...levels[0], samplesOf: samples(0, ([i]) => i === 0) };
    const read = brickSampler(level, coarse, false);
    const block = { samples: volume.samples, dimensions: volume.grid.dimensions, hasNoData: false };
    const toCoarse = invertAffine(volume.grid.indexToWorld)!;
    for (let n = 0; n < 300; n++) {
      const index = [40 + 100 * random(), 95 * random(), 66 * random()] as const;
      const at = transformPoint(toCoarse, transformPoint(whole.grid.indexToWorld, index));
      expect(read(...index)).to.be.closeTo(linearSampler(block)(...at), 1e-6);
    }
    expect(Number.isNaN(read(-0.6, 10, 10))).to.equal(true);
    // The level ends half of a coarse voxel before the volume does, or later: there are values up to its own end.
    expect(read(149.4, 99.4, 69.4)).to.be.at.least(0);
  });
});
