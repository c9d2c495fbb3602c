import { expect } from '@esm-bundle/chai';
import { LoadQueue } from '../../../../src/viewer/loading/load-queue.ts';

/** Loads that end when they are told to, by name. */
function prepare(max: number): {
  running: string[];
  load: (name: string, inSight?: boolean, signal?: AbortSignal) => Promise<string>;
  end: (name: string) => Promise<void>;
} {
  const queue = new LoadQueue(max);
  const running: string[] = [];
  const ends = new Map<string, () => void>();
  const load = (name: string, inSight = false, signal = new AbortController().signal): Promise<string> =>
    queue.run(
      () => inSight,
      signal,
      async () => {
        running.push(name);
        await new Promise<void>((resolve) => ends.set(name, resolve));
        running.splice(running.indexOf(name), 1);
        if (name === 'bad') throw new Error('bad');
        return name;
      },
    );
  const end = async (name: string): Promise<void> => {
    ends.get(name)!();
    await new Promise((resolve) => setTimeout(resolve));
  };
  return { running, load, end };
}

describe('the queue of loads', () => {
  it('runs so many at once, those in sight first, and gives each its result', async () => {
    const { running, load, end } = prepare(2);
    const all = ['a', 'b', 'c'].map((name) => load(name));
    all.push(load('seen', true));
    expect(running).to.deep.equal(['a', 'b']);
    await end('a');
    expect(running).to.deep.equal(['b', 'seen']);
    await end('b');
    expect(running).to.deep.equal(['seen', 'c']);
    await end('seen');
    await end('c');
    expect(await Promise.all(all)).to.deep.equal(['a', 'b', 'c', 'seen']);
  });

  it('goes on after one that fails', async () => {
    const { running, load, end } = prepare(1);
    const bad = load('bad').catch((error: Error) => error.message);
    const next = load('next');
    await end('bad');
    expect(await bad).to.equal('bad');
    expect(running).to.deep.equal(['next']);
    await end('next');
    expect(await next).to.equal('next');
  });

  it('goes on while one lends its place, which it can do once', async () => {
    const queue = new LoadQueue(1);
    const started: string[] = [];
    const ends: (() => void)[] = [];
    const start = (name: string, lends: boolean) =>
      queue.run(
        () => true,
        new AbortController().signal,
        async (lend) => {
          started.push(name);
          if (lends) for (let i = 0; i < 3; i++) lend();
          await new Promise<void>((resolve) => ends.push(resolve));
        },
      );
    const all = [start('still', true), start('next', false), start('last', false)];
    await new Promise((resolve) => setTimeout(resolve));
    expect(started).to.deep.equal(['still', 'next']);
    ends[0]();
    await all[0];
    expect(started, 'its end frees no second place').to.deep.equal(['still', 'next']);
    ends[1]();
    await all[1];
    expect(started).to.deep.equal(['still', 'next', 'last']);
    ends[2]();
    await all[2];
  });

  it('lends so many places that twice as many run, and no more', async () => {
    const queue = new LoadQueue(2);
    const controller = new AbortController();
    let started = 0;
    const load = async (lend: () => void): Promise<void> => {
      started++;
      lend();
      await new Promise((resolve) => controller.signal.addEventListener('abort', resolve));
    };
    const all = Array.from({ length: 9 }, () => queue.run(() => true, controller.signal, load).catch(() => {}));
    await new Promise((resolve) => setTimeout(resolve));
    expect(started).to.equal(4);
    controller.abort();
    await Promise.all(all);
  });

  it('forgets one that is given up', async () => {
    const { running, load, end } = prepare(1);
    const first = load('a');
    const controller = new AbortController();
    const given = load('b', true, controller.signal).catch((error: Error) => error.message);
    const last = load('c');
    controller.abort(new Error('not wanted'));
    expect(await given).to.equal('not wanted');
    await end('a');
    expect(running).to.deep.equal(['c']);
    await end('c');
    expect(await Promise.all([first, last])).to.deep.equal(['a', 'c']);
  });
});
