// Which bricks a view asks for next, and when it has enough.
import { expect } from '@esm-bundle/chai';
import type { Brick } from '../../../../src/bricks/pyramid.ts';
import { atOnce } from '../../../../src/core/waiting.ts';
import { framingDistance, orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import type { VolumeOptics } from '../../../../src/viewer/model/volume-info.ts';
import { boundingSphere } from '../../../../src/volume/grid.ts';
import { BrickGains, untilEnough } from '../../../../src/bricks/rank-bricks.ts';
import { keyOfBrick } from '../../../../src/bricks/resident-bricks.ts';
import { ResidentDetail } from '../../../../src/bricks/resident-detail.ts';
import { BrickChoice } from '../../../../src/viewer/loading/brick-choice.ts';
import type { ChosenBricks, PictureWish } from '../../../../src/viewer/loading/brick-choice.ts';
import { cutIntoBricks, readBrick } from '../../../helpers/bricks.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';
import { greyOptics } from '../../../helpers/view-settings.ts';

/** Bricks of 64 and 32 voxels over a volume of 32 voxels along each axis; none is there. */
function makeChoice() {
  const whole = syntheticVolume({ dimensions: [128, 128, 128], field: (x) => x });
  const { volume, pyramid } = cutIntoBricks(whole, 3, () => false);
  const bricks = volume.finer;
  const detail = new ResidentDetail(bricks.volume, bricks);
  const choice = new BrickChoice(bricks, detail);
  const wish: PictureWish = { key: 'a', maxError: 2, slots: 100, isAsking: false, isRefused: () => false };
  /** Looks at the same bricks as before. Cells 0 to 19 bring something, the first most. */
  const look = (rms: number, more: Partial<PictureWish> = {}, probes: Brick[] = [], finest = 0): ChosenBricks => {
    const gains = new BrickGains(bricks);
    for (let cell = 0; cell < 20; cell++) gains.gain(cell, 0, 100 - cell);
    const estimate = { probes, gains, finest, energy: 2000, error: { rms, p99: rms, max: null } };
    return choice.choose(estimate, { ...wish, ...more });
  };
  /** Looks at others. */
  const choose: typeof look = (...given) => {
    bricks.changes++;
    return look(...given);
  };
  const measure = (brick: Brick): void => detail.measure(brick, readBrick(pyramid, brick), true);
  return { bricks, choice, choose, look, measure, add: (brick: Brick) => bricks.add(brick, readBrick(pyramid, brick)) };
}

const keysOf = (bricks: readonly Brick[]): string[] => bricks.map(keyOfBrick);

describe('What a view in bricks asks for next', () => {
  it('is what brings most, until the error is small enough; then what is in doubt is looked at, once', () => {
    const { choose, measure } = makeChoice();
    const first = choose(5);
    expect(first.probes).to.deep.equal([]);
    expect(keysOf(first.missing.map(({ brick }) => brick)).slice(0, 3)).to.deep.equal([
      '0/0/0/0',
      '0/1/0/0',
      '0/2/0/0',
    ]);
    const enough = choose(1.5);
    expect(enough.missing).to.deep.equal([]);
    expect(keysOf(enough.probes)).to.deep.equal(['0/0/0/0', '0/1/0/0', '0/2/0/0', '0/3/0/0', '0/0/1/0', '0/1/1/0']);
    for (const brick of enough.probes) measure(brick);
    expect(choose(1.5).probes).to.deep.equal([]);
    // More was needed after all: then others are looked at. Steps have a share of the error.
    expect(choose(1.7).missing).to.have.length.above(0);
    expect(keysOf(choose(1.5).probes)[0]).to.equal('0/2/1/0');
    expect(choose(1.5, { key: 'b' }).probes).to.have.lengthOf(6);
  });

  it('is nothing once two sets of rays together say that the error is small enough; the mean of the last three is stated', () => {
    const { choose, look } = makeChoice();
    choose(1.5); // After this, nothing is in doubt.
    const first = choose(1.5);
    expect([first.again, first.missing.length, first.error.rms]).to.deep.equal([true, 0, 1.5]);
    const second = look(1.3);
    expect([second.again, second.missing.length]).to.deep.equal([false, 0]);
    expect(second.error.rms).to.be.closeTo(Math.sqrt((1.5 ** 2 + 1.3 ** 2) / 2), 1e-12);
    // A ray that holds much: more is asked for.
    expect(look(5).missing).to.have.length.above(0);
    expect(look(0).error.rms).to.be.closeTo(Math.sqrt((1.3 ** 2 + 5 ** 2) / 3), 1e-12);
    expect(choose(0.7).again, 'clearly').to.equal(false);
    expect(choose(1.5, { key: 'other' }).error.rms, 'of another picture').to.equal(1.5);
  });

  it('is no more than brings enough together, but as many as a turn has at least', () => {
    const gains = [8, 4, 2, 1, 1];
    const ranked = gains.map((gain, n) => ({ brick: { level: 0, at: [n, 0, 0] as const }, gain, bytes: 1 }));
    const counts = [0, 8, 9, 14, 15.5, 16, 17].map((needed) => untilEnough(ranked, { needed, least: 2 }).length);
    expect(counts).to.deep.equal([2, 2, 2, 3, 5, 5, 5]);
    expect(untilEnough(ranked, { needed: NaN, least: 1 })).to.deep.equal(ranked);
  });

  it('waits for what the writer of the pyramid says, and leaves out what can not be read', () => {
    const { choice, choose } = makeChoice();
    expect(choose(1, { isAsking: true }).probes).to.deep.equal([]);
    const unknown: Brick = { level: 1, at: [0, 0, 0] };
    expect(choose(5, { isAsking: true }, [unknown]).probes).to.deep.equal([]);
    expect(choose(5, {}, [unknown]).probes).to.deep.equal([unknown]);
    choice.leaveOut({ level: 0, at: [1, 0, 0] });
    const { probes } = choose(1, {}, [{ level: 0, at: [1, 0, 0] }]);
    expect(keysOf(probes)).to.include('0/0/0/0').and.not.include('0/1/0/0');
    const { missing } = choose(5, { isRefused: ({ at }) => at[0] === 0 });
    expect(missing.every(({ brick }) => brick.at[0] > 0)).to.equal(true);
  });

  it('lets go of bricks that are two levels finer than anything in the picture, as where it moved away', () => {
    const { choose, add } = makeChoice();
    add({ level: 0, at: [0, 0, 0] });
    add({ level: 1, at: [1, 1, 1] });
    const tooFine = [0, 1, 2, 3].map((finest) => keysOf(choose(1, {}, [], finest).tooFine));
    expect(tooFine).to.deep.equal([[], [], ['0/0/0/0'], ['0/0/0/0', '1/1/1/1']]);
  });

  it('ends in a full room once exchanges bring little, until the room is another one', () => {
    const { choice, choose, add } = makeChoice();
    add({ level: 0, at: [0, 0, 0] });
    add({ level: 0, at: [1, 0, 0] });
    const full = { slots: 2 };
    expect([choose(9, full).isExchange, choose(6, full).isExchange]).to.deep.equal([false, false]);
    for (let n = 0; n < 2; n++) {
      const { isExchange, missing } = choose(5.9, full);
      expect([isExchange, missing.length > 0]).to.deep.equal([true, true]);
      choice.hasExchanged();
    }
    expect(choose(5.9, full).missing).to.deep.equal([]);
    expect(choose(5.9, { slots: 1 }).missing).to.have.length.above(0);
    expect(choose(5.9, { ...full, key: 'b' }).missing).to.have.length.above(0);
  });

  it('ends in a full room where nothing takes a place; then also what is in doubt is looked at', () => {
    const { choice, choose, add } = makeChoice();
    add({ level: 0, at: [0, 0, 0] });
    const full = { slots: 1 };
    const before = choose(9, full);
    expect([before.missing.length > 0, before.probes.length]).to.deep.equal([true, 0]);
    choice.endExchanges();
    const after = choose(9, full);
    expect([after.missing.length, after.probes.length]).to.deep.equal([0, 6]);
  });
});

describe('What bricks would bring to a picture', () => {
  const random = randomNumbers(3);
  const whole = syntheticVolume({ dimensions: [64, 64, 64], field: () => random(), slope: 255 });
  const { volume } = cutIntoBricks(whole, 2, () => false);
  const { center, radius } = boundingSphere(whole.grid);
  const camera = orbitCamera({ theta: 0.4, phi: 1.3, radius: framingDistance(radius, 0.6, 1) }, center, 0.6);
  const view = { view: viewMatrix(camera), projection: projectionMatrix(0.6, 1, 1, 2) };
  const optics: VolumeOptics = {
    ...greyOptics,
    transferFunction: [
      { value: 0, color: [0, 0, 1], opacity: 0 },
      { value: 255, color: [1, 0.8, 0.5], opacity: 0.2 },
    ],
  };
  const styles = [
    { weight: 1, styles: [{ kind: 'silhouette', retained: 0, boundary: 1, sharpness: 2 }] },
  ] as VolumeOptics['styles'];
  const makeEstimates = (): ((key: string, more?: Partial<VolumeOptics>) => Promise<number>) => {
    const choice = new BrickChoice(volume.finer, new ResidentDetail(volume.finer.volume, volume.finer));
    return async (key, more) => {
      const picture = { key, view, optics: { ...optics, ...more }, pixels: [400, 400] as const };
      return atOnce(await choice.estimate(volume, picture))!.error.rms;
    };
  };

  it('is seen by other rays each time, the same ones for each picture', async () => {
    const estimate = makeEstimates();
    const [first, second] = [await estimate('a'), await estimate('a')];
    expect(first).to.be.above(1);
    expect(second).not.to.equal(first);
    expect(second / first).to.be.within(0.8, 1.25);
    expect(await estimate('b')).to.equal(first);
    expect(await estimate('a')).to.equal(first);
  });

  it('depends on styles, of which the first one loads its code', async () => {
    const estimate = makeEstimates();
    const [plain, styled] = [await estimate('a'), await estimate('b', { styles })];
    expect(styled).to.be.above(0.1);
    expect(Math.abs(styled / plain - 1)).to.be.above(0.1);
  });
});
