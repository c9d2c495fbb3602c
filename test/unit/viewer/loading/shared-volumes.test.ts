import { expect } from '@esm-bundle/chai';
import { SharedVolumes } from '../../../../src/viewer/loading/shared-volumes.ts';
import type { LoadOptions } from '../../../../src/worker/load.ts';
import type { LoadProgress, LoadRequest } from '../../../../src/formats/base/load-request.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const request: LoadRequest = { url: 'a.nii', limits: { maxVoxelsPerAxis: 64, maxAtlasSize: null, maxBytes: 1e6 } };
const half: LoadProgress = { loaded: 1, total: 2, phase: 'fetch' };

/** A load that ends when it is told to. */
interface Load {
  readonly request: LoadRequest;
  readonly options: LoadOptions;
  readonly end: (volume: Volume) => void;
}

function start(): { shared: SharedVolumes; loads: Load[] } {
  const loads: Load[] = [];
  const shared = new SharedVolumes(
    (wanted, options) =>
      new Promise((resolve, reject) => {
        options.signal.addEventListener('abort', () => reject(options.signal.reason as Error));
        loads.push({ request: wanted, options, end: resolve });
      }),
  );
  return { shared, loads };
}

function some(): Volume {
  return syntheticVolume({ dimensions: [2, 2, 2], field: (x) => x });
}

function quietly(signal = new AbortController().signal): LoadOptions {
  return { signal, onProgress: () => {} };
}

async function turn(): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve));
}

describe('volumes that several elements show', () => {
  it('are loaded once, while the first is on its way and after', async () => {
    const { shared, loads } = start();
    const reported: LoadProgress[] = [];
    const volume = some();
    const first = shared.get({ name: 'first' }, request, quietly());
    const second = shared.get(
      { name: 'second' },
      { ...request },
      { ...quietly(), onProgress: (progress) => reported.push(progress) },
    );
    await turn();
    loads[0].options.onProgress(half);
    loads[0].end(volume);
    expect(await first).to.equal(volume);
    expect(await second).to.equal(volume);
    expect(reported).to.deep.equal([half]);
    expect(await shared.get({ name: 'third' }, request, quietly())).to.equal(volume);
    expect(loads.length).to.equal(1);
  });

  it('are loaded again for each element that fetches by a function of its page, and not given to others', async () => {
    const { shared, loads } = start();
    const withToken = (token: string): LoadOptions => ({
      ...quietly(),
      fetch: (address) => fetch(address, { headers: { authorization: token } }),
    });
    for (const options of [withToken('a'), withToken('b'), quietly()]) {
      const got = shared.get({ name: 'another' }, request, options);
      await turn();
      const volume = some();
      loads.at(-1)!.end(volume);
      expect(await got).to.equal(volume);
    }
    expect(loads.length).to.equal(3);
  });

  it('are others where anything that is asked for differs', async () => {
    const { shared, loads } = start();
    void shared.get({ name: 'first' }, request, quietly());
    void shared.get({ name: 'second' }, { ...request, settings: { spacing: [1, 1, 2] } }, quietly());
    await turn();
    expect(loads.length).to.equal(2);
  });

  it('are loaded again for an element that asks again, and where no element shows them any more', async () => {
    const { shared, loads } = start();
    const [one, other] = [{ name: 'one' }, { name: 'other' }];
    const volumes = [some(), some(), some()];
    const get = async (element: object, i: number): Promise<Volume> => {
      const loading = shared.get(element, request, quietly());
      await turn();
      loads[i]?.end(volumes[i]);
      return loading;
    };
    expect(await get(one, 0)).to.equal(volumes[0]);
    expect(await get(one, 1), 'again').to.equal(volumes[1]);
    expect(await get(other, 2), 'the other takes the new one').to.equal(volumes[1]);
    shared.release(one);
    shared.release(other);
    expect(await get({ name: 'third' }, 2)).to.equal(volumes[2]);
  });

  it('go on for the others where the first gives up, and one that waits may give up', async () => {
    const { shared, loads } = start();
    const [firstStops, secondStops] = [new AbortController(), new AbortController()];
    const first = shared.get({ name: 'first' }, request, quietly(firstStops.signal)).catch((error: unknown) => error);
    const second = shared
      .get({ name: 'second' }, request, quietly(secondStops.signal))
      .catch((error: unknown) => error);
    const others = [1, 2].map((n) => shared.get({ name: `other ${n}` }, request, quietly()));
    await turn();
    secondStops.abort(new Error('gone'));
    expect(await second).to.have.property('message', 'gone');
    firstStops.abort(new Error('gone too'));
    expect(await first).to.have.property('message', 'gone too');
    await turn();
    expect(loads.length, 'one load for all that are left').to.equal(2);
    const volume = some();
    loads[1].end(volume);
    expect(await Promise.all(others)).to.deep.equal([volume, volume]);
  });

  it('fail for all who wait where they fail, and are not asked for once more', async () => {
    const requests: LoadRequest[] = [];
    let fail: (error: Error) => void = () => {};
    const shared = new SharedVolumes(
      (wanted) =>
        new Promise((_, reject) => {
          requests.push(wanted);
          fail = reject;
        }),
    );
    const all = [1, 2, 3].map((n) =>
      shared.get({ name: String(n) }, request, quietly()).catch((error: Error) => error.message),
    );
    await turn();
    fail(new Error('stalled'));
    expect(await Promise.all(all)).to.deep.equal(['stalled', 'stalled', 'stalled']);
    expect(requests.length).to.equal(1);
  });

  it('are shared by an element too that gave up before it had one', async () => {
    const { shared, loads } = start();
    const stops = new AbortController();
    const element = { name: 'moved within the page' };
    const first = shared.get(element, request, quietly(stops.signal)).catch(() => null);
    stops.abort(new Error('gone'));
    await first;
    const other = shared.get({ name: 'other' }, request, quietly());
    const again = shared.get(element, request, quietly());
    await turn();
    expect(loads.length).to.equal(2);
    loads[1].end(some());
    expect(await again).to.equal(await other);
  });

  it("are each element's own where the source has several scans", async () => {
    const { shared, loads } = start();
    const first = shared.get({ name: 'first' }, request, quietly());
    const second = shared.get({ name: 'second' }, request, quietly());
    await turn();
    loads[0].options.onScans?.([]);
    loads[0].end(some());
    await first;
    await turn();
    loads[1].options.onScans?.([]);
    loads[1].end(some());
    expect(await second).not.to.equal(await first);
    void shared.get({ name: 'third' }, request, quietly());
    await turn();
    expect(loads.length).to.equal(3);
  });
});
