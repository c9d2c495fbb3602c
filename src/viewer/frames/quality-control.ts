import { allSubsteps, wholeSteps } from '../../optics/cells/substeps.ts';
import type { PictureError } from '../../quality/error-estimate.ts';
import type { Level } from '../../quality/levels.ts';
import { unknownErrors, workOfPlan } from '../../quality/frame-plan.ts';
import type { ErrorModel, FramePlan } from '../../quality/frame-plan.ts';
import { allRays } from '../../quality/sampling-outcome.ts';
import type { SteadyTime } from '../../quality/steady-time.ts';
import { autoSteps, maxAutoSteps, voxelsAlong } from '../../quality/steps.ts';
import { FrameTimer } from '../../quality/time-model.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { loadPart } from '../../core/load-part.ts';
import { defaultTargets } from '../model/quality-targets.ts';
import type { QualityTargets } from '../model/quality-targets.ts';
import type { Scene, Size } from '../model/scene.ts';
import type * as viewQuality from './view-quality.ts';
import type { QualityFinding } from './view-quality.ts';

/** What measures the error of pictures is loaded when the first one is there. */
function loadTools(): Promise<typeof viewQuality> {
  return loadPart(import('./view-quality.ts'), 'measures the error of pictures');
}

/** A view whose error is probed. */
export interface Probed {
  /** What it was drawn with. */
  readonly plan: FramePlan;
  /** Pixels across and down of the picture in full. */
  readonly size: Size;
  /** Whether the view is still wanted. */
  readonly goesOn: () => boolean;
}

/** Of a frame's time, the share that is planned for: what is left is for the page and for frames that take longer. */
const planned = 0.85;

/** Frames' times that a picture at rest may take at once. */
const worthPieces = 3;

/**
 * An edge that runs anywhere through a pixel leaves one ray off from the pixel's mean by 1/sqrt(12) of what the picture jumps there, RMS. Where
 * that is more than eight times `max-error`, which one pixel in a thousand may be off by, pixels get more rays.
 */
const curvaturePerError = 8 * Math.sqrt(12);

/** Rows that a piece has at least: what a piece takes besides is not to be the most of it. */
const minRows = 16;

/** The first picture, of which nothing is known yet: small, to tell what larger ones take. */
export const firstFrame: FramePlan = { scale: 0.125, steps: 128, substeps: wholeSteps, sampling: allRays };

/** Of a size to look at: tells the rest of what larger pictures take. */
export const standInFrame: FramePlan = { ...firstFrame, scale: 0.25 };

/**
 * How many steps, pixels and rays a picture gets, and what error it then has (see docs/maths.md). At rest all pixels get
 * rays, and the first level of steps that keeps the target for the error is taken: the choice depends on the view alone, and
 * not on times or on what was seen before. While something moves, the least error within a frame's time is taken, by
 * a model of time and one of error that are fitted to what is drawn and measured.
 */
export class QualityControl {
  #targets = defaultTargets;
  /** Chosen for the scene as it stands by probing its error; null where it was not probed yet. */
  #chosen: Level | null = null;
  #error: PictureError | null = null;
  #isKept = false;
  #errors: ErrorModel = unknownErrors;
  #tools: typeof viewQuality | null = null;
  readonly #timer = new FrameTimer();
  /** null before what measures errors is there: the first times are the clock's. */
  #steady: SteadyTime | null = null;
  #last: FramePlan | undefined;
  /** How a picture at rest was drawn that took no longer than one in motion may; null where none was. */
  #fast: { readonly plan: FramePlan; readonly pixels: number } | null = null;
  /** Whether a picture was drawn with spared rays. */
  #hasSpared = false;
  /** Whether what cuts given steps is there. */
  #cuts = false;

