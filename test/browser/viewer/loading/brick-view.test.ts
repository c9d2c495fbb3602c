// An OME-Zarr that is larger than its page allows: a coarse level as a whole, then bricks as the view needs them. The page's own function fetches.
import { expect } from '@esm-bundle/chai';
import { gzipSync } from 'fflate';
import '../../../../components/volume-slice/define.ts';
import '../../../../components/volume-slice-view/define.ts';
import '../../../../components/volume-view/define.ts';
import type { VolumeView } from '../../../../components/volume-view/volume-view.ts';
import { makeOmeZarr } from '../../../../src/prepare/write-ome-zarr.ts';
import type { RenderStats } from '../../../../src/viewer/model/render-stats.ts';
import { maxContexts } from '../../../../src/viewer/scenes/context-pool.ts';
import { countGpuBytes } from '../../../bench/count-gpu-bytes.mjs';
import { compareCovered } from '../../../helpers/covered-error.ts';
import { formulaFiles, formulaOf } from '../../../helpers/formula-pyramid.ts';
import type { FormulaPyramid } from '../../../helpers/formula-pyramid.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

countGpuBytes();
const { gpuBytes } = window as unknown as { gpuBytes: () => { in3d: { now: number; most: number } } };

/** Fetches from a formula, and counts. */
function serve(pyramid: FormulaPyramid, delay = 0) {
  const files = formulaFiles(formulaOf(pyramid));
  const log = { alive: 0, asked: 0, most: 0, byLevel: [] as number[] };
  const fetch = async (url: RequestInfo | URL, init?: RequestInit): Promise<Response> => {
    const path = new URL(url as string).pathname.slice('/x.ome.zarr/'.length);
    log.alive++;
    log.asked++;
    log.most = Math.max(log.most, log.alive);
    const level = Number(path[0]);
    if (/^\d\/c/.test(path)) log.byLevel[level] = (log.byLevel[level] ?? 0) + 1;
    try {
      if (delay)
        await new Promise<void>((resolve, reject) => {
          setTimeout(resolve, delay);
          init?.signal?.addEventListener('abort', () => reject(init.signal!.reason as Error));
        });
      const size = files.sizeOf(path);
      return size === null ? new Response(null, { status: 404 }) : new Response(files.bytesOf(path, 0, size));
    } finally {
      log.alive--;
    }
  };
  return { fetch, log };
}

function addView(fetch: typeof globalThis.fetch, attributes: Record<string, string>): VolumeView {
  const view = document.createElement('volume-view');
  view.fetch = fetch;
  view.style.cssText = 'display: block; width: 96px; height: 72px';
  for (const [name, value] of Object.entries({
    alt: 'waves',
    src: 'https://example.test/x.ome.zarr/',
    loading: 'eager',
    ...attributes,
  }))
    view.setAttribute(name, value);
  document.body.append(view);
  return view;
}

/** A final picture and what is said of it, of a view that leaves again. */
async function drawOnce(
  fetch: typeof globalThis.fetch,
  attributes: Record<string, string>,
  [width, height]: readonly [number, number],
  inner = '',
): Promise<{ shown: Float64Array; stats: RenderStats }> {
  const view = addView(fetch, attributes);
  view.style.cssText = `display: block; width: ${width}px; height: ${height}px`;
  view.innerHTML = inner;
  await view.whenRendered();
  const result = { shown: await pixelsOf(view), stats: view.renderStats! };
  view.remove();
  return result;
}

/** RGBA, premultiplied: in a nearly clear pixel, colours that are not premultiplied differ by much where nobody sees it. */
async function pixelsOf(view: VolumeView): Promise<Float64Array> {
  const bitmap = await createImageBitmap(await view.toBlob());
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  return Float64Array.from(data, (x, i) => (i % 4 === 3 ? x : (x * data[i - (i % 4) + 3]) / 255));
}

