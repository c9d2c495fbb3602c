import { expect } from '@esm-bundle/chai';
import type { LoadProgress } from '../../../src/formats/base/load-request.ts';
import { loadVolume } from '../../../src/worker/load.ts';
import { endSpare } from '../../../src/worker/spare-worker.ts';
import { startFromText } from '../../../src/worker/worker-client.ts';
import type { WorkerReport } from '../../../src/worker/worker-messages.ts';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { roomyLimits } from '../../helpers/decode.ts';

/** A worker that says what it is told to, and nothing else. */
class SilentWorker {
  static last: SilentWorker;
  onmessage: ((event: { data: WorkerReport }) => void) | null = null;
  readonly heard: unknown[] = [];
  ended = false;

  constructor() {
    SilentWorker.last = this;
  }

  postMessage(message: unknown): void {
    this.heard.push(message);
  }

  terminate(): void {
    this.ended = true;
  }

  say(...reports: WorkerReport[]): void {
    for (const data of reports) this.onmessage?.({ data });
  }
}

interface Watched {
  readonly worker: SilentWorker;
  /** Let seconds pass; what the load has come to then: undefined where it goes on. */
  readonly pass: (seconds: number) => Promise<unknown>;
  readonly reported: LoadProgress[];
  readonly clocks: () => number;
  readonly controller: AbortController;
}

/** Load with a silent worker and a clock that goes when it is told to. */
async function withSilence(run: (watched: Watched) => Promise<void>): Promise<void> {
  endSpare();
  const native = {
    Worker: globalThis.Worker,
    setInterval: globalThis.setInterval,
    clearInterval: globalThis.clearInterval,
  };
  const ticks = new Map<number, () => void>();
  Object.assign(globalThis, {
    Worker: SilentWorker,
    setInterval: (act: () => void) => ticks.set(ticks.size + 1, act).size,
    clearInterval: (id: number) => void ticks.delete(id),
  });
  try {
    const reported: LoadProgress[] = [];
    const controller = new AbortController();
    let end: unknown;
    const loading = loadVolume(
      { url: '/scan.nii', limits: roomyLimits },
      { signal: controller.signal, onProgress: (progress) => reported.push(progress) },
    );
    loading.then(
      (volume) => (end = volume),
      (error: unknown) => (end = error),
    );
    const pass = async (seconds: number): Promise<unknown> => {
      for (let i = 0; i < seconds; i++) ticks.forEach((act) => act());
      await new Promise((resolve) => setTimeout(resolve));
      return end;
    };
    await pass(0);
    await run({ worker: SilentWorker.last, pass, reported, clocks: () => ticks.size, controller });
  } finally {
    Object.assign(globalThis, native);
  }
}

const progress = (loaded: number, total: number, phase: LoadProgress['phase'] = 'fetch'): WorkerReport => ({
  type: 'progress',
  progress: { loaded, total, phase },
});

/** A worker that does not answer is ended half a second after its load. */
async function expectEnd(worker: SilentWorker): Promise<void> {
  expect(worker.heard.at(-1)).to.deep.equal({ stop: true });
  await new Promise((resolve) => setTimeout(resolve, 700));
  expect(worker.ended).to.equal(true);
}

function expectStall(error: unknown, words: RegExp): void {
  expect(error).to.be.instanceOf(VolumeViewError).with.property('code', 'source/stalled');
  expect((error as VolumeViewError).message).to.match(words);
}

describe('a load of which nothing is heard', () => {
  it('ends after 30 seconds, and its worker with it', () =>
    withSilence(async ({ worker, pass, clocks }) => {
      worker.say({ type: 'ready' }, progress(1000, 5000));
      expect(await pass(29)).to.equal(undefined);
      expectStall(await pass(1), /scan\.nii came no further for 30 seconds, after 1000 bytes/);
      await expectEnd(worker);
      expect(clocks()).to.equal(0);
    }));

  it('ends too where the worker never began', () =>
    withSilence(async ({ pass }) => {
      expectStall(await pass(30), /after 0 bytes/);
    }));

  it('goes on as long as bytes come', () =>
    withSilence(async ({ worker, pass }) => {
      worker.say({ type: 'ready' });
      for (let loaded = 1; loaded < 5; loaded++) {
        worker.say(progress(loaded, 5000));
        expect(await pass(29)).to.equal(undefined);
      }
    }));

  it('says after 5 seconds that others may load meanwhile', () =>
    withSilence(async ({ worker, pass, reported }) => {
      worker.say({ type: 'ready' }, progress(1000, 5000));
      await pass(4);
      expect(reported.some(({ isStill }) => isStill)).to.equal(false);
      await pass(1);
      expect(reported.at(-1)).to.deep.equal({ loaded: 1000, total: 5000, phase: 'fetch', isStill: true });
    }));

  it('but is decoded may be silent for a minute, and a second more a megabyte', () =>
    withSilence(async ({ worker, pass, reported }) => {
      worker.say({ type: 'ready' }, progress(50e6, 50e6));
      expect(await pass(109)).to.equal(undefined);
      expect(
        reported.some(({ isStill }) => isStill),
        'what works holds its place',
      ).to.equal(false);
      expectStall(await pass(1), /for 110 seconds, after 50000000 bytes/);
      expect(worker.ended, 'at once, as it read much').to.equal(true);
    }));

  it('ends at once where it is given up', () =>
    withSilence(async ({ worker, pass, controller, clocks }) => {
      controller.abort(new Error('not wanted'));
      expect(await pass(0)).to.have.property('message', 'not wanted');
      await expectEnd(worker);
      expect(clocks()).to.equal(0);
    }));
});

describe('a worker from a text', () => {
  it('gives its address back where it is ended before it speaks, and where it can not begin', () => {
    const native = { create: URL.createObjectURL, revoke: URL.revokeObjectURL, Worker: globalThis.Worker };
    const held = new Set<string>();
    URL.createObjectURL = (blob) => {
      const url = native.create.call(URL, blob);
      held.add(url);
      return url;
    };
    URL.revokeObjectURL = (url) => void held.delete(url);
    try {
      const worker = startFromText('for (;;);');
      expect(held.size).to.equal(1);
      worker.terminate();
      expect(held.size).to.equal(0);
      globalThis.Worker = function refuse() {
        throw new DOMException('no', 'SecurityError');
      } as unknown as typeof Worker;
      expect(() => startFromText('')).to.throw('no');
      expect(held.size).to.equal(0);
    } finally {
      Object.assign(URL, { createObjectURL: native.create, revokeObjectURL: native.revoke });
      globalThis.Worker = native.Worker;
    }
  });
});
