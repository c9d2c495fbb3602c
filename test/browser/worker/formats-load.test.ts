import { expect } from '@esm-bundle/chai';
import { loadVolume } from '../../../src/worker/load.ts';
import type { LoadProgress, LoadRequest } from '../../../src/worker/load.ts';
import { loadSurface } from '../../../src/worker/load-surface.ts';
import type { SurfaceRequest } from '../../../src/worker/surface-request.ts';
import { endSpare } from '../../../src/worker/spare-worker.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { expectError, fetchFixture, roomyLimits } from '../../helpers/decode.ts';
import { fetchSharedData } from '../../helpers/shared-data.ts';
import { loads } from '../../../src/viewer/loading/load-queue.ts';
import { hgtBytes } from '../../helpers/terrain.ts';

const fixture = (path: string): string => `/test/fixtures/${path}`;

function load(
  request: Partial<LoadRequest> & { url: string },
  onProgress: (p: LoadProgress) => void = () => undefined,
  signal = new AbortController().signal,
): Promise<Volume> {
  return loadVolume({ limits: roomyLimits, ...request }, { signal, onProgress });
}

/** Run with another `Worker` constructor, and count how many are started and terminated. No worker of other tests is used. */
async function withWorkers<T>(
  adapt: (native: typeof Worker) => unknown,
  run: (count: { started: number; terminated: number }) => Promise<T>,
): Promise<T> {
  endSpare();
  const native = globalThis.Worker;
  const count = { started: 0, terminated: 0 };
  const base = adapt(native) as typeof Worker;
  globalThis.Worker = class extends base {
    constructor(...args: ConstructorParameters<typeof Worker>) {
      super(...args);
      count.started++;
    }
    override terminate(): void {
      count.terminated++;
      super.terminate();
    }
  };
  try {
    return await run(count);
  } finally {
    endSpare();
    globalThis.Worker = native;
  }
}

/** As in a page whose policy or origin allows no workers. */
const refused = (): unknown =>
  function refuse() {
    throw new DOMException('no workers', 'SecurityError');
  };
const pause = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));
const unchanged = (native: typeof Worker): unknown => native;

describe('loadVolume', () => {
  it('loads in a worker, which is kept for the next load', () =>
    withWorkers(unchanged, async (count) => {
      const seen: LoadProgress[] = [];
      const volume = await load({ url: fixture('nifti/v1-le-gz.nii.gz') }, (p) => seen.push(p));
      expect(volume.grid.dimensions).to.deep.equal([3, 4, 5]);
      expect(volume.histogram.counts.reduce((sum, n) => sum + n, 0)).to.equal(60);
      expect(volume.range).to.deep.equal([0, 59]);
      expect(count).to.deep.equal({ started: 1, terminated: 0 });
      expect(new Set(seen.map((p) => p.phase))).to.deep.equal(new Set(['fetch', 'decode']));
      const fetched = seen.filter((p) => p.phase === 'fetch').pop()!;
      expect(fetched.loaded).to.equal((await fetchFixture('nifti/v1-le-gz.nii.gz')).length);
      expect(fetched.total).to.be.oneOf([0, fetched.loaded]);
    }));

  it('takes blob: and data: URLs', async () => {
    const bytes = await fetchFixture('mosaic/gray-3x2.png');
    const mosaic = { columns: 3, rows: 2 };
    const blob = URL.createObjectURL(new Blob([bytes]));
    expect((await load({ url: blob, settings: { mosaic } })).grid.dimensions).to.deep.equal([4, 4, 6]);
    URL.revokeObjectURL(blob);
    const data = `data:image/png;base64,${btoa(String.fromCharCode(...bytes))}`;
    expect((await load({ url: data, settings: { mosaic } })).grid.dimensions).to.deep.equal([4, 4, 6]);
  });

  for (const name of ['flat-3x2.jpg', 'flat-3x2.webp']) {
    it(`decodes ${name} in the worker`, async () => {
      const volume = await load({ url: fixture(`mosaic/${name}`), settings: { mosaic: { columns: 3, rows: 2 } } });
      expect(volume.grid.dimensions).to.deep.equal([32, 32, 6]);
    });
  }

  it('reads a manifest, whose image is relative to it', async () => {
    const volume = await load({ url: fixture('mosaic/gray-3x2.json') });
    expect(volume.grid.dimensions).to.deep.equal([4, 4, 5]);
    expect(volume.title).to.equal('Six tiles');
  });

  it('makes a volume smaller that the device does not hold', async () => {
    const volume = await load({ url: fixture('nifti/v1-le-i2.nii'), limits: { ...roomyLimits, maxVoxelsPerAxis: 3 } });
    expect(volume.reduced).to.deep.equal({ from: [3, 4, 5], to: [3, 2, 3] });
    expect(volume.grid.dimensions).to.deep.equal([3, 2, 3]);
  });
});

