import { expect } from '@esm-bundle/chai';
import { endSpare, keepSpare, takeSpare } from '../../../src/worker/spare-worker.ts';
import type { WorkerReport } from '../../../src/worker/worker-messages.ts';
import { FakeTimers } from '../../helpers/fake-timers.ts';

/** A worker that keeps what it hears, and says what the test wants. */
class MuteWorker {
  onmessage: ((event: { data: WorkerReport }) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly heard: unknown[] = [];
  ended = 0;

  postMessage(message: unknown): void {
    this.heard.push(message);
  }

  terminate(): void {
    this.ended++;
  }

  say(data: WorkerReport): void {
    this.onmessage?.({ data });
  }
}

const make = (): MuteWorker & Worker => new MuteWorker() as unknown as MuteWorker & Worker;

describe('a worker that no load has', () => {
  afterEach(endSpare);

  it('is taken by the next load, once', () =>
    new FakeTimers().run((timers) => {
      const worker = make();
      keepSpare(worker, 'a', true);
      expect(takeSpare('a')).to.equal(worker);
      expect(takeSpare('a')).to.equal(undefined);
      timers.pass(60_000);
      expect([worker.ended, timers.count, worker.heard.length]).to.deep.equal([0, 0, 0]);
    }));

  it('is not taken by a load that starts others', () =>
    new FakeTimers().run(() => {
      const worker = make();
      keepSpare(worker, 'a', true);
      expect(takeSpare('b')).to.equal(undefined);
      expect(takeSpare('a')).to.equal(worker);
    }));

  it('ends after 30 seconds, and leaves no timer', () =>
    new FakeTimers().run((timers) => {
      const worker = make();
      keepSpare(worker, 'a', true);
      timers.pass(29_999);
      expect(worker.ended).to.equal(0);
      timers.pass(1);
      expect([worker.ended, timers.count]).to.deep.equal([1, 0]);
      expect(takeSpare('a')).to.equal(undefined);
    }));

  it('is one: the last one', () =>
    new FakeTimers().run((timers) => {
      const workers = Array.from({ length: 20 }, make);
      for (const worker of workers) keepSpare(worker, 'a', true);
      expect(workers.map(({ ended }) => ended)).to.deep.equal([...Array.from({ length: 19 }, () => 1), 0]);
      expect(timers.count).to.equal(1);
      expect(takeSpare('a')).to.equal(workers[19]);
    }));

  it('ends where it fails by itself', () =>
    new FakeTimers().run((timers) => {
      const worker = make();
      keepSpare(worker, 'a', true);
      worker.onerror!({} as unknown as ErrorEvent);
      expect([worker.ended, timers.count]).to.deep.equal([1, 0]);
      expect(takeSpare('a')).to.equal(undefined);
    }));

  it('is not one that failed: that is ended, and the other one stays', () =>
    new FakeTimers().run(() => {
      const [worker, failed] = [make(), make()];
      keepSpare(worker, 'a', true);
      keepSpare(failed, 'a');
      expect([worker.ended, failed.ended]).to.deep.equal([0, 1]);
      expect(takeSpare('a')).to.equal(worker);
    }));
});

describe('a worker whose load was given up', () => {
  afterEach(endSpare);

  it('is free when it says so', () =>
    new FakeTimers().run((timers) => {
      const worker = make();
      keepSpare(worker, 'a', false);
      expect(worker.heard).to.deep.equal([{ stop: true }]);
      worker.say({ type: 'progress', progress: { loaded: 1, total: 2, phase: 'fetch' } });
      worker.say({ type: 'ready' });
      expect(takeSpare('a'), 'it works on').to.equal(undefined);
      timers.pass(499);
      worker.say({ type: 'stopped' });
      timers.pass(29_999);
      expect(worker.ended).to.equal(0);
      expect(takeSpare('a')).to.equal(worker);
      expect(worker.heard, 'told once').to.have.length(1);
    }));

  it('ends where it says nothing for half a second', () =>
    new FakeTimers().run((timers) => {
      const worker = make();
      keepSpare(worker, 'a', false);
      timers.pass(499);
      expect(worker.ended).to.equal(0);
      timers.pass(1);
      expect([worker.ended, timers.count]).to.deep.equal([1, 0]);
    }));

  it('ends at once where another one takes its place: at most one works on for nobody', () =>
    new FakeTimers().run(() => {
      const workers = Array.from({ length: 6 }, make);
      for (const worker of workers) keepSpare(worker, 'a', false);
      expect(workers.map(({ ended }) => ended)).to.deep.equal([1, 1, 1, 1, 1, 0]);
    }));
});
