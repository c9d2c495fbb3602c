// In the browser, whichever it is: what each of our choices brings on this renderer. Frames of one view, in turns.
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { loadVolume } from '../../src/worker/load.ts';
import { framingDistance, orbitCamera } from '../../src/optics/rays/camera.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { allSubsteps } from '../../src/optics/cells/substeps.ts';
import { windowFromHistogram } from '../../src/optics/transfer/window.ts';
import { cutSteps } from '../../src/quality/levels.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { gatherPicture } from '../../src/viewer/frames/gather-picture.ts';
import { learnFrom } from '../../src/viewer/frames/view-quality.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { median } from './table.mjs';
import '../helpers/provide-substeps.ts';

const limits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 31 };

const scenes = [
  { name: 'MRI, smooth', url: '/demos/data/mni152-t1.nii.gz', look: 'mri' },
  { name: 'CT phantom, bone', url: '/demos/data/ct-phantom.nii.gz', look: 'ct-bone' },
  { name: 'radar, storm', url: '/demos/data/storm-radar-1510.json', look: 'radar-dbz' },
] as const;

/** 1/255. */
const maxCurvature = 32;

/** Rows of the first piece, and what each may take, ms. */
const pieces = { rows: 32, pieceMs: 28 };

export interface ChoicesRow {
  readonly scene: string;
  /** Of a plain frame, ms: skipping, cut steps, a ray for each pixel. */
  readonly ms: number;
  /** Medians of the time of frames drawn otherwise over that of the plain one beside them, by what is otherwise. */
  readonly ratios: Readonly<Record<string, number>>;
  /** Rays that adaptive rays are foretold to cast, as a share of all. */
  readonly share: number;
  /** Rays that are cast where spared as in motion, foretold, and what they are measured to cost, as shares of all rays and their time. */
  readonly spared: readonly { readonly share: number; readonly cost?: number }[];
}

/** @param size - pixels along each side @param steps - one a voxel where 0 */
export async function compareChoices(size: number, turns: number, steps: number): Promise<ChoicesRow[]> {
  const rows: ChoicesRow[] = [];
  for (const { name, url, look: appearance } of scenes) {
    const volume = await loadVolume(
      { url: new URL(url, location.href).href, limits },
      { signal: new AbortController().signal, onProgress: () => {} },
    );
    const container = document.createElement('div');
    container.style.cssText = `width: ${size}px; height: ${size}px`;
    document.body.append(container);
    const scene = await VolumeScene.create(document.createElement('div'), container, () => {}, fieldProviders);
    const { center, radius } = boundingSphere(volume.grid);
    const optics = {
      transferFunction: await resolveTransferFunction(
        appearance,
        volume.window ?? windowFromHistogram(volume.histogram),
      ),
      opacityFactor: 1,
      lightFactor: 1,
      referenceLength: volume.referenceLength ?? radius / 100,
    };
    await scene.prepare(volume, optics);
    scene.setVolume(volume);
    await scene.setAppearance({ optics });
    changePlan(scene, { picture: { width: size, height: size } });
    const fieldOfView = Math.PI / 4;
    changePlan(scene, {
      camera: orbitCamera(
        { theta: 0.6, phi: 1.1, radius: framingDistance(radius, fieldOfView, 1) },
        center,
        fieldOfView,
      ),
    });
    const one = steps || autoSteps(volume.grid);
    const stepLength = stepLengthOf(volume.grid, one);
    const [layer] = scene.layers;

    const plain = async (): Promise<void> => {
      drawAt(scene, stepLength);
      await scene.finished();
    };
    const others: Record<string, () => Promise<unknown>> = {
      'without skipping': async () => {
        layer.skipping = false;
        await plain();
        layer.skipping = true;
      },
      'all substeps': async () => {
        changePlan(scene, { substeps: allSubsteps });
        await plain();
        changePlan(scene, { substeps: cut });
      },
      'adaptive rays': async () => {
        changePlan(scene, { maxCurvature, edgeCurvature: Infinity });
        await plain();
        changePlan(scene, { maxCurvature: 0, edgeCurvature: Infinity });
      },
      'in pieces': () =>
        gatherPicture(
          scene,
          { plan: { ...scene.plan, stepLength, picture: { width: size, height: size } }, ...pieces },
          () => true,
        ),
    };
    const cut = cutSteps({ steps: one, substeps: 8 }, autoSteps(volume.grid), 1);
    changePlan(scene, { substeps: cut });
    const time = async (draw: () => Promise<unknown>): Promise<number> => {
      const began = performance.now();
      await draw();
      return performance.now() - began;
    };
    for (const draw of [plain, ...Object.values(others)]) await draw(); // Programs and tables.
    const times: number[] = [];
    const ratios = Object.fromEntries(Object.keys(others).map((what) => [what, [] as number[]]));
    for (let turn = 0; turn < turns; turn++) {
      for (const [what, draw] of Object.entries(others)) {
        const ms = await time(plain);
        times.push(ms);
        ratios[what].push((await time(draw)) / ms);
      }
    }
    changePlan(scene, { maxCurvature: 0, edgeCurvature: Infinity });
    await plain();
    const { sampling = [] } = await learnFrom(
      { scene, grid: volume.grid, size: { width: size, height: size }, goesOn: () => true },
      true,
    );
    const spared = sampling.map((list) => list.find(({ share }) => share <= 0.5)).filter((one) => one !== undefined);
    const { share } = sampling[0].find((outcome) => outcome.maxCurvature === maxCurvature)!;
    rows.push({
      scene: name,
      share,
      spared,
      ms: median(times),
      ratios: Object.fromEntries(Object.entries(ratios).map(([what, all]) => [what, median(all)])),
    });
    scene.dispose();
    container.remove();
  }
  return rows;
}