describe('one load after another', () => {
  it('has the same worker, also after one that failed, and has its own result', () =>
    withWorkers(unchanged, async (count) => {
      const first = await load({ url: fixture('nifti/v1-le-gz.nii.gz') });
      expect((await expectError(load({ url: fixture('missing.nii') }))).code).to.equal('source/not-found');
      const text = URL.createObjectURL(new Blob(['just text'], { type: 'text/plain' }));
      expect((await expectError(load({ url: text }))).code).to.equal('format/unknown');
      const second = await load({ url: fixture('mosaic/gray-3x2.png'), settings: { mosaic: { columns: 3, rows: 2 } } });
      expect([first.grid.dimensions, second.grid.dimensions]).to.deep.equal([
        [3, 4, 5],
        [4, 4, 6],
      ]);
      expect(first.samples.length).to.equal(60);
      expect(count).to.deep.equal({ started: 1, terminated: 0 });
    }));

  it('twenty at once, as those of a page, have as many workers as places in the queue', () =>
    withWorkers(unchanged, async (count) => {
      const { signal } = new AbortController();
      const volumes = await Promise.all(
        Array.from({ length: 20 }, () =>
          loads.run(
            () => true,
            signal,
            () => load({ url: fixture('nifti/v1-le-gz.nii.gz') }),
          ),
        ),
      );
      expect(volumes.map(({ samples }) => samples.length)).to.deep.equal(volumes.map(() => 60));
      expect(count.started).to.equal(loads.max);
      expect(count.terminated).to.equal(loads.max - 1);
    }));
});

describe('a worker that read a large file', () => {
  it('is not kept: its memory would come back late', () =>
    withWorkers(unchanged, async (count) => {
      const file = new Blob([await fetchFixture('nifti/v1-le-i2.nii'), new Uint8Array(5 * 2 ** 20)]);
      const url = URL.createObjectURL(file);
      expect((await load({ url })).samples.length).to.equal(60);
      URL.revokeObjectURL(url);
      expect(count).to.deep.equal({ started: 1, terminated: 1 });
    }));
});

