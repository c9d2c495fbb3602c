import { expect } from '@esm-bundle/chai';
import { Playback } from '../../../../src/viewer/loading/playback.ts';
import { ScanPlayer } from '../../../../src/viewer/loading/scan-player.ts';
import type { ScanHost, TimeChangeDetail } from '../../../../src/viewer/loading/scan-player.ts';
import type { Volume } from '../../../../src/volume/volume.ts';

const sources = (count: number): { url: string }[] => Array.from({ length: count }, (_, i) => ({ url: String(i) }));
const pause = (ms = 0): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));
const tiny = { samples: { byteLength: 1 } } as unknown as Volume;

/** An element's part: it loads what the player wants, and draws it at once. */
class FakeElement implements ScanHost {
  readonly went: number[] = [];
  readonly shownScans: number[] = [];
  readonly details: TimeChangeDetail[] = [];
  readonly failing = new Set<number>();
  gaveUp = 0;
  /** Loads that end when a test says so; null where all end at once. */
  held: (() => void)[] | null = null;
  player!: ScanPlayer;
  #current = new AbortController();

  open(count: number): this {
    this.player = new ScanPlayer(sources(count), this);
    return this;
  }

  readonly load: ScanHost['load'] = async ({ url }, signal) => {
    if (this.held) await new Promise<void>((resolve) => this.held!.push(resolve));
    signal.throwIfAborted();
    if (this.failing.has(Number(url))) throw new Error(`no ${url}`);
    return tiny;
  };

  readonly go = (index: number): void => {
    this.went.push(index);
    void this.show(index);
  };

  readonly shown = (scan: TimeChangeDetail): void => {
    this.shownScans.push(scan.index);
    this.details.push(scan);
  };

  readonly changed = (): void => {};

  readonly giveUp = (): void => {
    this.gaveUp++;
    this.player.play({ on: false, speed: 1 });
  };

