// What `detail="free"` leaves out of pictures at rest, and what it says of it. `npm run accuracy -- trade` measures more of it.
import { expect } from '@esm-bundle/chai';
import { decode } from 'fast-png';
import { spareRays, tileMargin } from '../../../../src/quality/spare-rays.ts';
import { sparingTools } from '../../../helpers/sparing-tools.ts';
import { measureTrade } from '../../../accuracy/trade-page.ts';
import type { TradeResult } from '../../../accuracy/trade-page.ts';
import { canvasOf, placeElement, takeAtRest } from '../../../accuracy/element-picture.ts';
import type { ElementSetup } from '../../../accuracy/element-picture.ts';
import { loadHere, sightOf } from '../../../accuracy/small-page.ts';
import { errorScenes } from '../../../accuracy/error-scenes.ts';
import { changePlan, drawAt } from '../../../helpers/change-plan.ts';
import { withScene } from '../../../helpers/picture.ts';
import { finestSpacing } from '../../../../src/volume/grid.ts';

const errors: readonly number[] = [1, 4, 16];
const traded = (name: string): Promise<TradeResult[]> =>
  measureTrade(name, { details: ['keep', 'free'], errors }, () => {});

/** A small picture of an MRI. */
async function brain(attributes: Record<string, string>): Promise<ElementSetup> {
  const src = '/demos/data/mni152-t1.nii.gz';
  const volume = await loadHere(src);
  const pixels = 160;
  const sight = sightOf(volume, { pixels, pixelsPerVoxel: 0.7, theta: 30, phi: 75, ratio: 1 }, 0);
  return { src, sight, pixels, ratio: 1, attributes };
}

describe('detail="free"', () => {
  it('takes fewer steps and rays the more error is allowed, keeps this error, and states no largest one', async function () {
    this.timeout(120_000);
    const all = await traded('Lesions of low contrast, radius 2');
    const of = (detail: string): TradeResult[] => all.filter((one) => one.detail === detail);
    const work = of('free').map(({ stats: { rays, steps } }) => rays * steps);
    console.log(`rays times steps: ${work.map((one) => one.toFixed(0)).join(', ')}`);
    expect(work[1]).to.be.below(work[0]);
    expect(work[2]).to.be.at.most(work[1]);
    for (const [i, { maxError, e, stats }] of of('free').entries()) {
      const usual = of('keep')[i].stats;
      expect(usual.rays, 'kept rays').to.equal(1);
      expect(work[i], 'work').to.be.at.most(usual.steps);
      expect(e, `E at ${maxError}`).to.be.at.most(1.1 * maxError);
      expect(stats.keepsMaxError).to.equal(true);
      expect(stats.error!.rms).to.be.at.most(maxError);
      if (stats.rays < 1) expect(stats.error!.max, 'a bound').to.equal(null);
    }
  });

  it('is what `keep` is where small things are much of the error', async function () {
    this.timeout(120_000);
    const all = await traded('Wires of 1 voxel');
    for (const { maxError, detail, stats, e, things } of all) {
      expect(e, `${detail} at ${maxError}`).to.be.at.most(1.1 * maxError);
      if (maxError > 4) continue;
      expect(stats.rays, 'rays').to.equal(1);
      expect(
        things.filter(({ kept }) => kept < 0.25),
        'lost',
      ).to.deep.equal([]);
    }
  });

  it('keeps the error where few pixels have all of it: specks of a voxel, and a thin plate from its edge', async function () {
    this.timeout(120_000);
    for (const name of ['Specks of 1 voxel in a veil, small', 'Plate of 1 voxel, almost from its edge']) {
      for (const { maxError, detail, stats, e } of await traded(name)) {
        console.log(`${name}, ${detail} at ${maxError}: E ${e.toFixed(2)}, rays ${stats.rays.toFixed(2)}`);
        expect(stats.keepsMaxError, `${name}, ${detail} at ${maxError}`).to.equal(true);
        expect(e, `${name}, ${detail} at ${maxError}`).to.be.at.most(1.1 * maxError);
      }
    }
  });

  it('has one picture: once more, after another detail, and as a file', async function () {
    this.timeout(120_000);
    const setup = await brain({ detail: 'free', 'max-error': '8' });
    const first = placeElement(setup);
    const { data, stats } = await takeAtRest(first, setup.pixels);
    expect(stats.rays * stats.steps, 'rays times steps').to.be.below(0.7 * 359);
    const screen = await new Promise<Blob>((resolve) => canvasOf(first).toBlob((one) => resolve(one!)));
    const [file, shown] = await Promise.all(
      [await first.toBlob(), screen].map(async (blob) => decode(new Uint8Array(await blob.arrayBuffer())).data),
    );
    expect(file, 'the file').to.deep.equal(shown);
    await first.toBlob({ width: 80, height: 80 });
    expect((await takeAtRest(first, setup.pixels)).data, 'after a smaller file').to.deep.equal(data);
    first.remove();
    const other = placeElement({ ...setup, attributes: { 'max-error': '8' } });
    const kept = await takeAtRest(other, setup.pixels);
    expect(kept.stats.rays).to.equal(1);
    expect(kept.data).not.to.deep.equal(data);
    other.setAttribute('detail', 'free');
    expect((await takeAtRest(other, setup.pixels)).data, 'later').to.deep.equal(data);
    other.remove();
  });
});