  /** @returns whether this changes anything */
  set(targets: QualityTargets): boolean {
    const changes = JSON.stringify(targets) !== JSON.stringify(this.#targets);
    this.#targets = targets;
    if (changes) this.forget();
    return changes;
  }

  /** The error of the last picture at rest; null where nothing is known of the scene as it stands. */
  get error(): PictureError | null {
    return this.#error;
  }

  /** Whether that error is within the target. */
  get isKept(): boolean {
    return this.#isKept;
  }

  /** The view changed: what was chosen and measured holds no more. */
  forget(): void {
    this.#chosen = null;
    this.#error = null;
    this.#isKept = false;
  }

  /** What is seen of the volume changed: where its picture is smooth has to be found out again. */
  forgetProbes(): void {
    this.forget();
    this.#fast = null;
    this.#errors = { ...this.#errors, sampling: [] };
  }

  /** The volume changed: nothing is known of the times either. */
  forgetAll(): void {
    this.forgetProbes();
    this.#errors = unknownErrors;
    this.#timer.forget();
    this.#last = undefined;
  }

  /** What a picture at rest gets, as far as it is known. */
  still(grid: GridFrame): FramePlan {
    return { ...this.#withoutEdges(grid), edgeCurvature: curvaturePerError * this.#targets.maxError };
  }

  #withoutEdges(grid: GridFrame): FramePlan {
    const { steps, maxError } = this.#targets;
    if (steps !== 'auto') return { scale: 1, steps, substeps: this.#cuts ? allSubsteps : wholeSteps, sampling: allRays };
    const oneAVoxel = autoSteps(grid);
    const level = this.#chosen ?? { steps: oneAVoxel, substeps: 1 };
    // Cells have a say as soon as what chooses steps is there: nothing is drawn at rest before.
    const substeps = this.#tools?.cutSteps(level, voxelsAlong(grid), maxError) ?? { ...allSubsteps, most: level.substeps };
    return { scale: 1, steps: level.steps, substeps, sampling: allRays };
  }

  /** Whether the steps of a picture at rest are still to be found out by probing. */
  get undecided(): boolean {
    return this.#targets.steps === 'auto' && this.#chosen === null;
  }

  /** What a picture gets that will be replaced by the next one at once. */
  moving(grid: GridFrame, pixels: number): FramePlan {
    const { steps, targetFps } = this.#targets;
    if (steps !== 'auto') return this.#withoutEdges(grid);
    // What is small does not blink.
    if (this.#fast?.pixels === pixels) return this.#fast.plan;
    const { model } = this.#timer;
    const full = { pixels, steps: autoSteps(grid) };
    if (!model || !this.#tools) return { ...firstFrame, steps: Math.min(full.steps, firstFrame.steps) };
    this.#last = this.#tools.planFrame(model, this.#errors, full, { budgetMs: (planned * 1000) / targetFps, last: this.#last });
    return this.#last;
  }

  /**
   * Rows of the first of the pieces in which a picture at rest is drawn, so that each is within a frame's time.
   * @returns null where the whole is drawn in little more than that
   */
  rowsOfPieces({ width, height }: Size, plan: FramePlan): number | null {
    const { model } = this.#timer;
    if (!model || this.#targets.steps !== 'auto') return null;
    if (model.a + model.b * workOfPlan(plan, width * height) <= worthPieces * this.pieceMs) return null;
    return Math.max(minRows, Math.floor(Math.max(0, this.pieceMs - model.a) / (model.b * workOfPlan(plan, width))));
  }

  /** What a frame, and a piece of a picture at rest, may take. */
  get pieceMs(): number {
    return (planned * 1000) / this.#targets.targetFps;
  }

  /** Learn from how long a picture took that was drawn at once, and how much of that was the GPU's time, where that is known. @param pixels - of the full picture */
  took(plan: FramePlan, pixels: number, ms: number, gpuMs: number | null = null): void {
    this.#hasSpared ||= plan.sampling !== allRays;
    const steady = (this.#steady ??= this.#tools && new this.#tools.SteadyTime())?.of(ms, gpuMs) ?? ms;
    // What steps take that cells cut says nothing of others.
    if (plan.substeps === wholeSteps) this.#timer.add({ work: workOfPlan(plan, pixels), ms: steady });
    else this.#fast = steady <= this.pieceMs ? { plan, pixels } : null;
  }

  /** Begin to load what measures errors and plans frames, and what draws piece by piece: needed as soon as there is a picture. */
  warmUp(): void {
    if (this.#tools) return;
    const tools = loadTools().then((tools) => (this.#tools = tools));
    for (const part of [tools, import('./gather-picture.ts')]) part.catch(() => {}); // Told when it is needed.
  }

  /** What cuts given steps is loaded before the first picture that has some. @throws {VolumeViewError} `format/unsupported` */
  async prepare(): Promise<void> {
    if (this.#targets.steps === 'auto' || this.#cuts) return;
    await (this.#tools ??= await loadTools()).loadSubsteps();
    this.#cuts = true;
  }

  /** Whether nothing is known yet of what pictures take. */
  get untimed(): boolean {
    return this.#targets.steps === 'auto' && this.#timer.model === null;
  }

  /**
   * Probe the error of the view that has just been drawn. The page goes on between one level and the next.
   * @returns whether it should be drawn again, with other steps or more pixels
   */
  async probe(scene: Scene, grid: GridFrame, { plan, size, goesOn }: Probed): Promise<boolean> {
    const { ViewQuality, learnFrom } = (this.#tools ??= await loadTools());
    if (!goesOn()) return false;
    const { steps, maxError } = this.#targets;
    const isAuto = steps === 'auto';
    const view = new ViewQuality({ scene, grid, size, goesOn }, { maxError, isAuto });
    if (this.undecided) {
      const found = await view.choose();
      if (!found) return false;
      this.#chosen = found.level;
      this.#state(found);
    }
    const target = this.still(grid);
    const isAtRest = plan.scale === 1 && plan.steps === target.steps && plan.sampling === target.sampling;
    if (!isAtRest || plan.substeps.most !== target.substeps.most || plan.substeps.voxelsPerStep !== target.substeps.voxelsPerStep) return true;
    if (isAuto) this.#errors = { ...this.#errors, ...(await learnFrom({ scene, grid, size, goesOn }, this.#hasSpared)) };
    else if (!this.#error && plan.steps <= maxAutoSteps) this.#state(await view.measure({ steps: plan.steps, substeps: plan.substeps.most }));
    return false;
  }

  #state(found: QualityFinding | null): void {
    if (found) [this.#error, this.#isKept] = [found.error, found.isKept];
  }
}
