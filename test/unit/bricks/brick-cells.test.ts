import { expect } from '@esm-bundle/chai';
import { BrickCells } from '../../../src/bricks/brick-cells.ts';
import { brickSide } from '../../../src/bricks/brick-data.ts';
import { layBricks } from '../../../src/bricks/brick-layout.ts';
import { findSeenCells } from '../../../src/optics/cells/seen-cells.ts';
import { cartesianGrid, offLine } from '../../../src/volume/grid.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../src/volume/macrocells.ts';
import type { Macrocells } from '../../../src/volume/macrocells.ts';
import { scaleAndTranslate } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { cutIntoBricks, readBrick } from '../../helpers/bricks.ts';
import type { Bricked } from '../../helpers/bricks.ts';
import { fieldWithHole, randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

const numberAt = ({ dimensions: [cx, cy] }: Pick<Macrocells, 'dimensions'>, [i, j, k]: Vector3): number =>
  i + cx * (j + cy * k);

const cellAt = ({ dimensions, size }: Macrocells, voxels: Vector3, place: Vector3): number =>
  numberAt(
    { dimensions },
    place.map((x, axis) => Math.min(dimensions[axis] - 1, Math.floor((x * voxels[axis]) / size))) as unknown as Vector3,
  );

/** Places whose value is not between those of their cell. */
function listOutside({ volume }: Bricked): string[] {
  const random = randomNumbers(8);
  const { macrocells } = volume.finer.current(volume);
  const wrong: string[] = [];
  for (let n = 0; n < 20_000; n++) {
    const place: Vector3 = [random(), random(), random()];
    const value = volume.finer.storedAt(place);
    const cell = cellAt(macrocells, volume.grid.dimensions, place);
    if (value < macrocells.low[cell] - 1e-3 || value > macrocells.high[cell] + 1e-3)
      wrong.push(`${place.join(' ')}: ${value} in ${macrocells.low[cell]} to ${macrocells.high[cell]}`);
  }
  return wrong;
}

describe('macrocells of bricks', () => {
  for (const kind of ['uint8', 'uint16', 'float32'] as const)
    it(`have all values of their places, while bricks come and go: ${kind}`, () => {
      const random = randomNumbers(4);
      const field = (x: number, y: number, z: number): number =>
        kind === 'float32' && x > 0.6 ? fieldWithHole(x, y, z) : random();
      const whole = syntheticVolume({ dimensions: [70, 96, 40], kind, field });
      const bricked = cutIntoBricks(whole, 3, ({ level, at: [i, j] }) => (level === 0 ? i === 1 : j === 0));
      expect(listOutside(bricked)).to.deep.equal([]);
      const { finer } = bricked.volume;
      for (const brick of [...finer.bricks]) if (random() < 0.5) finer.remove(brick);
      expect(listOutside(bricked), 'some went').to.deep.equal([]);
      for (let level = 0; level < 2; level++)
        for (let j = 0; j < 2; j++) {
          const brick = { level, at: [0, j, 0] as const };
          finer.add(brick, readBrick(bricked.pyramid, brick));
        }
      expect(listOutside(bricked), 'others came').to.deep.equal([]);
    });

  it('are those of the whole volume where all of its bricks are there', () => {
    const random = randomNumbers(5);
    const whole = syntheticVolume({ dimensions: [128, 96, 64], field: () => random() ** 8 });
    const { volume } = cutIntoBricks(whole, 3, ({ level }) => level === 0);
    const { dimensions, size, low, high, roughness } = volume.macrocells;
    const expected = buildMacrocells(whole.samples, whole.grid.dimensions, 8);
    expect([dimensions, size]).to.deep.equal([expected.dimensions, 8 / 4]);
    expect(Array.from(low)).to.deep.equal(Array.from(expected.low));
    expect(Array.from(high)).to.deep.equal(Array.from(expected.high));
    for (const [cell, rough] of roughness.entries()) {
      expect(rough).to.be.at.least(Math.min(expected.roughness[cell], (high[cell] - low[cell]) / offLine) - 1e-3);
      expect(rough, 'also across the faces of bricks').to.be.at.most(1.6 * expected.roughness[cell] + 1e-3);
    }
  });

  it('are as large as the share of the finest level asks, and no more than a page can look through', () => {
    const whole = syntheticVolume({ dimensions: [128, 128, 128] });
    const sizes = [1, 2].map((levels) => cutIntoBricks(whole, levels + 1, () => false).volume.macrocells.size);
    expect(sizes).to.deep.equal([4, 2]);
    const dimensions: Vector3 = [256, 256, 256];
    const samples = new Uint8Array(256 ** 3);
    const [coarse, fine] = [4, 1].map((edge) =>
      cartesianGrid(
        edge === 4 ? dimensions : [1024, 1024, 1024],
        scaleAndTranslate([edge, edge, edge], [edge / 2, edge / 2, edge / 2]),
      ),
    );
    const layout = layBricks(coarse, [{ ...fine, bricks: [32, 32, 32], factors: [1, 1, 1] }])!;
    const { macrocells } = new BrickCells(
      { grid: coarse, samples, macrocells: buildMacrocells(samples, dimensions) },
      layout,
    );
    expect([macrocells.size, macrocells.low.length], 'a fourth of 8 would be fine enough').to.deep.equal([4, 2 ** 18]);
  });

  it('show what only a fine level has, and skip what only a coarse one has', () => {
    const spike = (x: number, y: number, z: number): number => Number(Math.hypot(x - 0.4, y - 0.3, z - 0.6) < 0.012);
    const whole = syntheticVolume({ dimensions: [64, 64, 64], field: spike });
    const seen = (isThere: boolean, least: number): number => {
      const { macrocells, ...volume } = cutIntoBricks(whole, 2, () => isThere).volume;
      const cells = findSeenCells(macrocells, [(_: number, high: number) => high > least], volume);
      return cells.reduce((sum, cell) => sum + cell, 0);
    };
    expect([seen(false, 0.9), seen(true, 0.9)]).to.deep.equal([0, 1]);
    expect(seen(true, 0)).to.be.below(seen(false, 0));
  });

  it('are as rough as the voxels that are sampled, not as those of a coarse level', () => {
    const whole = syntheticVolume({ dimensions: [128, 64, 64], field: (x) => Number(x > 0.55) });
    const one = { level: 0, at: [0, 0, 0] as const };
    const { volume, pyramid } = cutIntoBricks(whole, 3, () => false);
    const before = volume.finer.current(volume).macrocells.roughness.slice();
    expect(Math.max(...before)).to.be.above(100);
    volume.finer.add(one, readBrick(pyramid, one));
    const after = volume.finer.current(volume).macrocells.roughness;
    const far = cellAt(volume.macrocells, volume.grid.dimensions, [0.55, 0.9, 0.9]);
    expect(before[far]).to.be.above(50);
    expect(after[far] / before[far]).to.be.closeTo(1 / 4, 1e-6);
    expect(brickSide).to.equal(32);
  });

  it('say how long the voxels in them are, next to the shortest that are shown anywhere', () => {
    const whole = syntheticVolume({ dimensions: [128, 64, 64], field: () => 0.5 });
    const { volume, pyramid } = cutIntoBricks(whole, 3, () => false);
    const { finer, grid } = volume;
    const lengths = (): readonly number[] => {
      const { macrocells } = finer.current(volume);
      return [0.1, 0.3, 0.6].map((x) => 2 ** macrocells.longer![cellAt(macrocells, grid.dimensions, [x, 0.2, 0.2])]);
    };
    const all = lengths();
    const [middle, fine] = [
      { level: 1, at: [0, 0, 0] as const },
      { level: 0, at: [0, 0, 0] as const },
    ];
    finer.add(middle, readBrick(pyramid, middle));
    const two = lengths();
    finer.add(fine, readBrick(pyramid, fine));
    const three = lengths();
    finer.remove([...finer.bricks].find(({ level }) => level === 0)!);
    expect([all, two, three, lengths()]).to.deep.equal([
      [1, 1, 1],
      [1, 1, 2],
      [1, 2, 4],
      [1, 1, 2],
    ]);
  });

  it('are as rough as steps of the shortest edge find them, where voxels are longer along other axes', () => {
    const gridOfVoxels = (edges: Vector3): CartesianGrid =>
      cartesianGrid(
        edges.map((edge) => 256 / edge) as unknown as Vector3,
        scaleAndTranslate(edges, edges.map((edge) => edge / 2) as unknown as Vector3),
      );
    const coarse = gridOfVoxels([4, 16, 16]);
    const random = randomNumbers(6);
    const samples = new Uint8Array(64 * 16 * 16).map(() => 255 * random());
    const volume = { grid: coarse, samples, macrocells: buildMacrocells(samples, coarse.dimensions) };
    const layout = layBricks(coarse, [
      { ...gridOfVoxels([1, 4, 4]), bricks: [8, 2, 2], factors: [1, 1, 1] },
      { ...gridOfVoxels([4, 4, 4]), bricks: [2, 2, 2], factors: [4, 1, 1] },
    ])!;
    const cells = new BrickCells(volume, layout);
    const before = cells.macrocells.roughness.slice();
    // Bricks whose voxels have the same shortest edge as the volume's: rays take no shorter steps than before.
    cells.update(() => undefined, 1);
    expect(Array.from(cells.macrocells.roughness)).to.deep.equal(Array.from(before));
    cells.update(() => undefined, 0);
    expect(cells.macrocells.roughness[5] / before[5]).to.be.closeTo(1 / 4, 1e-6);
  });
});
