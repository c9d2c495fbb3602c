import { expect } from '@esm-bundle/chai';
import { FrameLoop } from '../../../../src/viewer/scenes/frame-loop.ts';
import type { FrameClock, FrameHost } from '../../../../src/viewer/scenes/frame-loop.ts';

/** Frames that come when a test says so. */
class FakeClock implements FrameClock {
  #callbacks = new Map<number, (time: number) => void>();
  #next = 1;

  get planned(): number {
    return this.#callbacks.size;
  }

  request(callback: (time: number) => void): number {
    this.#callbacks.set(this.#next, callback);
    return this.#next++;
  }

  cancel(frame: number): void {
    this.#callbacks.delete(frame);
  }

  /** The next frame of the page, and all that it leads to. */
  async frame(time: number): Promise<void> {
    const due = [...this.#callbacks.values()];
    this.#callbacks.clear();
    for (const callback of due) callback(time);
    await new Promise((resolve) => setTimeout(resolve));
  }
}

/** Counts what a loop asks for. */
class FakeHost implements FrameHost {
  canDraw = true;
  wantsPicture = true;
  animating = false;
  /** Frames until the camera arrives. */
  way = 0;
  /** Better pictures that follow. */
  better = 0;
  /** Ends the picture that is being drawn; null where pictures are there at once. */
  finish: (() => void) | null = null;
  isSlow = false;
  failure: Error | null = null;
  readonly drawnAt: number[] = [];
  readonly elapsed: number[] = [];
  readonly failures: unknown[] = [];
  asked = 0;
  over = 0;

  get moving(): boolean {
    return this.way > 0;
  }

  askForScene(): void {
    this.asked++;
  }

  advance(elapsedMs: number): void {
    this.elapsed.push(elapsedMs);
    this.way = Math.max(0, this.way - 1);
  }

  async draw(time: number): Promise<boolean> {
    this.drawnAt.push(time);
    if (this.isSlow) await new Promise<void>((resolve) => (this.finish = resolve));
    if (this.failure) throw this.failure;
    return this.better-- > 0;
  }

  failed(error: unknown): void {
    this.failures.push(error);
  }

