// What bricks over a volume hide, learnt from those that have come; and the order of the next ones.
import { expect } from '@esm-bundle/chai';
import { seekDetail } from '../../../src/bricks/estimate-detail.ts';
import { listBricks } from '../../../src/bricks/pyramid.ts';
import type { Brick } from '../../../src/bricks/pyramid.ts';
import { BrickGains, probeBricks } from '../../../src/bricks/rank-bricks.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { setUpRays } from '../../../src/optics/rays/rays.ts';
import { ResidentDetail } from '../../../src/bricks/resident-detail.ts';
import { keyOfBrick } from '../../../src/bricks/resident-bricks.ts';
import { measureResiduals } from '../../../src/bricks/residuals.ts';
import { sumSpans } from '../../../src/bricks/span-sums.ts';
import { atOnce } from '../../../src/core/waiting.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { holdsBrick } from '../../../src/bricks/hidden-values.ts';
import { cutIntoBricks, readBrick } from '../../helpers/bricks.ts';
import type { Bricked } from '../../helpers/bricks.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

const edge = 128;
const camera = orbitCamera({ theta: 0.4, phi: 1.3, radius: 400 }, [0, 0, 0], 0.6);

/** Noise where x is small, else smooth; levels of 128, 64 and 32 voxels. */
function makeRough() {
  const random = randomNumbers(4);
  const whole = syntheticVolume({
    dimensions: [edge, edge, edge],
    kind: 'float32',
    field: (x, y) => (x < 0.5 ? random() : 0.5 + 0.2 * Math.sin(3 * y)),
  });
  const made = cutIntoBricks(whole, 3, () => false);
  const detail = new ResidentDetail(made.volume.finer.volume, made.volume.finer);
  const add = (brick: Brick): void => {
    const samples = readBrick(made.pyramid, brick);
    detail.measure(brick, samples);
    made.volume.finer.add(brick, samples);
  };
  return { ...made, bricks: made.volume.finer, detail, add, table: measureResiduals(made.pyramid, 32) };
}

/** The same, with what its writer would say. */
function makeWritten() {
  const { detail, add, table, bricks: _, ...bricked } = makeRough();
  return { detail, add, table, bricked };
}

function probesOf({ layout, volume }: Pick<Bricked, 'layout' | 'volume'>, detail: ResidentDetail): Brick[] {
  const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(0.6, 1, 1, 2))!;
  return probeBricks(layout, rays, (brick) => detail.isMeasured(brick));
}

