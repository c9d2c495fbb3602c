// In the browser: frames of a volume in bricks against those of the whole volume.
import { wholeSteps } from '../../src/optics/cells/substeps.ts';
import type { RayStyle } from '../../src/optics/rays/ray-style.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { stepLengthOf } from '../../src/quality/steps.ts';
import type { GridFrame } from '../../src/volume/grid.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { cutIntoBricks } from '../helpers/bricks.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { litScenes, loadScan } from './lit-scenes.ts';
import type { LitScene } from './lit-scenes.ts';
import { median } from './table.mjs';
import { openTurnScene, processorSeconds } from './turns.ts';

export interface BrickedOptions {
  /** Pixels along each side. */
  readonly size: number;
  readonly steps: number;
  readonly turns: number;
  /** Ids, and names of looks; all where empty. */
  readonly scenes: readonly string[];
  readonly looks: readonly string[];
}

export interface BrickedRow {
  readonly scene: string;
  readonly look: string;
  readonly way: string;
  /** Medians of processor time, ms a frame. */
  readonly whole: number;
  readonly bricks: number;
  /** Median of those of each turn, of processor time and of the clock's. */
  readonly ratio: number;
  readonly clock: number;
  /** RMS of the pixels of both, of 255. */
  readonly difference: number;
}

/** Voxels along each edge of a macrocell of a large volume, and of a brick. */
const largeCells = 8;

/** Frames are timed together until they took so long, ms: processor time is counted in hundredths of a second. */
const minTimed = 400;

const looks: readonly { readonly name: string; readonly style?: RayStyle }[] = [
  { name: 'plain' },
  { name: 'lit', style: { lit: true } },
];

/** How many cells have an entry together: small pyramids have one for each, large ones one for a group. */
const ways = [
  { name: 'a page each', groupSide: 1 },
  { name: 'pages of groups', groupSide: 4 },
];

interface Timed {
  readonly work: number;
  readonly clock: number;
}

export async function compareBricked(options: BrickedOptions): Promise<BrickedRow[]> {
  const isWanted = (names: readonly string[], name: string): boolean => names.length === 0 || names.includes(name);
  const rows: BrickedRow[] = [];
  for (const scene of litScenes) {
    if (!isWanted(options.scenes, scene.id) || scene.id === 'radar') continue;
    const volume = await loadScan(scene.url);
    for (const look of looks)
      if (isWanted(options.looks, look.name)) rows.push(...(await compareLook(scene, volume, look, options)));
  }
  return rows;
}

async function compareLook(
  bench: LitScene,
  volume: Volume,
  look: (typeof looks)[number],
  options: BrickedOptions,
): Promise<BrickedRow[]> {
  // Volumes that are large enough for bricks have macrocells of this size.
  const macrocells = buildMacrocells(volume.samples, volume.grid.dimensions, largeCells);
  const whole = await open(
    bench,
    { volume: { ...volume, macrocells }, around: volume.grid, style: look.style },
    options,
  );
  const rows: BrickedRow[] = [];
  for (const way of ways) {
    const { volume: bricked } = cutIntoBricks(volume, 3, () => true, way.groupSide);
    const bricks = await open(bench, { volume: bricked, around: volume.grid, style: look.style }, options);
    const taken: { whole: Timed; bricks: Timed }[] = [];
    for (let turn = 0; turn < options.turns; turn++)
      taken.push({ whole: await whole.time(), bricks: await bricks.time() });
    bricks.dispose();
    rows.push({
      scene: bench.name,
      look: look.name,
      way: way.name,
      whole: median(taken.map((one) => one.whole.work)),
      bricks: median(taken.map((one) => one.bricks.work)),
      ratio: median(taken.map((one) => one.bricks.work / one.whole.work)),
      clock: median(taken.map((one) => one.bricks.clock / one.whole.clock)),
      difference: Math.sqrt(
        whole.picture.reduce((sum, n, at) => sum + (n - bricks.picture[at]) ** 2, 0) / whole.picture.length,
      ),
    });
  }
  whole.dispose();
  return rows;
}

interface Shown {
  readonly volume: Volume;
  /** What is in sight. */
  readonly around: GridFrame;
  readonly style?: RayStyle;
}

async function open(
  { look, referenceLength }: LitScene,
  { volume, around, style }: Shown,
  { size, steps }: BrickedOptions,
): Promise<{ time: () => Promise<Timed>; picture: Uint8Array; dispose: () => void }> {
  const transferFunction = await resolveTransferFunction(look, volume.range);
  const { scene, dispose } = await openTurnScene({ volume, transferFunction, referenceLength, size, around });
  if (style) await scene.setAppearance({ style });
  changePlan(scene, { substeps: wholeSteps }); // As those of moving frames.
  const stepLength = stepLengthOf(around, steps);
  const draw = async (): Promise<void> => {
    drawAt(scene, stepLength);
    scene.readPicture();
    await scene.finished();
  };
  await draw(); // Compiles.
  const picture = scene.readPicture().data;
  const began = performance.now();
  await draw();
  const frames = Math.max(1, Math.ceil(minTimed / (performance.now() - began)));
  const time = async (): Promise<Timed> => {
    const [before, start] = [await processorSeconds(), performance.now()];
    for (let i = 0; i < frames; i++) await draw();
    const clock = (performance.now() - start) / frames;
    return { work: (1000 * ((await processorSeconds()) - before)) / frames, clock };
  };
  return { time, picture, dispose };
}
