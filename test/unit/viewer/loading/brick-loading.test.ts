import { expect } from '@esm-bundle/chai';
import { BrickLoading } from '../../../../src/viewer/loading/brick-loading.ts';
import type { WantedBricks } from '../../../../src/viewer/loading/brick-loading.ts';
import { BrickRoom } from '../../../../src/viewer/loading/brick-room.ts';
import type { SharedRoom } from '../../../../src/viewer/loading/brick-room.ts';
import { listBricks } from '../../../../src/bricks/pyramid.ts';
import type { Brick } from '../../../../src/bricks/pyramid.ts';
import { keyOfBrick } from '../../../../src/bricks/resident-bricks.ts';
import { cutIntoBricks, readBrick } from '../../../helpers/bricks.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const whole = syntheticVolume({ dimensions: [128, 96, 64] });
const bytesOfBrick = 36 ** 3;

/** Has so many bytes. */
function createRoom(bytes: number) {
  const room = new BrickRoom(0);
  return {
    room,
    bytes,
    get share() {
      return room.share;
    },
    enter(changed: () => void) {
      room.enter(changed, this.bytes);
    },
    leave: (changed: () => void) => room.leave(changed),
  };
}

/** A store whose answers wait until the test gives them. */
function createLoading(room: SharedRoom) {
  const { pyramid, volume } = cutIntoBricks(whole, 3, () => false);
  const { finer: bricks } = volume;
  const waiting = new Map<string, { answer: () => void; refuse: () => void }>();
  const log = { asked: [] as string[], failures: 0, changes: 0, grew: 0, most: 0 };
  const loading = new BrickLoading({
    bricks,
    room,
    bytesOfBrick,
    read: (brick, signal) =>
      new Promise((resolve, reject) => {
        const key = keyOfBrick(brick);
        log.asked.push(key);
        const end = (act: () => void) => (): void => {
          waiting.delete(key);
          act();
        };
        waiting.set(key, {
          answer: end(() => resolve(readBrick(pyramid, brick))),
          refuse: end(() => reject(new Error('gone'))),
        });
        signal.addEventListener(
          'abort',
          end(() => reject(signal.reason as Error)),
        );
      }),
    changed: () => {
      log.changes++;
      log.most = Math.max(log.most, bricks.count * bytesOfBrick);
    },
    grew: () => log.grew++,
    failed: () => log.failures++,
  });
  const answerAll = async (): Promise<void> => {
    for (let round = 0; waiting.size > 0; round++) {
      expect(round, 'it comes to rest').to.be.below(100);
      for (const { answer } of [...waiting.values()]) answer();
      await new Promise((resolve) => setTimeout(resolve));
    }
  };
  return { loading, bricks, waiting, log, answerAll, all: listBricks(pyramid, 0) };
}

/** Wants bricks in this order. @param worth - of those that are there */
const inOrder = (bricks: readonly Brick[], worth: (brick: Brick) => number = () => 0): WantedBricks => ({
  missing: bricks.map((brick, n) => ({ brick, gain: (100 - n) * bytesOfBrick, bytes: bytesOfBrick })),
  worth,
});