describe('what bricks hide', () => {
  it('is more where the volume that is always there is rough, before any brick has come', () => {
    const { detail } = makeRough();
    detail.update();
    const [rough, smooth] = [0.2, 0.8].map((x) => detail.rms(detail.blockAt(x, 0.4, 0.4), 2));
    expect(rough).to.be.above(3 * smooth);
    expect(detail.max(detail.blockAt(0.2, 0.4, 0.4), 2)).to.be.above(rough);
  });

  it('is known within a factor of 1.6 where bricks have come elsewhere', () => {
    const { detail, add, table, pyramid } = makeRough();
    // Half of the next finer level, and one brick of the finest.
    for (const brick of listBricks(pyramid, 1)) if (brick.at[1] === 0) add(brick);
    add({ level: 0, at: [0, 0, 0] });
    detail.update();
    const block = (at: readonly number[]): number => at[0] + 4 * (at[1] + 4 * at[2]);
    // With a brick of level 1, and with none.
    const first = detail.rms(detail.blockAt(0.3, 0.3, 0.3), 1);
    // The table has what differs at the voxels; rays go between them, where noise has less: each axis has 2/3 of its variance.
    const between = Math.sqrt((2 / 3) ** 3);
    expect(first / (between * table.levels[1].rms[block([1, 1, 1])])).to.be.within(1 / 1.6, 1.6);
    const second = detail.rms(detail.blockAt(0.3, 0.8, 0.3), 2);
    expect(second / (between * table.levels[2].rms[block([1, 3, 1])])).to.be.within(1 / 1.6, 1.6);
  });

  it('is more in the rough part of a brick than in the rest of it', () => {
    const random = randomNumbers(4);
    const whole = syntheticVolume({
      dimensions: [edge, edge, edge],
      kind: 'float32',
      field: (x) => (x < 48 / edge ? random() : 0.5),
    });
    const { volume, pyramid } = cutIntoBricks(whole, 2, () => false);
    const detail = new ResidentDetail(volume.finer.volume, volume.finer);
    const brick: Brick = { level: 0, at: [1, 1, 1] }; // Voxels 32 to 64, of which a half is noise.
    detail.measure(brick, readBrick(pyramid, brick));
    detail.update();
    const at = (voxel: number): number => detail.rms(detail.blockAt(voxel / edge, 0.4, 0.4), 1);
    expect(at(36) / at(60)).to.be.above(2);
    const table = measureResiduals(pyramid, 16).levels[1].rms;
    const between = Math.sqrt((2 / 3) ** 3);
    expect(at(36) / (between * table[2 + 8 * (3 + 8 * 3)])).to.be.within(1 / 1.5, 1.5);
  });

  it('keeps no more than 64 probes, however many a view that never rests asks for', () => {
    const { detail, pyramid } = makeRough();
    const all = [0, 1].flatMap((level) => listBricks(pyramid, level));
    expect(all.length).to.equal(72);
    for (const brick of all) detail.measure(brick, readBrick(pyramid, brick), true);
    expect(detail.probes).to.equal(64);
    detail.forgetProbes();
    expect(detail.probes).to.equal(0);
  });

  it('has the peaks of bricks that have come elsewhere: single bright voxels are expected in others too', () => {
    const random = randomNumbers(9);
    const whole = syntheticVolume({ dimensions: [edge, edge, edge], field: () => (random() < 0.001 ? 1 : 0.1) });
    const { volume, pyramid } = cutIntoBricks(whole, 3, () => false);
    const detail = new ResidentDetail(volume.finer.volume, volume.finer);
    const reach = (): number => detail.max(detail.blockAt(0.9, 0.9, 0.9), 2);
    detail.update();
    expect(reach()).to.be.below(60);
    const known = { view: viewMatrix(camera), projection: projectionMatrix(0.6, 1, 1, 2) };
    const rays = setUpRays(volume.grid, known.view, known.projection)!;
    for (const level of [1, 0]) {
      const probes = probeBricks(volume.finer.layout, rays, (brick) => detail.isMeasured(brick));
      expect([probes.length > 3, new Set(probes.map((brick) => brick.level))]).to.deep.equal([true, new Set([level])]);
      for (const brick of probes) detail.measure(brick, readBrick(pyramid, brick));
    }
    expect(probeBricks(volume.finer.layout, rays, (brick) => detail.isMeasured(brick))).to.deep.equal([]);
    detail.update();
    expect(reach()).to.be.above(150);
  });

  it('is still known where bricks were looked at and have gone; also of the octaves around them', () => {
    const { detail, add, bricks } = makeRough();
    const hides = (level: number): number => detail.rms(detail.blockAt(0.6, 0.1, 0.1), level);
    add({ level: 1, at: [1, 0, 0] });
    add({ level: 0, at: [2, 0, 0] });
    detail.update();
    const [one, two] = [hides(1), hides(2)];
    expect(two).to.be.above(one);
    for (const brick of [...bricks.bricks]) bricks.remove(brick);
    detail.update();
    expect([hides(1), hides(2)]).to.deep.equal([one, two]);
    // Another brick of the finest level there was not looked at: the coarser octave is the measured one, as this is smooth.
    expect(detail.rms(detail.blockAt(0.9, 0.1, 0.1), 2)).to.be.within(0.4 * two, 2.5 * two);
  });

  it('makes a brick worth about what it brings once it has gone, also where nothing but the coarsest level lies below it', () => {
    const { detail, add, bricks, volume, pyramid } = makeRough();
    for (const brick of listBricks(pyramid, 1)) if (brick.at[2] === 0) add(brick);
    for (const brick of listBricks(pyramid, 0)) if (brick.at[2] > 1 && brick.at[0] < 2) add(brick);
    const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(0.6, 1, 1, 2))!;
    const estimate = (): BrickGains => {
      detail.update();
      const gains = new BrickGains(bricks);
      const transferFunction = parseTransferFunction('0 black 0%, 1 white 60%', [0, 1]);
      const sums = sumSpans(transferFunction, detail.range, { slope: 1, intercept: 0, stepRatio: 0.01 });
      atOnce(seekDetail({ field: detail, rays, sums, step: 1 / 128, hidden: detail, across: 24 }, gains));
      return gains;
    };
    const before = estimate();
    const all = [...bricks.bricks];
    const worths = all.map((brick) => before.worth(brick));
    const most = Math.max(...worths);
    let compared = 0;
    for (const [n, brick] of all.entries()) {
      if (n % 2 > 0) continue;
      bricks.remove(brick);
      const gain = estimate()
        .rank(10_000, 1, (other) => keyOfBrick(other) !== keyOfBrick(brick))
        .reduce((sum, { gain: one }) => sum + one, 0);
      bricks.add(brick, brick);
      if (Math.max(gain, worths[n]) < most / 20) continue;
      compared++;
      expect(worths[n] / gain, keyOfBrick(brick)).to.be.within(0.4, 2.5);
    }
    expect(compared).to.be.above(8);
  });

  it('is nothing where a brick of the finest level is there; the range of values is that of all', () => {
    const { detail, add } = makeRough();
    const [low, high] = detail.range;
    add({ level: 0, at: [0, 0, 0] });
    detail.update();
    expect(detail.levelOf(detail.cellAt(0.1, 0.1, 0.1))).to.equal(0);
    expect(detail.range[0]).to.be.below(low);
    expect(detail.range[1]).to.be.above(high);
  });
});

