// Bricks that panes and picks read: which ones, in which order, and when they are let go of.
import { expect } from '@esm-bundle/chai';
import type { BrickSamples } from '../../../../src/bricks/brick-data.ts';
import type { Brick } from '../../../../src/bricks/pyramid.ts';
import { keyOfBrick } from '../../../../src/bricks/resident-bricks.ts';
import type { ViewedPlane } from '../../../../src/volume/finer-voxels.ts';
import { transformDirection, transformPoint } from '../../../../src/volume/matrix.ts';
import { BrickTiles } from '../../../../src/viewer/loading/brick-tiles.ts';
import { listBricks } from '../../../../src/bricks/pyramid.ts';
import { cutIntoBricks, gridOf, readBrick } from '../../../helpers/bricks.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const edge = 192;
const random = randomNumbers(8);
const whole = syntheticVolume({ dimensions: [edge, edge, edge], field: () => random() });

/** The plane through all voxels of an index k, one pixel a voxel. */
function planeAt(k: number, size = edge): ViewedPlane {
  const m = whole.grid.indexToWorld;
  return {
    width: size,
    height: size,
    first: transformPoint(m, [0, 0, k]),
    across: transformDirection(m, [1, 0, 0]),
    down: transformDirection(m, [0, 1, 0]),
    way: [0, 0, 0],
    isNearest: true,
  };
}

interface Asked {
  readonly key: string;
  readonly signal: AbortSignal;
  give(): Promise<void>;
  fail(): Promise<void>;
}

function makeTiles() {
  const made = cutIntoBricks(whole, 3, () => false);
  const levels = made.layout.levels.map((frame, level) => ({ ...gridOf(whole, made.pyramid, level), ...frame }));
  const asked: Asked[] = [];
  const failures: unknown[] = [];
  const tiles = new BrickTiles({
    volume: made.volume,
    levels,
    bricks: made.volume.finer,
    read: (brick: Brick, signal) =>
      new Promise<BrickSamples>((resolve, reject) => {
        const settled = () => new Promise<void>((done) => setTimeout(done));
        asked.push({
          key: keyOfBrick(brick),
          signal,
          give: () => (resolve(readBrick(made.pyramid, brick, false)), settled()),
          fail: () => (reject(new Error('gone')), settled()),
        });
        signal.addEventListener('abort', () => reject(signal.reason as Error));
      }),
    failed: (error) => failures.push(error),
  });
  made.volume.finer.planes = tiles;
  return { ...made, tiles, asked, failures };
}

const [pane, one, other] = [{}, {}, {}];

const isOver = async (done: Promise<void>): Promise<boolean> =>
  Promise.race([done.then(() => true), new Promise<boolean>((r) => setTimeout(() => r(false), 5))]);