  drew(): void {
    this.over++;
  }
}

function start(changes: Partial<FakeHost> = {}): { host: FakeHost; clock: FakeClock; loop: FrameLoop } {
  const host = Object.assign(new FakeHost(), changes);
  const clock = new FakeClock();
  return { host, clock, loop: new FrameLoop(host, clock) };
}

/** Frames of the page until none is planned. */
async function run(clock: FakeClock, max = 20): Promise<number> {
  let count = 0;
  for (; clock.planned > 0 && count < max; count++) await clock.frame(1000 + 16 * count);
  return count;
}

describe('the frame loop', () => {
  it('draws one frame after a change, however many changes there were, and then rests without a frame planned', async () => {
    const { host, clock, loop } = start();
    expect(clock.planned, 'before anything was asked for').to.equal(0);
    for (let i = 0; i < 5; i++) loop.request();
    expect(clock.planned).to.equal(1);
    expect(await run(clock)).to.equal(1);
    expect([host.drawnAt.length, host.over, clock.planned]).to.deep.equal([1, 1, 0]);
    expect([loop.dirty, loop.unfinished, loop.drawing]).to.deep.equal([false, false, null]);
  });

  it('goes on until the camera arrives, and for as long as better pictures follow', async () => {
    const { host, clock, loop } = start({ way: 5, better: 2 });
    loop.request();
    await run(clock);
    expect(host.drawnAt).to.have.lengthOf(5);
    expect(host.moving).to.equal(false);
    host.better = 2;
    loop.request();
    expect(await run(clock)).to.equal(3);
  });

  it('goes on for a scene that moves by itself, which nobody can wait for', async () => {
    const { host, clock, loop } = start({ animating: true });
    loop.request();
    expect(await run(clock, 8)).to.equal(8);
    expect(clock.planned).to.equal(1);
    let isSettled = false;
    void loop.settled().then(() => (isSettled = true));
    await clock.frame(2000);
    host.animating = false;
    await run(clock);
    await Promise.resolve();
    expect(isSettled).to.equal(true);
  });

  it('gives the time between frames, but not that of a rest', async () => {
    const { host, clock, loop } = start({ way: 3 });
    loop.request();
    for (const time of [1000, 1020, 1500]) await clock.frame(time);
    expect(host.elapsed).to.deep.equal([16, 20, 100]);
    host.way = 1;
    loop.request();
    await clock.frame(9000);
    expect(host.elapsed.at(-1)).to.equal(16);
  });

  it('draws one picture at a time; a change meanwhile is drawn after it', async () => {
    const { host, clock, loop } = start({ isSlow: true });
    loop.request();
    await clock.frame(1000);
    expect(loop.drawing).to.not.equal(null);
    loop.request();
    expect([clock.planned, loop.dirty]).to.deep.equal([0, true]);
    host.isSlow = false;
    host.finish!();
    await new Promise((resolve) => setTimeout(resolve));
    expect(await run(clock)).to.equal(1);
    expect(host.drawnAt).to.have.lengthOf(2);
  });

  it('reports what failed once, and tries again only after a change', async () => {
    const failure = new Error('no');
    const { host, clock, loop } = start({ failure });
    loop.request();
    expect(await run(clock)).to.equal(1);
    expect(host.failures).to.deep.equal([failure]);
    expect([loop.dirty, loop.drawing, host.over]).to.deep.equal([false, null, 1]);
    host.failure = null;
    loop.request();
    await run(clock);
    expect([host.drawnAt.length, host.failures.length]).to.deep.equal([2, 1]);
  });

  it('asks for a scene where there is none, and draws once there is one', async () => {
    const { host, clock, loop } = start({ canDraw: false });
    loop.request();
    expect([host.asked, clock.planned]).to.deep.equal([1, 0]);
    host.canDraw = true;
    loop.plan();
    await run(clock);
    expect(host.drawnAt).to.have.lengthOf(1);
  });

  it('is settled when nothing changes any more, at once where no picture is to come, and when it ends', async () => {
    const { host, clock, loop } = start({ way: 3 });
    const settled: string[] = [];
    void loop.settled().then(() => settled.push('drawn'));
    await clock.frame(1000);
    await clock.frame(1016);
    expect(settled).to.deep.equal([]);
    await run(clock);
    expect(settled).to.deep.equal(['drawn']);
    loop.request();
    host.wantsPicture = false;
    await loop.settled();
    host.wantsPicture = true;
    void loop.settled().then(() => settled.push('ended'));
    loop.end();
    await Promise.resolve();
    await Promise.resolve();
    expect(settled).to.deep.equal(['drawn', 'ended']);
  });

  it('does not start a picture again for a caller that waits for it', async () => {
    const { host, clock, loop } = start({ isSlow: true });
    loop.request();
    await clock.frame(1000);
    let isSettled = false;
    void loop.settled().then(() => (isSettled = true));
    expect(loop.dirty, 'while it is drawn').to.equal(false);
    host.finish!();
    await new Promise((resolve) => setTimeout(resolve));
    expect([isSettled, clock.planned, host.drawnAt.length]).to.deep.equal([true, 0, 1]);
  });

  it('keeps frames away from what is drawn between them, and makes up for changes then', async () => {
    const { host, clock, loop } = start();
    loop.request();
    await run(clock);
    let end = (_value: string): void => {};
    const now = loop.drawNow(() => new Promise<string>((resolve) => (end = resolve)));
    loop.request();
    expect(clock.planned).to.equal(0);
    end('a picture');
    expect(await now).to.equal('a picture');
    expect(clock.planned).to.equal(1);
    await run(clock);
    expect(host.drawnAt).to.have.lengthOf(2);
  });

  it('forgets its frame when the scene goes, but not what was to be drawn; at its end it draws nothing', async () => {
    const { host, clock, loop } = start({ way: 9 });
    loop.request();
    await clock.frame(1000);
    loop.rest();
    expect([clock.planned, loop.dirty]).to.deep.equal([0, true]);
    loop.end();
    loop.request();
    expect([clock.planned, host.drawnAt.length]).to.deep.equal([0, 1]);
  });
});