describe('what bricks hide, by the table of their writer', () => {
  it('is what the table says of each block and level, with its values; no brick has to come first', () => {
    const { detail, table: written, bricked } = makeWritten();
    const table = { ...written, along: undefined };
    detail.take(table, [0, 1, 2]);
    detail.update();
    expect(probesOf(bricked, detail)).to.deep.equal([]);
    // Blocks of 32 voxels: 4 along each axis.
    for (const at of [
      [0, 0, 0],
      [3, 1, 2],
      [2, 3, 3],
    ]) {
      const block = at[0] + 4 * (at[1] + 4 * at[2]);
      const [x, y, z] = at.map((n) => (n + 0.5) / 4);
      const found = detail.blockAt(x, y, z);
      for (const level of [1, 2]) {
        // Between voxels there is less, as far as is known.
        expect(detail.rms(found, level)).to.be.closeTo(0.85 * table.levels[level].rms[block], 1e-12);
        expect(detail.max(found, level)).to.equal(table.levels[level].max[block]);
      }
      expect([detail.low(found), detail.high(found)]).to.deep.equal([table.low[block], table.high[block]]);
    }
    expect(detail.range[1]).to.equal(Math.max(...table.high));
  });

  it('counts for a file of more levels than bricks have, too', () => {
    const { detail, table } = makeWritten();
    const more = {
      ...table,
      along: undefined,
      levels: [table.levels[0], table.levels[1], table.levels[1], table.levels[2]],
    };
    detail.take(more, [0, 1, 3]);
    const block = detail.blockAt(0.9, 0.1, 0.1);
    detail.update();
    expect(detail.rms(block, 2)).to.be.closeTo(0.85 * table.levels[2].rms[3], 1e-12);
  });

  it('goes together, and is less between voxels, as the table says: two thirds of the variance of noise along each axis', () => {
    const { detail, table } = makeWritten();
    expect(table.along![1]).to.be.below(0.25);
    const ofMost = (0.8 - 0.25) / (1 - 0.25);
    for (const [along, share, together] of [
      [0.25, (2 / 3) ** 1.5, 5 / 3],
      [1, (2 / 3) ** 1.5 + (1 - (2 / 3) ** 1.5) * ofMost, 9],
    ]) {
      detail.take({ ...table, along: [0, along, 0.25] }, [0, 1, 2]);
      detail.update();
      const block = detail.blockAt(0.1, 0.1, 0.1);
      expect(detail.rms(block, 1)).to.be.closeTo(share * table.levels[1].rms[0], 1e-9);
      expect(detail.correlation(1)).to.be.closeTo(together, 1e-9);
      expect(detail.correlation(2)).to.be.closeTo(2 * (5 / 3), 1e-9);
    }
  });

  it('is less between voxels where bricks show that it is noise: two thirds of the variance along each axis', () => {
    const { detail, table, add } = makeWritten();
    detail.take({ ...table, along: undefined }, [0, 1, 2]);
    add({ level: 0, at: [0, 0, 0] });
    add({ level: 0, at: [1, 3, 2] });
    detail.update();
    const block = detail.blockAt(0.1, 0.1, 0.1);
    expect(detail.rms(block, 1) / table.levels[1].rms[0]).to.be.closeTo((2 / 3) ** 1.5, 0.05);
  });

  it('counts until a brick has values that the table does not have: one that was there before it, or comes later', () => {
    for (const isThere of [true, false]) {
      const { detail, table, bricked, add } = makeWritten();
      const brick = { level: 0, at: [1, 1, 1] } as const;
      if (isThere) add(brick);
      const high = table.high.slice();
      high[1 + 4 * (1 + 4)] -= 0.1;
      detail.take({ ...table, high }, [0, 1, 2]);
      if (!isThere) {
        expect(probesOf(bricked, detail)).to.deep.equal([]);
        add(brick);
      }
      expect(probesOf(bricked, detail)).to.have.length.above(0);
    }
  });

  it('holds each brick of each level of the volume that it was made of', () => {
    const { table, bricked } = makeWritten();
    for (const level of [0, 1])
      for (const brick of listBricks(bricked.pyramid, level))
        expect(holdsBrick(table, bricked.layout, brick, readBrick(bricked.pyramid, brick))).to.equal(true);
  });
});

