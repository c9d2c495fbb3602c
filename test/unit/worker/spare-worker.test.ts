import { expect } from '@esm-bundle/chai';
import { endSpare, keepWorker, takeWorker } from '../../../src/worker/spare-worker.ts';
import type { LiveWorker } from '../../../src/worker/spare-worker.ts';
import type { WorkerAnswer } from '../../../src/worker/worker-messages.ts';
import { FakeTimers } from '../../helpers/fake-timers.ts';

/** A worker that keeps what it hears, and says what the test wants. */
class MuteWorker {
  onmessage: ((event: { data: WorkerAnswer }) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly heard: unknown[] = [];
  ended = 0;

  postMessage(message: unknown): void {
    this.heard.push(message);
  }

  terminate(): void {
    this.ended++;
  }

  say(data: WorkerAnswer): void {
    this.onmessage?.({ data });
  }
}

type Mute = MuteWorker & LiveWorker;

const make = (): Mute => Object.assign(new MuteWorker() as unknown as Mute, { source: 'a' });

/** The worker for the next load; undefined where it would be a new one. */
async function takeKept(source = 'a'): Promise<unknown> {
  const made = make();
  const worker = await takeWorker(source, () => made);
  return worker === made ? undefined : worker;
}

describe('a worker that no load has', () => {
  afterEach(() => endSpare());

  it('is taken by the next load, once', () =>
    new FakeTimers().run(async (timers) => {
      const worker = make();
      keepWorker(worker, true);
      expect(await takeKept()).to.equal(worker);
      expect(await takeKept()).to.equal(undefined);
      timers.pass(60_000);
      expect([worker.ended, timers.count, worker.heard.length]).to.deep.equal([0, 0, 0]);
    }));

  it('is not taken by a load that starts others', () =>
    new FakeTimers().run(async () => {
      const worker = make();
      keepWorker(worker, true);
      expect(await takeKept('b')).to.equal(undefined);
      expect(await takeKept()).to.equal(worker);
    }));

  it('ends after 30 seconds, and leaves no timer', () =>
    new FakeTimers().run(async (timers) => {
      const worker = make();
      keepWorker(worker, true);
      timers.pass(29_999);
      expect(worker.ended).to.equal(0);
      timers.pass(1);
      expect([worker.ended, timers.count]).to.deep.equal([1, 0]);
      expect(await takeKept()).to.equal(undefined);
    }));

  it('is one: the last one', () =>
    new FakeTimers().run(async (timers) => {
      const workers = Array.from({ length: 20 }, make);
      for (const worker of workers) keepWorker(worker, true);
      expect(workers.map(({ ended }) => ended)).to.deep.equal([...Array.from({ length: 19 }, () => 1), 0]);
      expect(timers.count).to.equal(1);
      expect(await takeKept()).to.equal(workers[19]);
    }));

  it('ends where it fails by itself', () =>
    new FakeTimers().run(async (timers) => {
      const worker = make();
      keepWorker(worker, true);
      worker.onerror!({} as ErrorEvent);
      expect([worker.ended, timers.count]).to.deep.equal([1, 0]);
      expect(await takeKept()).to.equal(undefined);
    }));
});

describe('a worker whose load was given up', () => {
  afterEach(() => endSpare());

  it('is free when it says so', () =>
    new FakeTimers().run(async (timers) => {
      const worker = make();
      keepWorker(worker, false);
      expect(worker.heard).to.deep.equal([{ stop: true }]);
      worker.say({ type: 'progress', progress: { loaded: 1, total: 2, phase: 'fetch' } });
      worker.say({ type: 'ready' });
      expect(await takeKept(), 'it works on').to.equal(undefined);
      timers.pass(499);
      worker.say({ type: 'stopped' });
      timers.pass(29_999);
      expect(worker.ended).to.equal(0);
      expect(await takeKept()).to.equal(worker);
      expect(worker.heard, 'it heard that once').to.have.length(1);
    }));

  it('ends where it says nothing for half a second', () =>
    new FakeTimers().run((timers) => {
      const worker = make();
      keepWorker(worker, false);
      timers.pass(499);
      expect(worker.ended).to.equal(0);
      timers.pass(1);
      expect([worker.ended, timers.count]).to.deep.equal([1, 0]);
    }));

  it('ends at once where another one takes its place: at most one works on for nobody', () =>
    new FakeTimers().run(() => {
      const workers = Array.from({ length: 6 }, make);
      for (const worker of workers) keepWorker(worker, false);
      expect(workers.map(({ ended }) => ended)).to.deep.equal([1, 1, 1, 1, 1, 0]);
    }));
});
