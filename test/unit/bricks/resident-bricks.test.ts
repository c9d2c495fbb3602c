import { expect } from '@esm-bundle/chai';
import {
  atlasEdge,
  brickOfCell,
  halvingsOf,
  layBricks,
  mostLevels,
  placeOfSlot,
  shapeAtlas,
  slotsWithin,
} from '../../../src/bricks/brick-layout.ts';
import { chooseGroupSide } from '../../../src/bricks/cell-numbers.ts';
import { brickSide, slotSide } from '../../../src/bricks/brick-data.ts';
import { listBricks } from '../../../src/bricks/pyramid.ts';
import type { AtlasShape, LevelFrame } from '../../../src/bricks/brick-layout.ts';
import type { Brick } from '../../../src/bricks/pyramid.ts';
import { keyOfBrick, ResidentBricks } from '../../../src/bricks/resident-bricks.ts';
import { interpolate } from '../../../src/optics/rays/interpolate.ts';
import { cartesianField } from '../../../src/optics/rays/ray-field.ts';
import { cartesianGrid } from '../../../src/volume/grid.ts';
import { identity } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { cutIntoBricks, readBrick } from '../../helpers/bricks.ts';
import type { Bricked } from '../../helpers/bricks.ts';
import { fieldWithHole, randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

const dimensions: Vector3 = [70, 96, 40];
const random = randomNumbers(3);
const places = Array.from({ length: 2000 }, (): Vector3 => [random(), random(), random()]);

/** Whether a voxel of a brick with its halo is in that. */
const isInHalo = (n: number): boolean =>
  [n % slotSide, Math.floor(n / slotSide) % slotSide, Math.floor(n / slotSide ** 2)].some(
    (m) => m < 2 || m >= slotSide - 2,
  );

/**
 * What a place shows: the voxels of its level, as far as their bricks are there; elsewhere what is shown at their middles.
 * @param place - in voxels of the level, whole numbers at the faces
 * @param shown - the place whose brick is read
 */
function expectedAt(bricked: Bricked, level: number, place: readonly number[], shown = place): number {
  const {
    pyramid: { levels },
    volume: { finer },
  } = bricked;
  const { samples, dimensions } = levels[level];
  const within = place.map((x, axis) => Math.min(dimensions[axis] - 0.5, Math.max(0.5, x)));
  const first = within.map((x) => Math.floor(x - 0.5));
  const own = shown.map((x, axis) => Math.floor(Math.min(dimensions[axis] - 0.5, Math.max(0, x)) / brickSide));
  const voxelAt = (voxel: readonly number[]): number => {
    const at = voxel.map((n) => Math.floor(n / brickSide)) as unknown as Vector3;
    const isThere = level === levels.length - 1 || String(at) === String(own) || finer.get({ level, at });
    if (isThere) return samples[voxel[0] + dimensions[0] * (voxel[1] + dimensions[1] * voxel[2])];
    const cell = voxel.map((n) => Math.floor(((n + 0.5) * 2 ** level) / brickSide));
    const [cx, cy] = bricked.layout.cells;
    const other = finer.levelOf(cell[0] + cx * (cell[1] + cy * cell[2]));
    const value = expectedAt(
      bricked,
      other,
      voxel.map((n) => (n + 0.5) * 2 ** (level - other)),
    );
    return samples instanceof Float32Array ? value : Math.round(value);
  };
  const corners = Float32Array.from({ length: 8 }, (_, n) =>
    voxelAt(first.map((m, axis) => Math.min(dimensions[axis] - 1, m + ((n >> axis) & 1)))),
  );
  return interpolate(corners, [2, 2, 2], within.map((x, axis) => (x - first[axis]) / 2) as unknown as Vector3);
}

describe('bricks that are there', () => {
  for (const kind of ['uint8', 'uint16', 'float32'] as const)
    it(`give the values of the levels that their cells have: ${kind}`, () => {
      const whole = syntheticVolume({ dimensions, kind, ...(kind === 'float32' && { field: fieldWithHole }) });
      const bricked = cutIntoBricks(whole, 3, ({ level, at: [i, j] }) => (level === 0 ? i === 1 : j === 0));
      const { volume } = bricked;
      const { finer } = volume;
      const levelOf = Uint8Array.from({ length: 3 * 3 * 2 }, (_, cell) => finer.levelOf(cell));
      expect([0, 1, 2, 3].filter((level) => levelOf.includes(level))).to.deep.equal([0, 1, 2]);
      // The volume's own unit cube reaches as far as its last voxel; that of the finest level ends before.
      const ends = dimensions.map((n, axis) => (4 * volume.grid.dimensions[axis]) / n);
      const field = cartesianField({ ...volume, dimensions: volume.grid.dimensions, slope: 1, intercept: 0 });
      for (const place of places) {
        if (place.some((n, axis) => n * ends[axis] > 1)) continue;
        const level = finer.levelOf(finer.cellAt(place));
        const voxels = place.map((n, axis) => (n * ends[axis] * dimensions[axis]) / 2 ** level);
        const { value } = field.sampleAt(place);
        const other = expectedAt(bricked, level, voxels);
        if (Number.isNaN(other)) expect(Number.isNaN(value)).to.equal(true);
        else expect(value).to.be.closeTo(other, 1e-3 * (1 + Math.abs(other)));
        // A voxel away, the brick of the place is read: light does so at its faces, too.
        for (const [axis, by] of [
          [0, 1],
          [1, -1],
          [2, 1],
        ]) {
          const away = voxels.map((n, one) => (one === axis ? n + by : n));
          const beyond = expectedAt(bricked, level, away, voxels);
          const got = finer.storedNextTo(place, axis, by);
          if (Number.isNaN(beyond)) expect(Number.isNaN(got)).to.equal(true);
          else expect(got).to.be.closeTo(beyond, 1e-3 * (1 + Math.abs(beyond)));
        }
      }
    });

  it('give the same values in whatever order they came and went, and whatever halo they came with', () => {
    const whole = syntheticVolume({ dimensions, field: () => random() });
    const isThere = ({ level, at: [i, j, k] }: Brick): boolean => (level === 0 ? (i + j + k) % 2 === 0 : i === 0);
    const { pyramid, volume } = cutIntoBricks(whole, 3, isThere);
    const { finer } = cutIntoBricks(whole, 3).volume;
    const all = [...finer.bricks];
    for (const brick of all) finer.remove(brick);
    all.reverse();
    for (const brick of all) {
      const read = readBrick(pyramid, brick);
      read.samples.forEach((_, n) => (read.samples[n] = isInHalo(n) ? 255 : read.samples[n]));
      finer.add(brick, read);
    }
    finer.current(volume);
    for (const brick of all) if (!isThere(brick)) finer.remove(brick);
    const cells = finer.current(volume).macrocells;
    const complete = all.filter((brick) => finer.get(brick) && finer.isComplete(brick));
    expect([finer.count, complete.length]).to.deep.equal([volume.finer.count, 0]);
    for (const place of places) expect(finer.storedAt(place)).to.equal(volume.finer.storedAt(place));
    const expected = volume.finer.current(volume).macrocells;
    for (const what of ['low', 'high', 'roughness'] as const)
      expect([...cells[what]], what).to.deep.equal([...expected[what]]);
  });

  it('give the same values after others came and went, also where levels lie half a voxel away from each other', () => {
    const whole = syntheticVolume({ dimensions, field: () => random() });
    const { layout, pyramid, volume } = cutIntoBricks(whole, 3, () => false);
    const levels = layout.levels.map((frame, level) => ({
      ...frame,
      shift: frame.shift.map((n) => n + (level === 0 ? 0 : 0.5)) as unknown as Vector3,
    }));
    const make = (): ResidentBricks => new ResidentBricks(volume, { ...layout, levels }, volume.finer.upload);
    const [direct, detour] = [make(), make()];
    const all = [0, 1].flatMap((level) => listBricks(pyramid, level));
    const some = all.filter(({ level, at: [i, j, k] }) => (i + j + k + level) % 2 === 0);
    for (const brick of some) direct.add(brick, readBrick(pyramid, brick));
    for (const brick of all) detour.add(brick, readBrick(pyramid, brick));
    detour.current(volume);
    for (const brick of all) if (!direct.get(brick)) detour.remove(brick);
    direct.current(volume);
    detour.current(volume);
    expect([detour.count, direct.count > 0]).to.deep.equal([direct.count, true]);
    for (const place of places) expect(detour.storedAt(place)).to.equal(direct.storedAt(place));
  });

  it('say which of them have voxels without data, also in halos, and that their texels of the table change', () => {
    const field = (x: number, y: number, z: number): number => (Math.floor(70 * x) === 32 ? NaN : x + y + z);
    for (const groupSide of [1, 4]) {
      const whole = syntheticVolume({ dimensions, kind: 'float32', field });
      const { pyramid, volume } = cutIntoBricks(whole, 2, ({ at: [i] }) => i !== 1, groupSide);
      const { finer } = volume;
      const [first, next]: Brick[] = [0, 1].map((i) => ({ level: 0, at: [i, 1, 0] }));
      const lacking = (): unknown[] => [finer.get(first), finer.get(next)].map((brick) => brick?.hasNoData);
      // The coarser voxels have means of those with data.
      expect(lacking()).to.deep.equal([false, undefined]);
      const changes = (): number => Math.max(...finer.pages.changesOfLayers, ...finer.pages.changesOfBlocks);
      finer.add(next, readBrick(pyramid, next));
      const before = changes();
      finer.current(volume);
      expect(lacking()).to.deep.equal([true, true]);
      expect(changes(), 'of the table').to.be.above(before);
      finer.remove(next);
      finer.current(volume);
      expect(lacking()).to.deep.equal([false, undefined]);
    }
  });

  it('are complete where all of their neighbours are there', () => {
    const { pyramid, volume } = cutIntoBricks(syntheticVolume({ dimensions }), 2, ({ at: [i] }) => i < 2);
    const { finer } = volume;
    // Of 3 x 3 x 2 bricks.
    expect([0, 1].map((i) => finer.isComplete({ level: 0, at: [i, 1, 0] }))).to.deep.equal([true, false]);
    const gone = { level: 0, at: [1, 2, 1] as const };
    finer.remove(gone);
    expect(finer.isComplete({ level: 0, at: [0, 0, 0] }), 'far from what has changed').to.equal(true);
    finer.add(gone, readBrick(pyramid, gone));
    expect(finer.isComplete({ level: 0, at: [0, 1, 0] }), 'not before the halos are filled').to.equal(false);
    finer.current(volume);
    expect(finer.isComplete({ level: 0, at: [0, 1, 0] })).to.equal(true);
    finer.remove(gone);
    finer.current(volume);
    expect(finer.isComplete({ level: 0, at: [0, 1, 0] }), 'over a corner').to.equal(false);
    expect(finer.isComplete({ level: 0, at: [0, 0, 0] })).to.equal(true);
  });

  it('go, and the next coarser ones show again; slots are used again', () => {
    const whole = syntheticVolume({ dimensions });
    const { layout, pyramid, volume } = cutIntoBricks(whole, 3);
    const { finer } = volume;
    const all = [...finer.bricks];
    const { slots } = finer;
    expect(finer.count)
      .to.equal(slots)
      .and.to.equal(listBricks(pyramid, 0).length + listBricks(pyramid, 1).length);
    expect(finer.grid.dimensions[0]).to.equal(72); // Of the volume's unit cube: it reaches two voxels beyond the finest level.
    for (const brick of all) if (brick.level === 0) finer.remove(brick);
    expect(finer.levelOf(0)).to.equal(1);
    expect(finer.grid.dimensions[0]).to.equal(36);
    for (const brick of all) finer.remove(brick);
    expect([finer.levelOf(0), finer.count]).to.deep.equal([2, 0]);
    expect(finer.storedAt([0.3, 0.3, 0.3])).to.equal(
      interpolate(volume.samples, volume.grid.dimensions, [0.3, 0.3, 0.3]),
    );
    expect(finer.grid.dimensions).to.deep.equal(volume.grid.dimensions);
    const brick: Brick = { level: 0, at: [0, 0, 0] };
    const again = finer.add(brick, readBrick(pyramid, brick));
    expect(again.slot).to.be.below(slots);
    expect([finer.slots, finer.levelOf(0), finer.levelOf(1)]).to.deep.equal([slots, 0, 2]);
    finer.add({ level: 1, at: [0, 0, 0] }, readBrick(pyramid, { level: 1, at: [0, 0, 0] }));
    expect([finer.levelOf(0), finer.levelOf(1)], 'a coarser one does not hide a finer one').to.deep.equal([0, 1]);
    expect(layout.cells).to.deep.equal([3, 3, 2]);
  });
});

describe('bricks that come and go', () => {
  const whole = syntheticVolume({ dimensions: [300, 170, 90] });
  for (const groupSide of [1, 4, 8])
    it(`are shown where no finer ones are, in groups of ${groupSide} cells`, () => {
      const { layout, pyramid, volume } = cutIntoBricks(whole, 4, () => false, groupSide);
      const { finer } = volume;
      const [cx, cy, cz] = layout.cells;
      const all = [0, 1, 2].flatMap((level) => listBricks(pyramid, level));
      const there = new Map<string, Brick>();
      const some = randomNumbers(11);
      const texels = new Set<number>();
      for (let n = 0; n < 300; n++) {
        const brick = all[Math.floor(some() * all.length)];
        if (there.delete(keyOfBrick(brick))) finer.remove(brick);
        else {
          there.set(keyOfBrick(brick), brick);
          finer.add(brick, readBrick(pyramid, brick));
        }
        if (n % 10 !== 0) continue;
        for (let k = 0, cell = 0; k < cz; k++)
          for (let j = 0; j < cy; j++)
            for (let i = 0; i < cx; i++, cell++) {
              const at = (level: number): Brick => ({ level, at: brickOfCell(layout.levels[level], [i, j, k]) });
              const shown = [0, 1, 2].filter((level) => there.has(keyOfBrick(at(level))));
              expect(finer.levelOf(cell)).to.equal(shown[0] ?? 3);
              expect(finer.levelWithout(cell)).to.equal(shown[1] ?? 3);
              expect(finer.inSlot(finer.slotOf(cell))?.at).to.deep.equal(
                shown.length > 0 ? at(shown[0]).at : undefined,
              );
            }
        texels.add(finer.pages.blockCount);
      }
      const { groups, blockCount } = finer.pages;
      expect(Math.max(...texels)).to.be.at.most(groups[0] * groups[1] * groups[2]);
      for (const brick of there.values()) finer.remove(brick);
      expect(
        [...finer.pages.directory].every((page) => page === 0),
        'all cells are one again',
      ).to.equal(true);
      expect(blockCount > 0).to.equal(groupSide > 1);
    });

  it('share texels where they show one brick, also at the end of the grid', () => {
    const { layout, pyramid, volume } = cutIntoBricks(whole, 4, ({ level }) => level === 2, 4);
    expect(layout.cells).to.deep.equal([10, 6, 3]);
    // A brick of level 2 has 4 x 4 x 4 cells, and the last ones have fewer.
    expect([volume.finer.pages.blockCount, volume.finer.count]).to.deep.equal([0, 6]);
    volume.finer.add({ level: 0, at: [9, 5, 2] }, readBrick(pyramid, { level: 0, at: [9, 5, 2] }));
    expect(volume.finer.pages.blockCount).to.equal(1);
  });

  it('make a table that stays small, however many cells there are', () => {
    for (const [cells, most] of [
      [[2, 2, 2], 8],
      [[64, 64, 64], 2 ** 16],
      [[128, 96, 80], 2 ** 16],
      [[512, 512, 256], 2 ** 20],
      [[2048, 2048, 64], 2 ** 22],
    ] as const) {
      const side = chooseGroupSide(cells);
      const texels = cells.reduce((product, n) => product * Math.ceil(n / side), 1);
      expect(texels + 100 * (side === 1 ? 0 : side ** 3), String(cells)).to.be.at.most(most);
    }
  });
});

describe('the layout of bricks', () => {
  it('says how often voxels are twice as long along each axis, and null where another factor is among them', () => {
    const levelOf = (scale: Vector3): LevelFrame => ({
      dimensions: scale,
      bricks: [1, 1, 1],
      factors: [1, 1, 1],
      scale,
      shift: [0, 0, 0],
    });
    const of = (volume: Vector3, ...levels: Vector3[]): unknown => halvingsOf({ levels: levels.map(levelOf) }, volume);
    expect(of([16, 8, 32], [64, 64, 32], [32, 32, 32])).to.deep.equal([
      [0, 0, 0],
      [1, 1, 0],
      [2, 3, 0],
    ]);
    // A level of a third, and one whose voxels are a little longer: 252 voxels end a hundredth of a voxel elsewhere.
    expect(of([16, 16, 16], [96, 96, 96], [32, 32, 32])).to.equal(null);
    expect(of([252.01, 126, 126], [504, 252, 252])).to.equal(null);
    expect(of([252.0005, 126, 126], [504, 252, 252])).to.deep.equal([
      [0, 0, 0],
      [1, 1, 1],
    ]);
    expect(of([64, 64, 64], [32, 32, 32]), 'a volume with shorter voxels').to.equal(null);
    expect(of([1, 1, 1], [2 ** 16, 2 ** 16, 2 ** 16]), 'more than 4 bits').to.equal(null);
  });

  it('is null where a level lies askew', () => {
    const grid = cartesianGrid([32, 32, 32], identity);
    const fine = cartesianGrid([64, 64, 64], [0.5, 0, 0, -0.25, 0, 0.5, 0, -0.25, 0, 0, 0.5, -0.25, 0, 0, 0, 1]);
    const level = { ...fine, bricks: [2, 2, 2], factors: [1, 1, 1] } as const;
    expect(layBricks(grid, [level])?.levels[0]).to.deep.include({ scale: [64, 64, 64], shift: [0, 0, 0] });
    const turned = [0, 0.5, 0, -0.25, 0.5, 0, 0, -0.25, 0, 0, 0.5, -0.25, 0, 0, 0, 1];
    expect(layBricks(grid, [{ ...level, indexToWorld: turned }])).to.equal(null);
    expect(layBricks(grid, [])).to.equal(null);
    const many = (levels: number): unknown =>
      layBricks(
        grid,
        Array.from({ length: levels }, () => level),
      );
    expect([many(mostLevels) === null, many(mostLevels + 1)]).to.deep.equal([false, null]);
  });

  it('has room for the volume with its halo, and for slots that do not overlap', () => {
    const longest = 2048 - 4 - slotSide;
    expect([atlasEdge([2044, 20, 20]), atlasEdge([20, 2044, 20]), atlasEdge([20, 20, longest])]).to.deep.equal([
      2048, 2048, 2048,
    ]);
    expect(atlasEdge([20, 20, longest + 1])).to.be.above(2048);
    for (const size of [
      [20, 20, 20],
      [600, 300, 7],
      [2044, 5, 5],
    ] as const) {
      const shape = shapeAtlas(size);
      const places = Array.from({ length: 2 * shape.slotsOfLayer }, (_, slot) => placeOfSlot(shape, slot));
      expect(new Set(places.map(String)).size).to.equal(places.length);
      for (const [x, y, z] of places)
        expect([x + slotSide <= shape.width, y + slotSide <= shape.height, z >= size[2] + 4]).to.deep.equal([
          true,
          true,
          true,
        ]);
    }
  });

  it('has whole layers of slots within the bytes that it may take, and none where the volume and the table need them', () => {
    const shape = shapeAtlas([96, 96, 80], 7000);
    const { width, height, depth, slotsOfLayer } = shape;
    const { layout } = cutIntoBricks(syntheticVolume({ dimensions: [192, 192, 160] }), 2, () => false);
    expect([layout.cells, layout.groupSide]).to.deep.equal([[6, 6, 5], 1]);
    // Groups of 4 cells: 2 x 2 x 2 of them, and eight blocks, which fit one layer of 16 x 16 texels.
    for (const [groupSide, ofTable] of [
      [1, 16 * 180],
      [4, 16 * 16 * 16 * (2 + 4)],
    ]) {
      const bytesFor = (layers: number): number => 2 * width * height * (depth + 36 * layers) + ofTable;
      const found = [bytesFor(0) - 1, bytesFor(0), bytesFor(1) - 1, bytesFor(1), bytesFor(3) + 1, 0];
      const slots = found.map((bytes) => slotsWithin(bytes, shape, { ...layout, groupSide }, 2) / slotsOfLayer);
      expect(slots).to.deep.equal([0, 0, 0, 1, 3, 0]);
    }
  });

  it('is no wider than the volume where few slots are needed, and holds as many as are asked for', () => {
    const bytes = ({ width, height, depth, slotsOfLayer }: AtlasShape, slots: number): number =>
      width * height * (depth + slotSide * Math.ceil(slots / slotsOfLayer));
    const small = shapeAtlas([64, 64, 64], 3);
    expect([small.width, small.height]).to.deep.equal([72, 72]);
    expect(bytes(small, 3)).to.be.below(540_000);
    for (const [size, slots] of [
      [[256, 256, 256], 6400],
      [[128, 200, 30], 6800],
      [[20, 20, 20], 1],
      [[64, 64, 64], 3000],
    ] as const) {
      const shape = shapeAtlas(size, slots);
      expect(shape.depth + slotSide * Math.ceil(slots / shape.slotsOfLayer)).to.be.at.most(2048);
      const [nx, ny, nz] = size;
      // What is lost next to the volume, and next to the slots.
      expect(bytes(shape, slots) / ((nx + 2) * (ny + 2) * (nz + 2) + slots * slotSide ** 3)).to.be.below(1.36);
    }
  });

  it('move into fewer slots, and give the same values there', () => {
    const { pyramid, volume } = cutIntoBricks(syntheticVolume({ dimensions }), 3, ({ level }) => level === 0);
    const { finer } = volume;
    const all = [...finer.bricks];
    for (const brick of all.slice(0, 12)) finer.remove(brick);
    const before = places.map((place) => finer.storedAt(place));
    finer.fit(all.length - 12);
    expect([finer.slots, finer.count]).to.deep.equal([all.length - 12, all.length - 12]);
    expect(places.map((place) => finer.storedAt(place))).to.deep.equal(before);
    expect([...finer.bricks].every((brick) => finer.inSlot(brick.slot) === brick)).to.equal(true);
    finer.remove(all[15]);
    expect(finer.add(all[0], readBrick(pyramid, all[0])).slot).to.be.below(all.length - 12);
  });

  it('are another volume for who reads its cells, only when these have changed', () => {
    const { pyramid, volume } = cutIntoBricks(syntheticVolume({ dimensions, field: () => random() }), 2, () => false);
    const { finer } = volume;
    const first = finer.current(volume);
    expect(finer.current(volume)).to.equal(first);
    const brick: Brick = { level: 0, at: [0, 0, 0] };
    finer.add(brick, readBrick(pyramid, brick));
    const second = finer.current(volume);
    expect(second).not.to.equal(first);
    finer.remove(brick);
    finer.add(brick, readBrick(pyramid, brick));
    expect(finer.current(volume)).to.equal(second);
  });

  it('are a volume with the smallest and the largest value of all that came: its own voxels are means', () => {
    const whole = syntheticVolume({
      dimensions: [64, 64, 64],
      slope: 200,
      intercept: -20,
      field: (x, y, z) => (x + y + z < 0.05 ? 1 : x > 0.99 && y > 0.99 && z > 0.99 ? 0 : 0.4),
    });
    const { pyramid, volume } = cutIntoBricks(whole, 2, () => false);
    const pinned = { ...volume, range: [50, 70] as const };
    const { finer } = volume;
    expect(finer.current(pinned).range).to.deep.equal([50, 70]);
    for (const at of [
      [0, 0, 0],
      [1, 1, 1],
    ] as const)
      finer.add({ level: 0, at }, readBrick(pyramid, { level: 0, at }));
    expect(finer.current(pinned).range[0]).to.be.closeTo(-20, 1e-9);
    expect(finer.current(pinned).range[1]).to.be.closeTo(180, 1e-9);
    finer.remove({ level: 0, at: [0, 0, 0] });
    expect(finer.current(pinned).range[1]).to.be.closeTo(180, 1e-9);
  });

  it('give the value of the nearest voxel', () => {
    const whole = syntheticVolume({ dimensions: [64, 64, 64], field: () => random() });
    const { finer } = cutIntoBricks(whole, 2, ({ at: [i] }) => i === 0).volume;
    for (const [x, y, z] of places.slice(0, 200)) {
      const [i, j, k] = [x, y, z].map((n) => Math.floor(n * 64));
      expect(finer.nearestAt([x, y, z])).to.equal(x < 0.5 ? whole.samples[i + 64 * (j + 64 * k)] : undefined);
    }
  });
});
