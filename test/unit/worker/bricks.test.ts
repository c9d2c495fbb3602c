// A pyramid in bricks, from the page's end of a port to a server: the worker's side runs on this thread.
import { expect } from '@esm-bundle/chai';
import { crc32 } from '../../../src/formats/codecs/crc32.ts';
import type { BrickStore } from '../../../src/formats/base/brick-store.ts';
import type { LoadRequest } from '../../../src/formats/base/load-request.ts';
import { connectBricks } from '../../../src/worker/connect-bricks.ts';
import { takeOrders } from '../../../src/worker/take-orders.ts';
import type { WorkerScope } from '../../../src/worker/take-orders.ts';
import type { WorkerAnswer, WorkerOrder } from '../../../src/worker/worker-messages.ts';
import { allBricks, expectFormula, failureOf, noSignal } from '../../helpers/brick-stores.ts';
import { formulaFiles, formulaOf } from '../../helpers/formula-pyramid.ts';
import type { FormulaPyramid } from '../../helpers/formula-pyramid.ts';
import { startFormulaServer } from '../../helpers/formula-server.ts';
import type { FormulaServer } from '../../helpers/formula-server.ts';
import { pyramidFiles } from '../../helpers/zarr-bytes.ts';
import { zipBytes } from '../../helpers/zip-bytes.ts';

// Node 20 has none.
if (!('navigator' in globalThis)) Object.assign(globalThis, { navigator: { onLine: true } });

const reports: WorkerAnswer[] = [];
const scope: WorkerScope = { onmessage: null, postMessage: (report) => reports.push(report) };
takeOrders(scope);

interface Opened {
  readonly store: Promise<BrickStore | null>;
  /** How often the page was told that it is over. */
  readonly ends: () => number;
}

/** Opens a pyramid over a port, as open-bricks.ts does. */
function open(request: Omit<LoadRequest, 'limits'>, pageOrigin = 'https://page.example', signal = noSignal()): Opened {
  const { port1, port2 } = new MessageChannel();
  let ends = 0;
  const { opened } = connectBricks(port1, signal, () => ends++);
  const data: WorkerOrder = { request: { ...request, bricks: port2 }, pageOrigin };
  scope.onmessage!({ data } as MessageEvent<WorkerOrder>);
  return { store: opened, ends: () => ends };
}

const small: FormulaPyramid = { dimensions: [48, 40, 32], levels: 3 };
const formula = formulaOf(small);
const files = formulaFiles(formula);

async function withServer(run: (server: FormulaServer) => Promise<void>): Promise<void> {
  const server = await startFormulaServer(files);
  try {
    await run(server);
  } finally {
    await server.close();
  }
}

/** All files of the formula, by their paths. */
const listed = [
  'zarr.json',
  '0/zarr.json',
  '1/zarr.json',
  '2/zarr.json',
  ...placesOf(0),
  ...placesOf(1),
  ...placesOf(2),
].map((path) => ({ path, bytes: files.bytesOf(path, 0, files.sizeOf(path)!) }));

function placesOf(level: number): string[] {
  return [0, 1].flatMap((z) =>
    [0, 1].flatMap((y) => [0, 1].map((x) => `${level}/c/${z}/${y}/${x}`)).filter((path) => files.sizeOf(path) !== null),
  );
}

const zip = zipBytes(
  listed.map(({ path, bytes }) => ({ path: `brain.zarr/${path}`, packed: bytes, crc: crc32(bytes) })),
);

async function expectWhole(store: BrickStore | null): Promise<void> {
  expect(store!.levels.map(({ bricks }) => bricks)).to.deep.equal([
    [2, 2, 1],
    [1, 1, 1],
    [1, 1, 1],
  ]);
  for (const brick of allBricks(store!))
    for (const isAlone of [false, true]) await expectFormula(store!, formula, brick, isAlone);
}