function compare(one: ArrayLike<number>, other: ArrayLike<number>): { worst: number; rms: number } {
  let [worst, sum] = [0, 0];
  for (let i = 0; i < one.length; i++) {
    worst = Math.max(worst, Math.abs(one[i] - other[i]));
    sum += (one[i] - other[i]) ** 2;
  }
  return { worst, rms: Math.sqrt(sum / one.length) };
}

const look = {
  steps: '200',
  'transfer-function': '0 #247 0, 255 #f42 40%',
  'camera-orbit': '30deg 65deg 150',
};

/** Steps along the diagonal of 128 voxels. */
const oneAVoxel = 222;

/** Of 128 voxels, with steps by `max-error`. */
const fromAfar = { 'transfer-function': look['transfer-function'], 'camera-orbit': '30deg 65deg 300' };

describe('a pyramid in bricks on a page', () => {
  it('is read for planes in a clear volume, also where one lies between bricks, and says what they lack', async function () {
    this.timeout(90_000);
    const { fetch } = serve({ dimensions: [128, 128, 128], levels: 2 });
    const planes =
      '<volume-slice type="axial" value-window="0 255"></volume-slice><volume-slice type="coronal" at="7" value-window="0 255"></volume-slice>';
    const clear = { ...fromAfar, 'camera-orbit': '30deg 65deg 220', 'opacity-factor': '0' };
    const draw = (attributes: Record<string, string>): ReturnType<typeof drawOnce> =>
      drawOnce(fetch, { ...clear, ...attributes }, [288, 216], planes);
    const { shown: whole } = await draw({});
    const [enough, few] = [
      await draw({ 'max-gpu-bytes': '2.05e6', 'max-error': '1' }),
      await draw({ 'max-gpu-bytes': '0.6e6', 'max-error': '1' }),
    ];
    const errorOf = ({ shown }: typeof few): number => compareCovered(shown, whole, 1, 3).rms;
    const stated = ({ stats }: typeof few): number => stats.error!.parts!.detail!.rms;
    console.log(
      `planes: ${[enough, few].map((one) => `${errorOf(one).toFixed(2)}, stated ${stated(one).toFixed(2)}, ${JSON.stringify(one.stats.bricks)}`).join('; ')}`,
    );
    expect(stated(enough)).to.be.at.most(1);
    expect(errorOf(enough)).to.be.at.most(2);
    expect(errorOf(few), 'few bricks').to.be.above(3);
    expect(stated(few) / errorOf(few)).to.be.within(0.5, 3);
  });

  const grey = '0 #000 100%, 255 #fff 100%';
  const otherPictures: Record<string, readonly [attributes: Record<string, string>, inner?: string]> = {
    'the largest value': [{ projection: 'max', 'transfer-function': grey }],
    'the smallest value': [{ projection: 'min', 'transfer-function': '0 #fff 100%, 255 #000 100%' }],
    'what is opaque where values change': [{ 'gradient-opacity': '6 0, 14 1' }],
    'values and gradients': [{ 'transfer-function-2d': 'box 60 190 10 20 #fd8 30%' }],
    'a silhouette': [
      { 'transfer-function': '0 #fd8 0, 100 #fd8 0, 140 #fd8 60%, 255 #fd8 60%' },
      '<SilhouetteEnhancementVolumeStyle silhouetteRetainedOpacity="0.02" silhouetteBoundaryOpacity="1" silhouetteSharpness="2"></SilhouetteEnhancementVolumeStyle>',
    ],
    'a cartoon': [
      { 'transfer-function': '0 #fd8 0, 100 #fd8 0, 140 #fd8 100%, 255 #fd8 100%' },
      '<CartoonVolumeStyle></CartoonVolumeStyle>',
    ],
  };
  for (const [name, [attributes, inner = '']] of Object.entries(otherPictures))
    it(`is read for ${name}, and says what is missing`, async function () {
      this.timeout(90_000);
      const { fetch } = serve({ dimensions: [128, 128, 128], levels: 2 });
      const draw = (more: Record<string, string>): ReturnType<typeof drawOnce> =>
        drawOnce(fetch, { ...fromAfar, shading: 'unlit', 'max-error': '1', ...attributes, ...more }, [160, 120], inner);
      const { shown: whole } = await draw({});
      const [enough, few] = [await draw({ 'max-gpu-bytes': '2.05e6' }), await draw({ 'max-gpu-bytes': '0.6e6' })];
      const errorOf = ({ shown }: typeof few): number => compareCovered(shown, whole, 1, 3).rms;
      const stated = ({ stats }: typeof few): number => stats.error!.rms;
      console.log(
        `${name}: ${[enough, few].map((one) => `${errorOf(one).toFixed(2)}, stated ${stated(one).toFixed(2)}, ${one.stats.steps} × ${one.stats.substeps} steps, ${JSON.stringify(one.stats.bricks)}`).join('; ')}`,
      );
      expect(errorOf(few), 'few bricks').to.be.above(5);
      expect(few.stats.steps * few.stats.substeps, 'steps where bricks hide more').to.equal(oneAVoxel);
      expect(stated(few) / errorOf(few)).to.be.within(1 / 2, 2);
      expect(stated(enough)).to.be.below(stated(few) / 2);
      expect(errorOf(enough)).to.be.at.most(3 + 1.5 * stated(enough));
    });

  it('is the picture of the whole, where all bricks that are visible fit', async function () {
    this.timeout(90_000);
    const { fetch, log } = serve({ dimensions: [96, 96, 96], levels: 2 });
    // A third of the volume is cut away: its bricks need no room.
    const cut = { ...look, 'camera-orbit': '30deg 65deg 220', cutout: '-48 -48 -48 48 48 -16' };
    const whole = addView(fetch, cut);
    await whole.whenRendered();
    expect(whole.volume!.dimensions).to.deep.equal([96, 96, 96]);
    const expected = await pixelsOf(whole);
    whole.remove();
    const view = addView(fetch, { ...cut, 'max-gpu-bytes': '880000', 'max-error': '0.01' });
    await view.whenRendered();
    expect(view.volume!.dimensions).to.deep.equal([48, 48, 48]);
    expect(view.renderStats!.converged).to.equal(true);
    expect(view.renderStats!.bricks!.bytes).to.be.at.most(880_000);
    const shown = await pixelsOf(view);
    const { worst, rms } = compare(shown, expected);
    console.log(
      `bricked against whole: worst ${worst}, rms ${rms.toFixed(3)}; ${JSON.stringify(log)}; ${JSON.stringify(view.renderStats)}`,
    );
    const { parts } = view.renderStats!.error!;
    view.remove();
    expect(worst).to.be.at.most(1.01);
    expect(parts!.detail!.rms).to.be.below(0.3);
  });

  it('states what the bricks hide that are not there', async function () {
    this.timeout(90_000);
    const { fetch, log } = serve({ dimensions: [128, 128, 128], levels: 3 });
    const shown: Record<string, Float64Array> = {};
    let said = 0;
    const ways: Record<string, Record<string, string>> = {
      whole: {},
      bricked: { 'max-gpu-bytes': '1e6', 'max-error': '4' },
    };
    for (const [name, more] of Object.entries(ways)) {
      const view = addView(fetch, { ...look, 'camera-orbit': '30deg 65deg 300', ...more });
      await view.whenRendered();
      shown[name] = await pixelsOf(view);
      const { error, converged, keepsMaxError } = view.renderStats!;
      if (name === 'bricked') {
        expect([converged, keepsMaxError]).to.deep.equal([true, true]);
        const { steps, detail } = error!.parts!;
        said = detail!.rms;
        expect(error!.rms).to.be.closeTo(Math.hypot(steps.rms, said), 1e-9);
        expect([error!.max, detail!.max]).to.deep.equal([null, null]);
      } else expect(error!.parts).to.equal(undefined);
      view.remove();
    }
    const { rms } = compareCovered(shown.bricked, shown.whole, 1);
    console.log(`bricks hide ${rms.toFixed(2)}, stated ${said.toFixed(2)}; ${JSON.stringify(log)}`);
    expect(said).to.be.within(0.2, 4);
    expect(said / rms).to.be.within(1 / 3, 3);
  });

  it('shows single bright voxels that leave no trace in coarse levels, where the writer of the pyramid says where they are', async function () {
    this.timeout(90_000);
    const random = randomNumbers(5);
    const edge = 128;
    const volume = syntheticVolume({
      dimensions: [edge, edge, edge],
      slope: 255,
      field: (x) => (x > 0.5 && random() < 0.001 ? 1 : 0.1),
    });
    const files = new Map(makeOmeZarr(volume, (bytes) => gzipSync(bytes)).files);
    const asked: string[] = [];
    const fetch = async (url: RequestInfo | URL): Promise<Response> => {
      const path = new URL(url as string).pathname.slice('/x.ome.zarr/'.length);
      asked.push(path);
      const bytes = files.get(path);
      return bytes ? new Response(bytes as Uint8Array<ArrayBuffer>) : new Response(null, { status: 404 });
    };
    const shown: Float64Array[] = [];
    let bricked: RenderStats | null = null;
    const ways: Record<string, string>[] = [{}, { 'max-gpu-bytes': '2090000' }];
    for (const more of ways) {
      const view = addView(fetch, {
        'transfer-function': '0 #247 0, 120 #247 0, 150 #fd8 100%, 255 #fff 100%',
        'camera-orbit': '30deg 65deg 300',
        ...more,
      });
      await view.whenRendered();
      shown.push(await pixelsOf(view));
      bricked = view.renderStats;
      view.remove();
    }
    const { rms } = compareCovered(shown[1], shown[0], 1);
    const said = bricked!.error!.parts!.detail!.rms;
    console.log(`specks: ${rms.toFixed(2)} missing, ${said.toFixed(2)} stated`);
    expect(asked).to.include('volume-view/residual-rms-1/zarr.json');
    expect(bricked!.converged).to.equal(true);
    expect(rms).to.be.below(1.5);
    expect(said).to.be.below(1);
  });

  it('has panes as fine as those of the whole, and picks of the finest voxel, whatever bricks the picture needs', async function () {
    this.timeout(90_000);
    const { fetch, log } = serve({ dimensions: [128, 128, 128], levels: 3 });
    const far = { ...look, 'camera-orbit': '30deg 65deg 300' };
    const shown: { pane: Uint8ClampedArray; thick: Uint8ClampedArray; value: number; paneValue: number }[] = [];
    const ways: Record<string, string>[] = [{}, { 'max-gpu-bytes': '1e6', 'max-error': '32' }];
    for (const more of ways) {
      const view = addView(fetch, { ...far, ...more });
      view.id = 'shown';
      const pane = document.createElement('volume-slice-view');
      pane.style.cssText = 'width: 160px; height: 160px';
      for (const [name, value] of Object.entries({
        for: 'shown',
        type: 'coronal',
        'value-window': '40 220',
        cursor: '3.5 10.5 -7.5',
      }))
        pane.setAttribute(name, value);
      document.body.append(pane);
      await view.whenRendered();
      const paint = async (): Promise<Uint8ClampedArray> => {
        await pane.whenRendered();
        const canvas = pane.shadowRoot!.querySelector('canvas')!;
        return canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height).data;
      };
      const cursor = new Promise<number>((resolve) =>
        pane.addEventListener(
          'cursor-change',
          (event) => resolve((event as CustomEvent<{ value: number }>).detail.value),
          { once: true },
        ),
      );
      const plain = await paint();
      pane.setAttribute('thickness', '6');
      pane.setAttribute('projection', 'max');
      const thick = await paint();
      pane.setAttribute('cursor', '3.5 10.5 -6.5');
      const paneValue = await cursor;
      const value = (await view.pick(48, 36))!.value;
      shown.push({ pane: plain, thick, value, paneValue });
      if (more['max-gpu-bytes']) {
        expect(view.volume!.dimensions).to.deep.equal([32, 32, 32]);
        console.log(`levels asked for: ${JSON.stringify(log.byLevel)}`);
      }
      pane.remove();
      view.remove();
    }
    const [whole, bricked] = shown;
    expect(compare(bricked.pane, whole.pane).worst).to.be.at.most(1);
    // Bricks are sampled at planes, the whole exactly between them.
    expect(compare(bricked.thick, whole.thick).rms).to.be.below(6);
    expect(bricked.paneValue).to.equal(whole.paneValue);
    expect(bricked.value).to.be.closeTo(whole.value, 40);
    await new Promise((resolve) => setTimeout(resolve, 50));
    expect(log.alive).to.equal(0);
  });

  it('asks for nothing that is finer than half a pixel, asks for it as soon as the view is larger, and lets go of it again', async function () {
    this.timeout(90_000);
    const { fetch, log } = serve({ dimensions: [128, 128, 128], levels: 3 });
    const view = addView(fetch, {
      ...fromAfar,
      'max-gpu-bytes': '1e6',
      'max-error': '0.05',
    });
    view.style.cssText = 'display: block; width: 32px; height: 24px';
    await view.whenRendered();
    expect(view.renderStats!.converged).to.equal(true);
    expect(view.renderStats!.error!.parts!.detail!.rms).to.be.at.most(0.05);
    expect([log.byLevel[0] ?? 0, log.byLevel[1] > 0]).to.deep.equal([0, true]);
    const { steps } = view.renderStats!;
    view.style.cssText = 'display: block; width: 160px; height: 120px';
    const end = performance.now() + 75_000;
    while (!(log.byLevel[0] > 0) && performance.now() < end) await new Promise((resolve) => setTimeout(resolve, 50));
    await view.whenRendered();
    expect(log.byLevel[0]).to.be.above(0);
    expect(view.renderStats!.steps).to.be.above(1.5 * steps);
    // The next coarser level stays: it has eight bricks.
    expect(view.renderStats!.bricks!.count).to.be.above(8);
    view.style.cssText = 'display: block; width: 8px; height: 6px';
    while (view.renderStats!.bricks!.count > 8 && performance.now() < end)
      await new Promise((resolve) => setTimeout(resolve, 50));
    await view.whenRendered();
    expect(view.renderStats!.bricks!.count).to.be.within(1, 8);
    view.remove();
  });

  it('comes to rest after each turn, though moving pictures have another shape', async function () {
    this.timeout(90_000);
    const { fetch } = serve({ dimensions: [128, 128, 128], levels: 3 });
    const view = addView(fetch, {
      ...fromAfar,
      'max-gpu-bytes': '1900000',
      'max-error': '4',
    });
    view.style.cssText = 'display: block; width: 331px; height: 173px';
    await view.whenRendered();
    const shapes = new Set<string>();
    view.addEventListener('render', () => shapes.add((view.renderStats!.width / view.renderStats!.height).toFixed(4)));
    for (const orbit of ['50deg 60deg 300', '20deg 40deg 280']) {
      view.setAttribute('camera-orbit', orbit);
      await view.whenRendered();
      expect(view.renderStats!.converged).to.equal(true);
    }
    expect(shapes.size, [...shapes].join()).to.be.above(1);
    let drawn = 0;
    view.addEventListener('render', () => drawn++);
    await new Promise((resolve) => setTimeout(resolve, 1500));
    view.remove();
    expect(drawn).to.equal(0);
  });

  it('is final in each of twelve views, more than a page has contexts, within the bytes that they share', async function () {
    this.timeout(240_000);
    const { fetch } = serve({ dimensions: [256, 256, 256], levels: 4 }, 5);
    const most = 6e6;
    const attributes = {
      'transfer-function': look['transfer-function'],
      'camera-orbit': '30deg 65deg 600',
      'max-gpu-bytes': String(most),
      'max-error': '0.1',
    };
    gpuBytes();
    const views = Array.from({ length: 2 * maxContexts }, () => addView(fetch, attributes));
    for (const view of views) view.style.cssText = 'display: inline-block; width: 96px; height: 72px';
    let last = 0;
    for (const view of views) view.addEventListener('render', () => (last = performance.now()));
    await Promise.all(views.map((view) => view.whenRendered()));
    // A view whose share grows when others have left gets more bricks once more.
    const isQuiet = (): boolean =>
      performance.now() - last > 4000 && views.every((view) => view.renderStats!.converged);
    for (const end = performance.now() + 60_000; !isQuiet() && performance.now() < end;)
      await new Promise((resolve) => setTimeout(resolve, 100));
    expect(isQuiet()).to.equal(true);
    // One that has no context gets it back with its bricks: no picture is coarser than the one that was there.
    const left = views.find(({ shadowRoot }) => shadowRoot!.querySelector('x3d') === null)!;
    const counts: number[] = [];
    left.addEventListener('render', () => counts.push(left.renderStats!.bricks!.count));
    const { count } = left.renderStats!.bricks!;
    await left.redraw();
    await left.whenRendered();
    expect([Math.min(...counts), left.renderStats!.converged]).to.deep.equal([count, true]);
    for (const view of views) view.remove();
    await new Promise((resolve) => setTimeout(resolve, 500));
    const { in3d } = gpuBytes();
    expect(in3d.most).to.be.within(1, most);
    expect(in3d.now).to.equal(0);
  });

  for (const isMidway of [true, false])
    it(`has its picture again after a lost context, ${isMidway ? 'while bricks come' : 'at rest'}`, async function () {
      this.timeout(90_000);
      const { fetch, log } = serve({ dimensions: [128, 128, 128], levels: 3 }, 10);
      const attributes = { ...look, 'camera-orbit': '30deg 65deg 300', 'max-gpu-bytes': '1900000', 'max-error': '0.1' };
      const shown: Float64Array[] = [];
      let stated = 0;
      for (const isLost of [false, true]) {
        const view = addView(fetch, attributes);
        const lose = (): void => {
          const canvas = view.shadowRoot!.querySelector('canvas')!;
          canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!.loseContext();
        };
        if (isLost && isMidway) {
          while ((view.renderStats?.bricks?.count ?? 0) < 3) await new Promise((resolve) => setTimeout(resolve, 5));
          lose();
        }
        await view.whenRendered();
        if (isLost && !isMidway) {
          const { asked } = log;
          lose();
          await new Promise((resolve) => view.addEventListener('render', resolve, { once: true }));
          expect(view.renderStats!.bricks!.count, 'they are in memory').to.be.above(3);
          await view.whenRendered();
          console.log(`${log.asked - asked} files asked for again`);
        }
        expect(view.renderStats!.converged).to.equal(true);
        shown.push(await pixelsOf(view));
        stated += view.renderStats!.error!.rms;
        view.remove();
      }
      // Which bricks there are, where not all have room, depends on the order in which they came.
      expect(compareCovered(shown[1], shown[0], 1).rms).to.be.below(stated);
    });

  it('asks for at most 8 files at once, keeps what the page allows, and asks for nothing once it has left', async function () {
    this.timeout(90_000);
    const { fetch, log } = serve({ dimensions: [512, 512, 512], levels: 5 }, 20);
    const view = addView(fetch, {
      ...look,
      'camera-orbit': '30deg 65deg 1200',
      'max-gpu-bytes': '8e6',
      'max-error': '0.1',
    });
    const begun = new Promise((resolve) => view.addEventListener('load', resolve));
    await begun;
    expect(view.volume!.reduced).to.equal(undefined);
    // Until bricks come.
    while (log.byLevel.slice(0, 3).reduce((sum, n) => sum + (n ?? 0), 0) < 20) {
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    expect(view.renderStats?.converged ?? false).to.equal(false);
    view.remove();
    await new Promise((resolve) => setTimeout(resolve, 100));
    expect(log.alive).to.equal(0);
    const { asked } = log;
    await new Promise((resolve) => setTimeout(resolve, 300));
    expect(log.asked).to.equal(asked);
    expect(log.most).to.be.at.most(8);
  });
});
