// In the browser: pictures in motion that cost the same, with many pixels or with many steps, against the full picture of the same camera.
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { framingDistance, orbitCamera } from '../../src/optics/rays/camera.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { allSubsteps, wholeSteps } from '../../src/optics/cells/substeps.ts';
import { unknownErrors } from '../../src/quality/frame-quality.ts';
import { chooseFrameQuality } from '../../src/quality/choose-frame-quality.ts';
import type { ErrorModel } from '../../src/quality/frame-quality.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { errorAtHalf } from '../../src/viewer/frames/measure-quality.ts';
import { ViewQuality } from '../../src/viewer/frames/view-quality.ts';
import { defaultTargets } from '../../src/viewer/model/quality-targets.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { compareCovered } from '../helpers/covered-error.ts';
import { blowUp } from './blow-up.ts';
import { litScenes, loadScan } from './lit-scenes.ts';
import type { LitScene } from './lit-scenes.ts';
import '../helpers/provide-substeps.ts';

export interface MotionOptions {
  /** Pixels along each side. */
  readonly size: number;
  /** Ids; all where empty. */
  readonly scenes: readonly string[];
}

export interface MotionRow {
  readonly scene: string;
  /** Pixels along each side of the picture in motion, and steps. */
  readonly pixels: number;
  readonly steps: number;
  /** Whether the controller takes it, by what it measured of the picture at rest. */
  readonly isChosen: boolean;
  /** Of all moves: over covered pixels, and along silhouettes, 1/255. */
  readonly rms: number;
  readonly p99: number;
  readonly silhouette: number;
}

/** From where the picture at rest was seen: degrees around the volume, and a factor of the distance. */
const moves = [
  [1, 1],
  [6, 1],
  [15, 1],
  [0, 0.8],
] as const;

/** What a frame at 800 x 800 has time for in software: pixels times steps, and what rays cost besides. As much as 14 steps with substeps took. */
const affordable = 128 ** 2 * (100 + 4);

const shares = [0.16, 0.14, 0.125, 0.11, 0.1, 0.08] as const;

/** @param notify - what is being done */
export async function compareMotion(
  { size, scenes }: MotionOptions,
  notify: (what: string) => void,
): Promise<MotionRow[]> {
  const rows: MotionRow[] = [];
  for (const scene of litScenes.filter(({ id }) =>
    (scenes.length === 0 ? ['mri', 'ct', 'radar'] : scenes).includes(id),
  )) {
    notify(scene.id);
    rows.push(...(await compareScene(scene, size)));
  }
  return rows;
}

async function compareScene(bench: LitScene, size: number): Promise<MotionRow[]> {
  const volume = await loadScan(bench.url);
  const { center, radius } = boundingSphere(volume.grid);
  const host = document.createElement('div');
  document.body.append(host);
  const scene = await VolumeScene.create(host, host, () => {}, fieldProviders);
  await scene.prepare(volume);
  scene.setVolume(volume);
  await scene.setAppearance({
    optics: {
      transferFunction: await resolveTransferFunction(bench.look, volume.range),
      referenceLength: bench.referenceLength * radius,
      opacityFactor: 1,
      lightFactor: 1,
    },
  });
  const draw = (
    [degrees, zoom]: readonly [number, number],
    pixels: number,
    steps: number,
    substeps = allSubsteps,
  ): Uint8Array => {
    changePlan(scene, { substeps });
    changePlan(scene, { picture: { width: pixels, height: pixels } });
    changePlan(scene, {
      camera: orbitCamera(
        { theta: 0.5 + (degrees * Math.PI) / 180, phi: 1.2, radius: zoom * framingDistance(radius, 0.6, 1) },
        center,
        0.6,
      ),
    });
    drawAt(scene, stepLengthOf(volume.grid, steps));
    return scene.readPicture().data;
  };
  draw([0, 1], size, autoSteps(volume.grid));
  const model = await learn(scene, volume, size);
  const full = moves.map((move) => draw(move, size, autoSteps(volume.grid)));
  const chosen = chooseFrameQuality(
    { a: 0, b: 1 },
    model,
    { pixels: size ** 2, steps: autoSteps(volume.grid) },
    { budgetMs: affordable },
  );
  const plans = [
    ...shares.map((share) => [Math.round(share * 800), false] as const),
    [Math.round(chosen.scale * size), true] as const,
  ];
  const rows = plans.map(([pixels, isChosen]): MotionRow => {
    const steps = isChosen ? chosen.steps : Math.min(autoSteps(volume.grid), Math.floor(affordable / pixels ** 2 - 4));
    const errors = moves.map((move, i) =>
      measure(blowUp(draw(move, pixels, steps, wholeSteps), { width: pixels, height: pixels }, size), full[i], size),
    );
    const mean = (key: 'rms' | 'p99' | 'silhouette'): number =>
      errors.reduce((sum, one) => sum + one[key], 0) / errors.length;
    return {
      scene: bench.id,
      pixels,
      steps,
      isChosen,
      rms: mean('rms'),
      p99: mean('p99'),
      silhouette: mean('silhouette'),
    };
  });
  scene.dispose();
  host.remove();
  return rows;
}

/** What the element learns from its picture at rest. */
async function learn(scene: VolumeScene, { grid }: Volume, size: number): Promise<ErrorModel> {
  const atHalf = errorAtHalf(scene.readPicture());
  const view = { scene, grid, size: { width: size, height: size }, goesOn: () => true };
  const quality = new ViewQuality(view, defaultTargets);
  const found = await quality.choose();
  return { ...unknownErrors, ...(found && (await quality.learnSteps(found.level, view.goesOn))), atHalf };
}

/** Where a picture is less opaque than this, one sees the background. */
const visible = 0.3 * 255;

/** Pixels to each side of a silhouette that belong to it. */
const reach = 4;

function measure(shown: Float32Array, full: Uint8Array, size: number): Pick<MotionRow, 'rms' | 'p99' | 'silhouette'> {
  const isThere = (x: number, y: number): boolean => full[4 * (y * size + x) + 3] > visible;
  let [squares, count] = [0, 0];
  for (let y = reach; y + reach < size; y++) {
    for (let x = reach; x + reach < size; x++) {
      const corners = [isThere(x - reach, y), isThere(x + reach, y), isThere(x, y - reach), isThere(x, y + reach)];
      if (corners.every((one) => one === corners[0])) continue;
      for (let c = 0; c < 4; c++) squares += (shown[4 * (y * size + x) + c] - full[4 * (y * size + x) + c]) ** 2;
      count += 4;
    }
  }
  const { rms, p99 } = compareCovered(shown, full, 1);
  return { rms, p99, silhouette: Math.sqrt(squares / Math.max(1, count)) };
}