describe('bricks in the order of what they bring', () => {
  it('are those of the largest sum; none covers what another one covers, and those left out are none', () => {
    const { volume } = makeRough();
    const gains = new BrickGains(volume.finer);
    // Cells 0 and 1 are in the same brick of level 1, cell 3 in another one.
    gains.gain(0, 0, 5);
    gains.gain(0, 1, 3);
    gains.gain(1, 1, 3);
    gains.gain(3, 0, 4);
    gains.gain(3, 1, 1);
    const keys = (isLeftOut: (brick: Brick) => boolean): string[] =>
      gains.rank(10, 1000, isLeftOut).map(({ brick }) => keyOfBrick(brick));
    expect(keys(() => false)).to.deep.equal(['1/0/0/0', '0/3/0/0']);
    expect(keys(({ level }) => level === 1)).to.deep.equal(['0/0/0/0', '0/3/0/0']);
    expect(gains.rank(1, 1000, () => false)).to.deep.equal([
      { brick: { level: 1, at: [0, 0, 0] }, gain: 6, bytes: 1000 },
    ]);
  });

  it('are worth what the picture would lose', () => {
    const { volume, add } = makeRough();
    add({ level: 0, at: [0, 0, 0] });
    add({ level: 0, at: [3, 0, 0] });
    const gains = new BrickGains(volume.finer);
    gains.loss(3, 2);
    gains.loss(3, 1);
    gains.loss(5, 9);
    expect([...volume.finer.bricks].map((brick) => gains.worth(brick))).to.deep.equal([0, 3]);
  });
});