describe('loadVolume that is stopped', () => {
  it('is rejected at once with the reason, and its worker takes the next one', () =>
    withWorkers(unchanged, async (count) => {
      const controller = new AbortController();
      const loading = load({ url: fixture('nifti/v1-le-gz.nii.gz') }, () => undefined, controller.signal);
      controller.abort();
      const error = await loading.then(
        () => null,
        (reason: unknown) => reason,
      );
      expect(error).to.be.instanceOf(DOMException).with.property('name', 'AbortError');
      await pause(400); // It has half a second to answer.
      expect((await load({ url: fixture('nifti/v1-le-gz.nii.gz') })).range).to.deep.equal([0, 59]);
      expect(count).to.deep.equal({ started: 1, terminated: 0 });
    }));

  it('does not delay the next one, which has another worker', () =>
    withWorkers(unchanged, async (count) => {
      const controller = new AbortController();
      const limits = new Promise<never>(() => {}); // It can't end by itself.
      const seen = new Promise<void>((resolve) => {
        load({ url: fixture('nifti/v1-le-gz.nii.gz'), limits }, () => resolve(), controller.signal).catch(() => {});
      });
      await seen;
      controller.abort();
      expect((await load({ url: fixture('nifti/v1-le-gz.nii.gz') })).range).to.deep.equal([0, 59]);
      expect(count.started).to.equal(2);
    }));

  it('leaves its limits to nobody, where they become known later', () =>
    withWorkers(unchanged, async (count) => {
      const controller = new AbortController();
      let resolveLimits: (limits: LoadRequest['limits']) => void = () => undefined;
      const limits = new Promise<never>((resolve) => (resolveLimits = resolve as never));
      const loading = load({ url: fixture('nifti/v1-le-i2.nii'), limits }, () => controller.abort(), controller.signal);
      expect(await loading.catch((reason: unknown) => reason)).to.have.property('name', 'AbortError');
      await pause(400);
      const next = load({ url: fixture('nifti/v1-le-i2.nii'), limits: pause(50).then(() => roomyLimits) });
      resolveLimits({ ...roomyLimits, maxVoxelsPerAxis: 3 });
      expect((await next).grid.dimensions).to.deep.equal([3, 4, 5]);
      expect(count.started).to.equal(1);
    }));

  it('ends a worker that does not hear', async () => {
    let isFirst = true;
    const hanging = (native: typeof Worker): unknown =>
      class extends native {
        constructor(url: string | URL, options?: WorkerOptions) {
          const text = new Blob(['postMessage({ type: "ready" }); onmessage = () => { for (;;); };']);
          super(isFirst ? URL.createObjectURL(text) : url, isFirst ? {} : options);
          isFirst = false;
        }
      };
    await withWorkers(hanging, async (count) => {
      const controller = new AbortController();
      const loading = load({ url: fixture('nifti/v1-le-i2.nii') }, () => undefined, controller.signal);
      await pause(100);
      controller.abort();
      expect(await loading.catch((reason: unknown) => reason)).to.have.property('name', 'AbortError');
      expect(count).to.deep.equal({ started: 1, terminated: 0 });
      await pause(700);
      expect(count).to.deep.equal({ started: 1, terminated: 1 });
      expect((await load({ url: fixture('nifti/v1-le-i2.nii') })).grid.dimensions).to.deep.equal([3, 4, 5]);
      expect(count).to.deep.equal({ started: 2, terminated: 1 });
    });
  });

  it('starts nothing where it was stopped before', () =>
    withWorkers(unchanged, async (count) => {
      const error = await load({ url: fixture('x.nii') }, () => undefined, AbortSignal.abort('no more')).then(
        () => null,
        (reason: unknown) => reason,
      );
      expect(error).to.equal('no more');
      expect(count.started).to.equal(0);
    }));

  it('on the main thread too', () =>
    withWorkers(refused, async () => {
      const controller = new AbortController();
      const loading = load(
        { url: fixture('nifti/v1-le-gz.nii.gz') },
        (p) => p.phase === 'decode' && controller.abort(),
        controller.signal,
      );
      const error = await loading.then(
        () => null,
        (reason: unknown) => reason,
      );
      expect(error).to.have.property('name', 'AbortError');
    }));
});

describe('loadVolume without workers', () => {
  const failing = (native: typeof Worker): unknown =>
    class extends native {
      constructor() {
        super(URL.createObjectURL(new Blob(['throw 0'])), {});
      }
    };

  for (const [what, adapt] of [
    ['can not be constructed', refused],
    ['fail before their first message', failing],
  ] as const) {
    it(`does the same on the main thread where they ${what}`, () =>
      withWorkers(adapt, async () => {
        for (const path of ['nifti/v1-le-gz.nii.gz', 'mosaic/flat-3x2.jpg', 'mosaic/gray-3x2.json']) {
          const volume = await load({
            url: fixture(path),
            settings: path.endsWith('jpg') ? { mosaic: { columns: 3, rows: 2 } } : undefined,
          });
          expect(volume.range[1]).to.be.greaterThan(0);
        }
        const error = await expectError(load({ url: fixture('missing.nii') }));
        expect(error.code).to.equal('source/not-found');
      }));
  }
});