describe('whenRendered', () => {
  it('does not wait for what is learnt of the final picture for those in motion', async function () {
    this.timeout(60_000);
    // A picture that took no longer than a frame may is the plan of those in motion too: here it takes longer.
    const setup = await brain({ 'target-fps': '120' });
    const element = placeElement(setup);
    await takeAtRest(element, setup.pixels);
    let shown = 0;
    element.addEventListener('render', () => shown++);
    element.setAttribute('camera-orbit', '40deg 70deg auto');
    await element.whenRendered();
    expect(element.renderStats!.converged).to.equal(true);
    expect(shown, 'pictures of the new view').to.be.above(0);
    let reads = 0;
    const { prototype } = WebGL2RenderingContext;
    const { readPixels } = prototype;
    prototype.readPixels = function (this: WebGL2RenderingContext, ...all: unknown[]) {
      reads++;
      return Reflect.apply(readPixels, this, all);
    } as typeof readPixels;
    try {
      await new Promise((resolve) => setTimeout(resolve, 1500));
    } finally {
      prototype.readPixels = readPixels;
    }
    expect(reads, 'what is read afterwards').to.be.above(0);
    element.remove();
  });
});

describe('rays that are spared', () => {
  it('leave the same picture on the GPU as in its forecast', async () => {
    const { volume, transferFunction, camera } = errorScenes().find(({ name }) => name.startsWith('shells, smooth'))!;
    const picture = { width: 160, height: 120 };
    const rim = 2 * tileMargin;
    await withScene({}, (scene) => {
      changePlan(scene, { picture });
      scene.setVolume(volume);
      void scene.setAppearance({
        optics: { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 },
      });
      changePlan(scene, { camera });
      const step = finestSpacing(volume.grid);
      drawAt(scene, step);
      const full = scene.readPicture();
      for (const maxCurvature of [4, 12, 48]) {
        changePlan(scene, { maxCurvature });
        drawAt(scene, step);
        const drawn = scene.readPicture().data;
        const { data, rays } = spareRays(full, maxCurvature, sparingTools);
        let [max, off] = [0, 0];
        for (let i = 0; i < data.length; i++) {
          // At the rim the lattices of a picture reach beyond it, and those of a tile end.
          const [x, y] = [(i >> 2) % picture.width, Math.floor((i >> 2) / picture.width)];
          if (Math.min(x, y) < rim || x >= picture.width - rim || y >= picture.height - rim) continue;
          const difference = Math.abs(data[i] - drawn[i]);
          max = Math.max(max, difference);
          if (difference > 1) off++;
        }
        console.log(`curvature ${maxCurvature}: ${rays} rays, ${off} values off by more than 1, at most ${max}`);
        // Rounding decides whether a quad that curves by just the limit gets rays.
        expect(off / data.length, `off at ${maxCurvature}`).to.be.at.most(0.002);
      }
    });
  });
});
