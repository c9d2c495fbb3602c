// In the browser: frames with light, surfaces, a second field or labels against the plain ones beside them.
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { stepLengthOf } from '../../src/quality/steps.ts';
import { drawAt } from '../helpers/change-plan.ts';
import { listVariants, litScenes, loadScan } from './lit-scenes.ts';
import type { LitScene, LitVariant } from './lit-scenes.ts';
import { median } from './table.mjs';
import { openTurnScene, processorSeconds } from './turns.ts';

export interface LitOptions {
  /** Pixels along each side. */
  readonly size: number;
  readonly steps: number;
  readonly turns: number;
  /** Ids; all where empty. */
  readonly scenes: readonly string[];
  /** How the names of variants begin; all where empty. */
  readonly variants: readonly string[];
  /** Whether they are compared with the lit picture, not with the plain one. */
  readonly overLit: boolean;
}

export interface LitRow {
  readonly scene: string;
  readonly variant: string;
  /** Medians of processor time, ms a frame. */
  readonly plain: number;
  readonly shown: number;
  /** Median of those of each turn, of processor time and of the clock's. */
  readonly ratio: number;
  readonly clock: number;
}

/** What a frame took, ms. */
interface Timed {
  readonly work: number;
  readonly clock: number;
}

/** Frames are timed together until they took so long, ms: processor time is counted in hundredths of a second. */
const minTimed = 400;

export async function compareLit(options: LitOptions): Promise<LitRow[]> {
  const rows: LitRow[] = [];
  for (const scene of litScenes.filter(({ id }) => options.scenes.length === 0 || options.scenes.includes(id)))
    rows.push(...(await compareScene(scene, options)));
  return rows;
}

async function compareScene(bench: LitScene, { size, steps, turns, variants, overLit }: LitOptions): Promise<LitRow[]> {
  const volume = await loadScan(bench.url);
  const transferFunction = await resolveTransferFunction(bench.look, volume.range);
  const stepLength = stepLengthOf(volume.grid, steps);
  const open = async ({ name, style, overlay, labels }: LitVariant) => {
    const { scene, dispose } = await openTurnScene({
      volume,
      transferFunction,
      referenceLength: bench.referenceLength,
      size,
    });
    if (style) await scene.setAppearance({ style });
    if (overlay) await scene.setOverlay(overlay);
    if (labels) await scene.setLabels(labels);
    const draw = async (): Promise<void> => {
      drawAt(scene, stepLength);
      scene.readPicture();
      await scene.finished();
    };
    await draw(); // Compiles.
    const began = performance.now();
    await draw();
    const frames = Math.max(1, Math.ceil(minTimed / (performance.now() - began)));
    const time = async (): Promise<Timed> => {
      const [before, start] = [await processorSeconds(), performance.now()];
      for (let i = 0; i < frames; i++) await draw();
      const clock = (performance.now() - start) / frames;
      return { work: (1000 * ((await processorSeconds()) - before)) / frames, clock };
    };
    return { name, time, dispose };
  };
  const plain = await open(overLit ? { name: 'lit', style: { lit: true } } : { name: 'plain' });
  const rows: LitRow[] = [];
  const all = await listVariants(bench, volume);
  for (const variant of all.filter(
    ({ name }) => variants.length === 0 || variants.some((begin) => name.startsWith(begin)),
  )) {
    const shown = await open(variant);
    const taken: { plain: Timed; shown: Timed }[] = [];
    for (let turn = 0; turn < turns; turn++) taken.push({ plain: await plain.time(), shown: await shown.time() });
    shown.dispose();
    rows.push({
      scene: bench.name,
      variant: variant.name,
      plain: median(taken.map((one) => one.plain.work)),
      shown: median(taken.map((one) => one.shown.work)),
      ratio: median(taken.map((one) => one.shown.work / one.plain.work)),
      clock: median(taken.map((one) => one.shown.clock / one.plain.clock)),
    });
  }
  plain.dispose();
  return rows;
}