describe('bricks for panes', () => {
  it('come 8 at once, the middle first; the pane has their values, and waits until all are there', async () => {
    const { tiles, asked } = makeTiles();
    let paints = 0;
    const plane = planeAt(40);
    const { sampleAt, planes, done } = tiles.open(pane, plane, () => paints++)!;
    expect([asked.length, planes]).to.deep.equal([8, 1]);
    expect(asked[0].key).to.match(/^0\/[23]\/[23]\/1$/);
    const coarse = sampleAt(100, 90, 40);
    for (let n = 0; n < asked.length; n++) await asked[n].give();
    // 6 x 6 bricks.
    expect(asked).to.have.length(36);
    expect(new Set(asked.map(({ key }) => key))).to.have.property('size', 36);
    await done;
    expect(paints).to.be.at.least(1);
    const again = tiles.open(pane, plane, () => {})!;
    expect(await isOver(again.done)).to.equal(true);
    const at = 100 + edge * (90 + edge * 40);
    expect(again.sampleAt(100, 90, 40)).to.equal(whole.samples[at]);
    expect(coarse).not.to.equal(whole.samples[at]);
    expect(asked).to.have.length(36);
  });

  it('are given up when the pane moves on or closes, and shared by panes that look at the same', async () => {
    const { tiles, asked } = makeTiles();
    tiles.open(one, planeAt(10), () => {});
    tiles.open(other, planeAt(10), () => {});
    expect(asked).to.have.length(8);
    tiles.open(one, planeAt(80), () => {});
    expect(asked.filter(({ signal }) => signal.aborted)).to.have.length(0);
    tiles.close(other);
    expect(asked.slice(0, 8).every(({ signal }) => signal.aborted)).to.equal(true);
    await new Promise((resolve) => setTimeout(resolve));
    expect(asked.filter(({ signal }) => !signal.aborted).map(({ key }) => key.split('/').at(-1))).to.deep.equal(
      Array(8).fill('2'),
    );
    tiles.close(one);
    expect([tiles.requests, asked.every(({ signal }) => signal.aborted)]).to.deep.equal([0, true]);
  });

  it('that fail are asked for once; the pane goes on with the others, and does not wait for them', async () => {
    const { tiles, asked, failures } = makeTiles();
    const { done } = tiles.open(pane, planeAt(40), () => {})!;
    await asked[0].fail();
    for (let n = 1; n < asked.length; n++) await asked[n].give();
    await done;
    expect([asked.length, failures.length]).to.deep.equal([36, 1]);
    expect(await isOver(tiles.open(pane, planeAt(40), () => {})!.done)).to.equal(true);
    expect(asked).to.have.length(36);
  });

  it('that are on the GPU are not read again if their neighbours are there, too; nobody waits when the view rests', async () => {
    const { tiles, asked, volume, pyramid } = makeTiles();
    for (const brick of listBricks(pyramid, 0).filter(({ at: [, j] }) => j >= 2 && j <= 4))
      volume.finer.add(brick, readBrick(pyramid, brick));
    volume.finer.current(volume);
    const { done } = tiles.open(pane, planeAt(40), () => {})!;
    const rows = new Set(asked.map(({ key }) => key.split('/')[2]));
    expect([rows.has('3'), rows.has('2'), rows.has('4')]).to.deep.equal([false, true, true]);
    expect(await isOver(done)).to.equal(false);
    tiles.rest();
    expect(await isOver(done)).to.equal(true);
    // Nor does who comes later, until the view shows the volume again.
    expect(await isOver(tiles.open(other, planeAt(70), () => {})!.done)).to.equal(true);
    await tiles.readAt([0.9, 0.9, 0.9]);
    tiles.wake();
    expect(await isOver(tiles.open(one, planeAt(100), () => {})!.done)).to.equal(false);
  });

  it('that nobody looks at go when there are more than 64 MiB', async function () {
    this.timeout(60_000);
    const large = cutIntoBricks(
      syntheticVolume({ dimensions: [32 * 24, 32 * 24, 70], kind: 'float32', field: (x) => x }),
      2,
      () => false,
    );
    const levels = large.layout.levels.map((frame) => ({
      ...frame,
      ...large.layout.finest,
      dimensions: frame.dimensions,
    }));
    let reads = 0;
    const tiles = new BrickTiles({
      volume: large.volume,
      levels: [{ ...levels[0], indexToWorld: large.layout.finest.indexToWorld }],
      bricks: large.volume.finer,
      read: async () => {
        reads++;
        return { samples: new Float32Array(36 ** 3), low: 0, high: 1, hasNoData: false };
      },
      failed: () => {},
    });
    // 187 kB each: 359 fit, and a plane may have 179.
    for (let n = 0; n < 576; n++)
      await tiles.readAt([(32 * (n % 24) + 5) / 768, (32 * Math.floor(n / 24) + 5) / 768, 0.1]);
    expect(reads).to.equal(576);
    let kept = 0;
    for (let n = 0; n < 576; n++)
      kept += Number(tiles.samplesOf({ level: 0, at: [n % 24, Math.floor(n / 24), 0] }) !== undefined);
    expect(kept).to.be.within(330, 360);
    expect(tiles.samplesOf({ level: 0, at: [23, 23, 0] })).not.to.equal(undefined);
    expect(tiles.samplesOf({ level: 0, at: [0, 0, 0] })).to.equal(undefined);
  });

  it('are read where somebody picks: the value is that of the finest voxel', async () => {
    const { tiles, asked, volume } = makeTiles();
    const place = [100.5 / edge, 90.5 / edge, 40.5 / edge] as const;
    expect(volume.finer.nearestAt(place)).to.equal(undefined);
    const reading = tiles.readAt(place);
    expect(asked.map(({ key }) => key)).to.deep.equal(['0/3/2/1']);
    await asked[0].give();
    await reading;
    expect(volume.finer.nearestAt(place)).to.equal(whole.samples[100 + edge * (90 + edge * 40)]);
  });
});
