// The worker's side of the messages, on this thread.
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { expect } from '@esm-bundle/chai';
import type { LoadRequest } from '../../../src/formats/base/load-request.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { takeOrders } from '../../../src/worker/take-orders.ts';
import type { WorkerScope } from '../../../src/worker/take-orders.ts';
import type { WorkerAnswer, WorkerLimits, WorkerOrder, WorkerStop } from '../../../src/worker/worker-messages.ts';
import { fetchFixture, roomyLimits } from '../../helpers/decode.ts';
import { pageOrigin } from '../../helpers/fake-fetch.ts';

type Message = WorkerOrder | WorkerLimits | WorkerStop;

let reports: WorkerAnswer[] = [];
let heard = (): void => undefined;
const scope: WorkerScope = {
  onmessage: null,
  postMessage: (report) => {
    reports.push(report);
    heard();
  },
};
takeOrders(scope);
const first = reports.map(({ type }) => type);

const say = (...messages: Message[]): void =>
  messages.forEach((data) => scope.onmessage!({ data } as MessageEvent<Message>));
const orderOf = (path: string, more: Partial<LoadRequest> = {}): WorkerOrder => ({
  request: { url: `${pageOrigin}/${path}`, ...more },
  pageOrigin,
});
const limits: WorkerLimits = { limits: roomyLimits };

/** Waits for a report of this type. */
function waitFor<T extends WorkerAnswer['type']>(type: T): Promise<Extract<WorkerAnswer, { type: T }>> {
  return new Promise((resolve) => {
    heard = () => {
      const found = reports.find((report) => report.type === type);
      if (found) resolve(found as Extract<WorkerAnswer, { type: T }>);
    };
    heard();
  });
}

/** What the worker does of itself once no work is left. */
const settle = (ms = 60): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));

interface Answering {
  /** The signals of the fetches. */
  readonly signals: AbortSignal[];
  /** Lets the fetches of files named "slow" be answered. */
  release: () => void;
}

/** Fixtures as the files of a server; those named "slow" come when they are released. */
async function withFixtures(run: (answering: Answering) => Promise<void>): Promise<void> {
  const native = globalThis.fetch;
  const answering: Answering = { signals: [], release: () => undefined };
  const held = new Promise<void>((resolve) => (answering.release = resolve));
  globalThis.fetch = async (url, { signal } = {}) => {
    if ((url as string).startsWith('/')) return native(url);
    if (signal) answering.signals.push(signal);
    const path = new URL(url as string).pathname.slice(1);
    if (path.startsWith('slow/'))
      await new Promise<void>((resolve, reject) => {
        void held.then(resolve);
        signal?.addEventListener('abort', () => reject(signal.reason));
      });
    const bytes = await fetchFixture(path.replace('slow/', '')).catch(() => null);
    return new Response(bytes, { status: bytes ? 200 : 404 });
  };
  reports = [];
  try {
    await run(answering);
  } finally {
    globalThis.fetch = native;
  }
}

const nifti = 'nifti/v1-le-gz.nii.gz';

describe('the worker', () => {
  it('says that it is ready, once', () => expect(first).to.deep.equal(['ready']));

  it('takes one order after another, each with its own limits', () =>
    withFixtures(async () => {
      say(orderOf(nifti), { limits: { ...roomyLimits, maxVoxelsPerAxis: 3 } });
      expect((await waitFor('done')).volume)
        .to.have.nested.property('grid.dimensions')
        .deep.equal([3, 2, 3]);
      reports = [];
      say(orderOf('nifti/v1-le-i2.nii'), limits);
      expect((await waitFor('done')).volume)
        .to.have.nested.property('grid.dimensions')
        .deep.equal([3, 4, 5]);
    }));

  it('is whole after an order that failed', () =>
    withFixtures(async () => {
      for (const path of ['missing.nii', 'mosaic/gray-3x2.png']) {
        say(orderOf(path), limits);
        expect(await waitFor('failed'))
          .to.have.property('message')
          .that.has.length.above(20);
        reports = [];
      }
      say(orderOf(nifti), limits);
      expect((await waitFor('done')).volume)
        .to.have.nested.property('range')
        .deep.equal([0, 59]);
    }));

  it('stops an order that waits for bytes: the fetch ends, and nothing more is said of it', () =>
    withFixtures(async ({ signals, release }) => {
      say(orderOf(`slow/${nifti}`), limits);
      await settle();
      expect(signals.map(({ aborted }) => aborted)).to.deep.equal([false]);
      reports = [];
      say({ stop: true });
      await waitFor('stopped');
      release();
      await settle();
      expect(reports.map(({ type }) => type)).to.deep.equal(['stopped']);
      expect(signals.map(({ aborted }) => aborted)).to.deep.equal([true]);
    }));

  it('ends what an order that failed left running', () =>
    withFixtures(async ({ signals }) => {
      const files = ['mosaic/gray-3x2.png', nifti, 'slow/mosaic/gray-3x2.png'].map((path) => `${pageOrigin}/${path}`);
      say(orderOf('mosaic/gray-3x2.png', { files }), limits);
      expect(await waitFor('failed')).to.have.property('code', 'format/unsupported');
      await settle();
      expect(signals.map(({ aborted }) => aborted)).to.deep.equal([true, true, true]);
    }));

  it('answers a stop that comes after the end', () =>
    withFixtures(async () => {
      say(orderOf(nifti), limits);
      await waitFor('done');
      reports = [];
      say({ stop: true });
      await waitFor('stopped');
      expect(reports).to.deep.equal([{ type: 'stopped' }]);
    }));

  it('holds neither the file nor the samples of an order that ended', async () => {
    setFlagsFromString('--expose-gc');
    const collect = runInNewContext('gc') as () => void;
    const held: WeakRef<object>[] = [];
    await withFixtures(async () => {
      const answer = globalThis.fetch;
      globalThis.fetch = async (...args) => {
        const response = await answer(...args);
        if (!(args[0] as string).startsWith('/')) held.push(new WeakRef(response));
        return response;
      };
      say(orderOf(nifti), limits);
      const { volume } = await waitFor('done');
      held.push(new WeakRef(volume), new WeakRef((volume as Volume).samples));
    });
    reports = [];
    heard = () => undefined;
    for (let i = 0; i < 20 && held.some((one) => one.deref()); i++) {
      await settle(20);
      collect();
    }
    expect(held.map((one) => one.deref() === undefined)).to.deep.equal([true, true, true]);
  });
});