describe('a pyramid that a worker reads in bricks', () => {
  it('comes from a folder on a server, and is gone when it is closed', () =>
    withServer(async (server) => {
      const { store: opened, ends } = open({ url: server.url }, server.origin);
      const store = (await opened)!;
      await expectWhole(store);
      expect(await store.residuals(noSignal())).to.equal(null);
      store.close();
      store.close();
      expect(ends()).to.equal(1);
      expect(await failureOf(store.read({ level: 0, at: [0, 0, 0] }, noSignal()))).to.include({ name: 'AbortError' });
    }));

  it('comes from a ZIP archive on a server, of which parts are read', async () => {
    const archive = await startFormulaServer(
      {
        sizeOf: (path) => (path === 'brain.ozx' ? zip.length : null),
        bytesOf: (_, start, end) => zip.slice(start, end),
      },
      {},
      'data',
    );
    try {
      const store = await open({ url: `${archive.url}brain.ozx` }, archive.origin).store;
      await expectWhole(store);
      store!.close();
    } finally {
      await archive.close();
    }
  });

  it('comes from a chosen folder, and from a chosen archive', async () => {
    const folder = listed.map(({ path, bytes }) => {
      const file = new File([bytes], path.slice(path.lastIndexOf('/') + 1));
      return Object.defineProperty(file, 'webkitRelativePath', { value: `brain.zarr/${path}` });
    });
    const base = 'https://local-1.invalid/';
    for (const chosen of [folder, [new File([zip], 'brain.ozx')]]) {
      const store = await open({ url: base, local: { base, files: chosen } }).store;
      await expectWhole(store);
      store!.close();
    }
  });

  it('shares its worker with others', () =>
    withServer(async (server) => {
      const stores = await Promise.all([1, 2, 3].map(() => open({ url: server.url }, server.origin).store));
      stores[0]!.close();
      await expectWhole(stores[1]);
      await expectWhole(stores[2]);
      expect(server.counts.most).to.be.at.most(8);
      for (const store of stores) store!.close();
    }));

  it('is read once for all views of it, also when the first one leaves while its chunks are on their way', () =>
    withServer(async (server) => {
      const chunks = (): string[] => server.asked.filter((path) => path.includes('/c/'));
      const stores = await Promise.all([1, 2, 3].map(() => open({ url: server.url }, server.origin).store));
      server.faults = { delayMs: 50 };
      const first = failureOf(stores[0]!.read({ level: 0, at: [0, 0, 0] }, noSignal()));
      const second = stores[1]!.read({ level: 0, at: [0, 0, 0] }, noSignal());
      while (chunks().length === 0) await new Promise((resolve) => setTimeout(resolve, 5));
      stores[0]!.close();
      expect(await first).to.include({ name: 'AbortError' });
      expect((await second).samples.length).to.equal(36 ** 3);
      server.faults = {};
      await expectWhole(stores[1]);
      await expectWhole(stores[2]);
      expect(chunks().length).to.equal(new Set(chunks()).size);
      stores[1]!.close();
      stores[2]!.close();
      // Who comes later may find another pyramid there. What closes it is a message.
      await new Promise((resolve) => setTimeout(resolve, 50));
      const asked = chunks().length;
      const later = (await open({ url: server.url }, server.origin).store)!;
      await expectWhole(later);
      expect(chunks().length).to.equal(2 * asked);
      later.close();
    }));

  it('is read by each view for itself where they ask for other things of it', () =>
    withServer(async (server) => {
      const chunks = (): number => server.asked.filter((path) => path.includes('/c/')).length;
      const ways = [{}, { credentials: 'include' as const }];
      const stores = await Promise.all(
        ways.map((settings) => open({ url: server.url, settings }, server.origin).store),
      );
      await expectWhole(stores[0]);
      const asked = chunks();
      await expectWhole(stores[1]);
      expect(chunks()).to.equal(2 * asked);
      for (const store of stores) store!.close();
    }));

  it('can be opened again where it could not be at first', () =>
    withServer(async (server) => {
      const url = `${server.origin}/none.zarr`;
      const both = [1, 2].map(() => failureOf(open({ url }, server.origin).store));
      for (const failure of both) expect(await failure).to.include({ code: 'format/unsupported' });
      const asked = server.asked.length;
      expect(await failureOf(open({ url }, server.origin).store)).to.include({ code: 'format/unsupported' });
      expect(server.asked.length).to.be.above(asked);
    }));

  it('ends the requests of bricks that are given up, and all when it is closed or was never wanted', () =>
    withServer(async (server) => {
      const until = async (isSo: () => boolean): Promise<void> => {
        for (let n = 0; n < 1000 && !isSo(); n++) await new Promise((resolve) => setTimeout(resolve, 10));
        expect(isSo()).to.equal(true);
      };
      const chunks = (): number => server.asked.filter((path) => path.includes('/c/')).length;
      const store = (await open({ url: server.url }, server.origin).store)!;
      server.faults = { delayMs: 3000 };
      const moved = new AbortController();
      const given = failureOf(store.read({ level: 0, at: [0, 0, 0] }, moved.signal));
      await until(() => chunks() === 4);
      moved.abort(new Error('moved on'));
      expect(await given).to.include({ message: 'moved on' });
      await until(() => server.counts.running === 0);
      const other = failureOf(store.read({ level: 0, at: [0, 0, 0] }, noSignal()));
      await until(() => chunks() === 8);
      store.close();
      expect(await other).to.include({ name: 'AbortError' });
      await until(() => server.counts.running === 0);
      expect(server.counts.cancelled).to.equal(8);
      const unwanted = new AbortController();
      const { store: never, ends } = open({ url: server.url }, server.origin, unwanted.signal);
      await until(() => server.counts.running === 1);
      unwanted.abort(new Error('not wanted'));
      expect(await failureOf(never)).to.include({ message: 'not wanted' });
      await until(() => server.counts.running === 0);
      expect(ends()).to.equal(1);
    }));

  it('is none of a file of another kind, and of several channels', async () => {
    expect(await open({ url: 'https://page.example/a.nii' }).store).to.equal(null);
    const channels = pyramidFiles({ axes: 'czyx', shape: [2, 4, 4, 4], version: 3 });
    const folder = [...channels].map(([path, bytes]) =>
      Object.defineProperty(new File([bytes], path), 'webkitRelativePath', { value: `cells.zarr/${path}` }),
    );
    expect(
      await open({ url: 'https://local-2.invalid/', local: { base: 'https://local-2.invalid/', files: folder } }).store,
    ).to.equal(null);
  });

  it('that is not there is an error in words', () =>
    withServer(async (server) => {
      const { store, ends } = open({ url: `${server.origin}/none.zarr` }, server.origin);
      expect(await failureOf(store)).to.include({ code: 'format/unsupported' });
      expect(ends()).to.equal(1);
    }));

  it('says nothing to who loads volumes', () => expect(reports).to.deep.equal([{ type: 'ready' }]));
});