describe('loadSurface', () => {
  const mesh = (): SurfaceRequest => ({
    surface: 'mesh',
    url: new URL(fixture('meshes/scene.glb'), location.href).href,
    space: null,
  });
  const terrain = (): SurfaceRequest => {
    const url = URL.createObjectURL(
      new Blob([hgtBytes((north, east) => 900 + 600 * Math.sin(9 * north) * Math.cos(7 * east))]),
    );
    return {
      surface: 'terrain',
      url,
      files: [url],
      corner: [46, 7],
      radar: { site: { latitude: 46.4, longitude: 7.5 }, height: 800, reach: 25_000, exaggeration: 2 },
    };
  };

  /** How often this thread itself asks for a file. */
  async function countFetches(run: () => Promise<void>): Promise<number> {
    const native = globalThis.fetch;
    let count = 0;
    globalThis.fetch = (...args) => (count++, native(...args));
    try {
      await run();
    } finally {
      globalThis.fetch = native;
    }
    return count;
  }

  for (const [what, requestOf, triangles] of [
    ['a mesh', mesh, 1],
    ['terrain', terrain, 1000],
  ] as const) {
    for (const [where, adapt, expected] of [
      [
        'in a worker, which is kept for the next load: the page reads nothing',
        unchanged,
        { workers: { started: 1, terminated: 0 }, fetches: 0 },
      ],
      [
        'on the main thread where a page allows no worker',
        refused,
        { workers: { started: 0, terminated: 0 }, fetches: 1 },
      ],
    ] as const) {
      it(`reads ${what} ${where}`, () =>
        withWorkers(adapt, async (workers) => {
          const fetches = await countFetches(async () => {
            const surface = await loadSurface(requestOf(), {
              signal: new AbortController().signal,
              onProgress: () => undefined,
            });
            expect(surface.triangles).to.be.at.least(triangles);
          });
          expect({ workers, fetches }).to.deep.equal(expected);
        }));
    }
  }
});

describe('loadVolume of what is not there', () => {
  it('names the URL and the status of a missing file', async () => {
    const error = await expectError(load({ url: fixture('missing.nii.gz') }));
    expect(error.code).to.equal('source/not-found');
    expect(error.message).to.contain('missing.nii.gz').and.to.contain('404');
  });

  it('speaks of CORS where another origin does not answer', async () => {
    const error = await expectError(load({ url: 'http://127.0.0.1:9/x.nii' }));
    expect(error.code).to.equal('source/cross-origin');
    expect(error.message).to.contain('Access-Control-Allow-Origin');
  });

  it('says that a web page came instead of data', async () => {
    const url = URL.createObjectURL(new Blob(['<!doctype html><title>App</title>'], { type: 'text/html' }));
    const error = await expectError(load({ url }));
    expect(error.code).to.equal('format/unknown');
    expect(error.message).to.contain('web page');
  });

  it('refuses what is of no known type, and URLs that are none', async () => {
    const url = URL.createObjectURL(new Blob(['just text'], { type: 'text/plain' }));
    expect((await expectError(load({ url }))).code).to.equal('format/unknown');
    expect((await expectError(load({ url: 'http://' }))).code).to.equal('source/not-found');
    expect((await expectError(load({ url: 'blob:nothing' }))).code).to.equal('source/not-found');
  });
});

describe('the time that real files take', () => {
  for (const [path, request] of [
    ['medical/mni152_nilearn/mni_icbm152_t1_tal_nlin_sym_09a_converted.nii.gz', {}],
    ['medical/aorta_mosaic/aorta4096.png', { settings: { mosaic: { columns: 10, rows: 10 }, slices: 96 } }],
  ] as const) {
    it(path, async function () {
      await fetchSharedData(this, path);
      const start = performance.now();
      const volume = await load({ url: `/shared-data/${path}`, ...request });
      console.log(`${path}: ${volume.grid.dimensions.join(' x ')} in ${Math.round(performance.now() - start)} ms`);
      expect(volume.samples).to.be.instanceOf(Uint8Array);
    });
  }
});
