// Bricks through a real worker. The page itself fetches, by a function, so that no server is needed.
import { expect } from '@esm-bundle/chai';
import { openBricks } from '../../../src/worker/open-bricks.ts';
import { allBricks, expectFormula, failureOf, noSignal } from '../../helpers/brick-stores.ts';
import { roomyLimits } from '../../helpers/decode.ts';
import { formulaFiles, formulaOf } from '../../helpers/formula-pyramid.ts';

const formula = formulaOf({ dimensions: [48, 40, 32], levels: 2 });
const files = formulaFiles(formula);
const request = { url: 'https://example.test/x.ome.zarr/', limits: roomyLimits };

/** Answers from the formula. */
const answer = (url: RequestInfo | URL): Response => {
  const path = new URL(url as string).pathname.slice('/x.ome.zarr/'.length);
  const size = files.sizeOf(path);
  return size === null ? new Response(null, { status: 404 }) : new Response(files.bytesOf(path, 0, size));
};

/** Workers that were started and ended. */
async function countWorkers(run: () => Promise<void>): Promise<[started: number, ended: number]> {
  const native = globalThis.Worker;
  let [started, ended] = [0, 0];
  globalThis.Worker = class extends native {
    constructor(...args: ConstructorParameters<typeof Worker>) {
      super(...args);
      started++;
    }
    override terminate(): void {
      ended++;
      super.terminate();
    }
  };
  try {
    await run();
  } finally {
    globalThis.Worker = native;
  }
  return [started, ended];
}

describe('a pyramid in bricks', () => {
  it('is read by one worker for all, which ends with the last of them', async () => {
    const counts = await countWorkers(async () => {
      const fetch = async (url: RequestInfo | URL): Promise<Response> => answer(url);
      const open = (): ReturnType<typeof openBricks> => openBricks(request, { signal: noSignal(), fetch });
      const [one, other] = await Promise.all([open(), open()]);
      one!.close();
      for (const brick of allBricks(other!)) await expectFormula(other!, formula, brick);
      other!.close();
      await new Promise((resolve) => setTimeout(resolve, 50));
    });
    expect(counts).to.deep.equal([1, 1]);
  });

  it('leaves no request alive: of a brick that is given up, and when it is closed', async () => {
    const alive = new Set<AbortSignal>();
    const fetch: typeof globalThis.fetch = async (url, init) => {
      const { signal } = init!;
      if ((url as string).endsWith('.json')) return answer(url);
      alive.add(signal!);
      return new Promise((_, reject) =>
        signal!.addEventListener('abort', () => {
          alive.delete(signal!);
          reject(signal!.reason as Error);
        }),
      );
    };
    const until = async (isSo: () => boolean): Promise<void> => {
      for (let n = 0; n < 500 && !isSo(); n++) await new Promise((resolve) => setTimeout(resolve, 10));
      expect(isSo()).to.equal(true);
    };
    const store = (await openBricks(request, { signal: noSignal(), fetch }))!;
    const moved = new AbortController();
    const given = failureOf(store.read({ level: 0, at: [0, 0, 0] }, moved.signal));
    await until(() => alive.size === 4);
    moved.abort(new Error('moved on'));
    expect(await given).to.include({ message: 'moved on' });
    await until(() => alive.size === 0);
    const other = failureOf(store.read({ level: 1, at: [0, 0, 0] }, noSignal()));
    await until(() => alive.size === 1);
    store.close();
    expect(await other).to.include({ name: 'AbortError' });
    await until(() => alive.size === 0);
  });

  it('is given up while its worker starts: who asked for it hears of it, and nobody else', async () => {
    let unheard = 0;
    const hear = (event: Event): void => {
      event.preventDefault();
      unheard++;
    };
    addEventListener('unhandledrejection', hear);
    for (const ms of [0, 1, 5]) {
      const asked = new AbortController();
      const opening = failureOf(openBricks(request, { signal: asked.signal, fetch: async (url) => answer(url) }));
      if (ms > 0) await new Promise((resolve) => setTimeout(resolve, ms));
      asked.abort(new Error('has left'));
      expect(await opening).to.include({ message: 'has left' });
    }
    await new Promise((resolve) => setTimeout(resolve, 100));
    removeEventListener('unhandledrejection', hear);
    expect(unheard).to.equal(0);
  });

  it('is none of what is no OME-Zarr', async () =>
    expect(await openBricks({ ...request, url: '/a.nii' }, { signal: noSignal() })).to.equal(null));
});