describe('the loading of bricks', () => {
  it('reads the best ones first, eight at once, until all are there', async () => {
    const { loading, bricks, waiting, log, answerAll, all } = createLoading(createRoom(2 ** 28));
    loading.want(inOrder(all));
    expect(log.asked).to.deep.equal(all.slice(0, 8).map(keyOfBrick));
    waiting.get(log.asked[2])!.answer();
    await new Promise((resolve) => setTimeout(resolve));
    expect(log.asked[8]).to.equal(keyOfBrick(all[8]));
    await answerAll();
    expect([bricks.count, loading.isSettled, log.changes]).to.deep.equal([all.length, true, all.length]);
  });

  it('gives up what a view no longer wants; when closed, nothing is on its way and nothing more comes', async () => {
    const { loading, bricks, waiting, log, answerAll, all } = createLoading(createRoom(2 ** 28));
    loading.want(inOrder(all));
    loading.want(inOrder(all.slice(6, 12)));
    expect([...waiting.keys()]).to.deep.equal(all.slice(6, 12).map(keyOfBrick));
    await answerAll();
    expect(bricks.count).to.equal(6);
    loading.want(inOrder(all));
    expect(loading.requests).to.equal(8);
    loading.close();
    expect([waiting.size, loading.requests, bricks.count, log.failures]).to.deep.equal([0, 0, 6, 0]);
    loading.want(inOrder(all));
    await new Promise((resolve) => setTimeout(resolve));
    expect([waiting.size, bricks.count]).to.deep.equal([0, 6]);
  });

  it('never has more than its room, and exchanges a brick only for a better one: a view at rest comes to rest', async () => {
    const { loading, bricks, log, answerAll, all } = createLoading(createRoom(5 * bytesOfBrick));
    loading.want(inOrder(all));
    await answerAll();
    expect([bricks.count, log.most]).to.deep.equal([5, 5 * bytesOfBrick]);
    // What is there is worth as much as what is missing.
    const asked = log.asked.length;
    loading.want(inOrder(all.slice(5), () => 100));
    await answerAll();
    expect(log.asked.length).to.equal(asked);
    // The first brick has left the picture.
    const isGone = (brick: Brick): boolean => keyOfBrick(brick) === keyOfBrick(all[0]);
    loading.want(inOrder(all.slice(5), (brick) => (isGone(brick) ? 0 : 1000)));
    await answerAll();
    expect([...bricks.bricks].map(keyOfBrick)).to.deep.equal([1, 2, 3, 4, 5].map((n) => keyOfBrick(all[n])));
    expect(log.most).to.equal(5 * bytesOfBrick);
  });

  it('shares the room with others, and takes it back when they go', async () => {
    const room = createRoom(8 * bytesOfBrick);
    const first = createLoading(room);
    first.loading.want(inOrder(first.all));
    await first.answerAll();
    expect(first.bricks.count).to.equal(8);
    const second = createLoading(room);
    second.loading.want(inOrder(second.all));
    expect([first.bricks.count, second.loading.requests]).to.deep.equal([4, 4]);
    await second.answerAll();
    expect(second.bricks.count).to.equal(4);
    expect(first.log.grew).to.equal(0);
    second.loading.close();
    expect(first.log.grew).to.equal(1);
    await first.answerAll();
    expect(first.bricks.count).to.equal(8);
    // The largest number counts.
    room.bytes = 10 * bytesOfBrick;
    const third = createLoading(room);
    expect([room.share / bytesOfBrick, first.bricks.count]).to.deep.equal([5, 5]);
    third.loading.close();
    expect(room.share / bytesOfBrick).to.equal(8);
  });

  it('does not ask again for a brick that could not be read; the others come', async () => {
    const { loading, bricks, waiting, log, answerAll, all } = createLoading(createRoom(2 ** 28));
    loading.want(inOrder(all));
    waiting.get(keyOfBrick(all[3]))!.refuse();
    await answerAll();
    loading.want(inOrder(all));
    await answerAll();
    expect([bricks.count, log.failures, log.asked.length]).to.deep.equal([all.length - 1, 1, all.length]);
  });

  it('keeps to its room through a thousand views, with requests that end in any order', async () => {
    const { loading, bricks, waiting, log, all } = createLoading(createRoom(7 * bytesOfBrick));
    const random = randomNumbers(5);
    for (let view = 0; view < 1000; view++) {
      const seen = all.filter(() => random() < 0.3);
      loading.want(inOrder(seen, (brick) => (seen.some((one) => keyOfBrick(one) === keyOfBrick(brick)) ? 50 : 0)));
      expect(loading.bytes).to.be.at.most(7 * bytesOfBrick);
      for (const { answer } of [...waiting.values()]) if (random() < 0.4) answer();
      if (view % 3 === 0) await new Promise((resolve) => setTimeout(resolve));
    }
    expect(bricks.slots).to.be.at.most(7);
    loading.close();
    expect([waiting.size, log.failures]).to.deep.equal([0, 0]);
  });
});

describe('the room that views share', () => {
  const createKept = (keptBytes: number) => ({ keptBytes, dropKept: () => {} });

  it('keeps bricks of views that have no place on the GPU, as many bytes as it has; the oldest ones go first', () => {
    const room = new BrickRoom(0);
    room.enter(() => {}, 100);
    const dropped: number[] = [];
    const views = [40, 50, 30, 20].map((bytes, n) => {
      const view = { keptBytes: bytes, dropKept: () => void (dropped.push(n), (view.keptBytes = 0)) };
      return view;
    });
    for (const view of views.slice(0, 2)) room.keep(view);
    expect(dropped).to.deep.equal([]);
    room.keep(views[2]);
    expect(dropped).to.deep.equal([0]);
    // It is on the GPU again: it counts no longer, and comes last when it is kept again.
    views[1].keptBytes = 0;
    room.keep(views[3]);
    views[1].keptBytes = 50;
    room.keep(views[1]);
    expect(dropped).to.deep.equal([0]);
    room.keep(createKept(1));
    expect(dropped).to.deep.equal([0, 2]);
  });

  it('drops what is larger than the room itself', () => {
    const room = new BrickRoom(0);
    room.enter(() => {}, 100);
    let isDropped = false;
    room.keep({ keptBytes: 101, dropKept: () => (isDropped = true) });
    expect(isDropped).to.equal(true);
  });
});