  /** Load a scan, and draw it. */
  async show(index: number): Promise<void> {
    this.#current.abort();
    const { signal } = (this.#current = new AbortController());
    const done = await this.player
      .load({ index }, signal, () => {})
      .then(
        () => true,
        () => false,
      );
    if (signal.aborted) return;
    this.player.settled(done);
    if (done) this.player.drawn();
  }

  end(): void {
    this.player.play({ on: false, speed: 1 });
    this.player.stop();
  }
}

describe('the player of scans', () => {
  it('stays at a scan for as long as a very small speed says', async () => {
    const element = new FakeElement().open(3);
    await element.show(0);
    for (const speed of [1e-7, 1e-300, 5e-324]) {
      element.player.play({ on: true, speed });
      await pause(15);
      expect(element.went, String(speed)).to.deep.equal([]);
    }
    element.end();
  });

  it('steps on and back, and says where it ends', async () => {
    const element = new FakeElement().open(3);
    await element.show(0);
    expect(element.player.step(-1)).to.equal(false);
    expect([element.player.step(1), element.player.step(1), element.player.step(1)]).to.deep.equal([true, true, false]);
    await pause(5);
    expect(element.player.shown).to.deep.equal({ index: 2, time: null, count: 3 });
    expect(element.shownScans, 'the second was passed over').to.deep.equal([0, 2]);
    expect(element.player.step(-1)).to.equal(true);
    await pause(5);
    expect(element.shownScans).to.deep.equal([0, 2, 1]);
    element.end();
  });

  it('plays in order, round and round, until it is paused', async () => {
    const element = new FakeElement().open(3);
    await element.show(0);
    element.player.play({ on: true, speed: 200 });
    while (element.shownScans.length < 8) await pause(5);
    element.player.play({ on: false, speed: 200 });
    await pause(10);
    const count = element.shownScans.length;
    expect(element.shownScans).to.deep.equal(element.shownScans.map((_, i) => i % 3));
    await pause(30);
    expect(element.shownScans).to.have.lengthOf(count);
    element.end();
  });

  it('waits for a scan that takes long, and does not go past it', async () => {
    const element = new FakeElement().open(2);
    element.held = [];
    const first = element.show(0);
    await pause();
    element.held.pop()!();
    await first; // The next one is being loaded ahead.
    element.player.play({ on: true, speed: 1000 });
    await pause(30);
    expect(element.went).to.deep.equal([1]);
    expect([element.player.waiting, element.player.shown!.index]).to.deep.equal([true, 0]);
    const { held } = element;
    element.held = null;
    for (const end of held) end();
    while (element.shownScans.length < 3) await pause(5);
    expect(element.shownScans.slice(0, 3)).to.deep.equal([0, 1, 0]);
    element.end();
  });

  it('keeps to its speed', async () => {
    const element = new FakeElement().open(4);
    await element.show(0);
    const began = performance.now();
    element.player.play({ on: true, speed: 20 });
    while (element.shownScans.length < 4) await pause(2);
    expect(performance.now() - began).to.be.at.least(3 * 50 - 20);
    element.end();
  });

  it('passes over a scan that fails, and gives up where all of them fail one after another', async () => {
    const element = new FakeElement().open(3);
    element.failing.add(1);
    await element.show(0);
    element.player.play({ on: true, speed: 500 });
    while (element.shownScans.length < 5) await pause(5);
    expect(element.shownScans.slice(0, 5)).to.deep.equal([0, 2, 0, 2, 0]);
    expect(element.gaveUp).to.equal(0);
    element.end();
    const none = new FakeElement().open(3);
    for (const scan of [0, 1, 2]) none.failing.add(scan);
    await none.show(0);
    none.player.play({ on: true, speed: 500 });
    while (none.gaveUp === 0) await pause(5);
    await pause(20);
    expect([none.gaveUp, none.went]).to.deep.equal([1, [1, 2]]);
    none.end();
  });

  it('does nothing any more where it is stopped', async () => {
    const element = new FakeElement().open(3);
    await element.show(0);
    element.player.play({ on: true, speed: 100 });
    element.player.stop();
    await pause(40);
    expect([element.went, element.player.waiting]).to.deep.equal([[], false]);
  });
});

describe('playback', () => {
  function start(): { playback: Playback; events: string[]; settings: unknown[]; player: ScanPlayer } {
    const events: string[] = [];
    const settings: unknown[] = [];
    const player = { play: (one: unknown) => settings.push(one) } as unknown as ScanPlayer;
    return { playback: new Playback((event) => events.push(event)), events, settings, player };
  }
  const nameOf = (promise: Promise<void>): Promise<string> =>
    promise.then(
      () => 'playing',
      ({ name }: DOMException) => name,
    );

  it('is paused at first, begins once, and reports each change once', () => {
    const { playback, events } = start();
    expect(playback.paused).to.equal(true);
    playback.pause();
    playback.start();
    playback.start();
    expect(playback.paused).to.equal(false);
    playback.pause();
    expect([playback.paused, events]).to.deep.equal([true, ['play', 'pause']]);
  });

  it('sets what a player of scans should do, also one that comes later, and its speed', async () => {
    const { playback, settings, player } = start();
    const playing = nameOf(playback.play());
    playback.setSpeed(7);
    playback.follow(player, false);
    expect(await playing).to.equal('playing');
    playback.pause();
    playback.setSpeed(3);
    expect(settings).to.deep.equal([
      { on: true, speed: 7 },
      { on: false, speed: 7 },
      { on: false, speed: 3 },
    ]);
  });

  it('begins by itself where the author says so, and outlives a source', () => {
    const { playback, events, player, settings } = start();
    playback.follow(player, true);
    expect([playback.paused, events]).to.deep.equal([false, ['play']]);
    playback.forget();
    playback.follow(player, false);
    expect([playback.paused, settings.at(-1)]).to.deep.equal([false, { on: true, speed: 2 }]);
  });

  it('refuses who waits where it is paused before, and where there is nothing to play', async () => {
    const { playback, events } = start();
    const first = nameOf(playback.play());
    playback.pause();
    expect(await first).to.equal('AbortError');
    const second = nameOf(playback.play());
    playback.giveUp();
    expect(await second).to.equal('NotSupportedError');
    expect([playback.paused, events]).to.deep.equal([true, ['play', 'pause', 'play', 'pause']]);
  });
});
