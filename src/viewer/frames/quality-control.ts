import { allSubsteps, wholeSteps } from '../../optics/cells/substeps.ts';
import type { PictureError } from '../../quality/error-estimate.ts';
import { unknownErrors, workOfFrame } from '../../quality/frame-quality.ts';
import type { ErrorModel, FrameQuality } from '../../quality/frame-quality.ts';
import { allRays } from '../../quality/sampling-outcome.ts';
import type { SteadyTime } from '../../quality/steady-time.ts';
import { autoSteps, voxelsAlong } from '../../quality/steps.ts';
import { FrameTimer } from '../../quality/time-model.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { loadPart } from '../../core/load-part.ts';
import type { DrawnView } from '../model/drawn-view.ts';
import { defaultTargets } from '../model/quality-targets.ts';
import type { QualityTargets } from '../model/quality-targets.ts';
import type { Scene, Size } from '../model/scene.ts';
import type * as viewQuality from './view-quality.ts';
import type { ChosenSteps, QualityFinding } from './chosen-level.ts';

/** The code that measures the error of pictures is loaded when the first picture is there. */
function loadTools(): Promise<typeof viewQuality> {
  return loadPart(import('./view-quality.ts'), 'measures errors');
}

/** A view whose error is probed. */
export interface Probed extends Pick<DrawnView, 'volume' | 'size' | 'goesOn'> {
  /** The plan with which it was drawn. */
  readonly plan: FrameQuality;
}

/** The planned share of a frame's time: the rest is for the page, and for frames that take longer. */
const planned = 0.85;

/** A picture at rest is drawn at once if it takes at most this many times the time of a frame. */
const worthPieces = 3;

/**
 * An edge that crosses a pixel anywhere gives one ray an error of 1/sqrt(12) of the picture's jump there, RMS, compared with the
 * pixel's mean. Where that is more than eight times `max-error`, which one pixel in a thousand may exceed, pixels get more rays.
 */
const curvaturePerError = 8 * Math.sqrt(12);

/** The minimum number of rows in a piece: the fixed time of a piece must not be the largest part of its time. */
const minRows = 16;

/** The first picture, when no times are known yet: small, to measure how long larger ones take. */
export const firstFrame: FrameQuality = { scale: 0.125, steps: 128, substeps: wholeSteps, sampling: allRays };

/** A picture that is large enough to look at; its time completes what is known of larger pictures. */
export const standInFrame: FrameQuality = { ...firstFrame, scale: 0.25 };

/**
 * Decides how many steps, pixels and rays a picture gets, and measures what error it then has (see docs/develop/maths.md). At rest all
 * pixels get rays, with the first level of steps that keeps the error target: this choice depends only on the view, not on times
 * or on earlier views. While something moves, the plan has the smallest error within a frame's time, by a model of time and one of
 * error, which are fitted to the drawn and measured pictures.
 */
export class QualityControl {
  #targets = defaultTargets;
  /** The level chosen for the present scene by probing its error; null where it has not been probed yet. */
  #chosen: ChosenSteps | null = null;
  #error: PictureError | null = null;
  #isKept = false;
  #errors: ErrorModel = unknownErrors;
  #tools: typeof viewQuality | null = null;
  readonly #timer = new FrameTimer();
  /** null before the code that measures errors is loaded: until then, times are those of the page's clock. */
  #steady: SteadyTime | null = null;
  #last: FrameQuality | undefined;
  /** The plan of a picture at rest that took no longer than a picture in motion may; null where there was none. */
  #fast: { readonly plan: FrameQuality; readonly pixels: number } | null = null;
  /** Whether a picture was drawn with fewer rays than pixels. */
  #hasSpared = false;
  /** Whether the code that cuts given steps is loaded. */
  #cuts = false;

  /** @returns whether this changes anything */
  set(targets: QualityTargets): boolean {
    const changes = JSON.stringify(targets) !== JSON.stringify(this.#targets);
    this.#targets = targets;
    if (changes) this.forget();
    return changes;
  }

  /** The error of the last picture at rest; null where the present scene has not been measured. */
  get error(): PictureError | null {
    return this.#error;
  }

  /** Whether that error is within the target. */
  get isKept(): boolean {
    return this.#isKept;
  }

  /** The view changed: the chosen level and the measured error are no longer valid. */
  forget(): void {
    this.#chosen = null;
    this.#error = null;
    this.#isKept = false;
  }

  /** The visible part of the volume changed: probe again where its picture is smooth. */
  forgetProbes(): void {
    this.forget();
    this.#fast = null;
    this.#errors = { ...this.#errors, sampling: [] };
  }

  /** The volume changed: the measured times are no longer valid either. */
  forgetAll(): void {
    this.forgetProbes();
    this.#errors = unknownErrors;
    this.#timer.forget();
    this.#last = undefined;
  }

  /** The plan for a picture at rest, as far as it is known. */
  still(grid: GridFrame): FrameQuality {
    return { ...this.#withoutEdges(grid), edgeCurvature: curvaturePerError * this.#targets.maxError };
  }

  #withoutEdges(grid: GridFrame): FrameQuality {
    const { steps, maxError } = this.#targets;
    if (steps !== 'auto')
      return { scale: 1, steps, substeps: this.#cuts ? allSubsteps : wholeSteps, sampling: allRays };
    const oneAVoxel = autoSteps(grid);
    const level: ChosenSteps = this.#chosen ?? { steps: oneAVoxel, substeps: 1 };
    // Cells influence the sampling as soon as the code that chooses steps is loaded: before that, no picture at rest is drawn.
    const substeps = this.#tools?.cutsOfLevels(voxelsAlong(grid), maxError).own(level) ?? wholeSteps;
    return { scale: 1, steps: level.steps, substeps, sampling: allRays, ...level.free };
  }

  /** Whether probing still has to find the steps of a picture at rest. */
  get undecided(): boolean {
    return this.#targets.steps === 'auto' && this.#chosen === null;
  }

  /** The plan for a picture that the next one will replace at once. */
  moving(grid: GridFrame, pixels: number): FrameQuality {
    const { steps, targetFps } = this.#targets;
    if (steps !== 'auto') return this.#withoutEdges(grid);
    // A small picture always has the plan of its picture at rest, so that it does not flicker.
    if (this.#fast?.pixels === pixels) return this.#fast.plan;
    const { model } = this.#timer;
    const full = { pixels, steps: autoSteps(grid) };
    if (!model || !this.#tools) return { ...firstFrame, steps: Math.min(full.steps, firstFrame.steps) };
    this.#last = this.#tools.chooseFrameQuality(model, this.#errors, full, {
      budgetMs: (planned * 1000) / targetFps,
      last: this.#last,
    });
    return this.#last;
  }

  /**
   * The number of rows in the first piece of a picture at rest that is drawn piecewise, so that each piece takes at most a frame's
   * time.
   * @returns null where the whole picture takes little more than that
   */
  rowsOfPieces({ width, height }: Size, plan: FrameQuality): number | null {
    const { model } = this.#timer;
    if (!model || this.#targets.steps !== 'auto') return null;
    if (model.a + model.b * workOfFrame(plan, width * height) <= worthPieces * this.pieceMs) return null;
    return Math.max(minRows, Math.floor(Math.max(0, this.pieceMs - model.a) / (model.b * workOfFrame(plan, width))));
  }

  /** The time that a frame, and a piece of a picture at rest, may take. */
  get pieceMs(): number {
    return (planned * 1000) / this.#targets.targetFps;
  }

  /**
   * Learn from the time of a picture that was drawn at once, and from the GPU's part of it, where that is known.
   * @param pixels - of the full picture
   */
  took(plan: FrameQuality, pixels: number, ms: number, gpuMs: number | null = null): void {
    this.#hasSpared ||= plan.sampling !== allRays;
    const steady = (this.#steady ??= this.#tools && new this.#tools.SteadyTime())?.of(ms, gpuMs) ?? ms;
    // The time of steps that cells cut does not predict that of others.
    if (plan.substeps === wholeSteps) this.#timer.add({ work: workOfFrame(plan, pixels), ms: steady });
    else this.#fast = steady <= this.pieceMs ? { plan, pixels } : null;
  }

  /**
   * Start to load the code that measures errors and plans frames, and the code that draws piece by piece: both are needed as soon
   * as there is a picture.
   */
  warmUp(): void {
    if (this.#tools) return;
    const tools = loadTools().then((tools) => (this.#tools = tools));
    for (const part of [tools, import('./gather-picture.ts')]) part.catch(() => {}); // Reported when it is needed.
  }

  /** Load the code that cuts given steps before the first picture that has such steps. @throws {VolumeViewError} `format/unsupported` */
  async prepare(): Promise<void> {
    if (this.#targets.steps === 'auto' || this.#cuts) return;
    await (this.#tools ??= await loadTools()).loadSubsteps();
    this.#cuts = true;
  }

  /** Whether the time of pictures is still unknown. */
  get untimed(): boolean {
    return this.#targets.steps === 'auto' && this.#timer.model === null;
  }

  /**
   * Probe the error of the view that has just been drawn. The page can work between one level and the next.
   * @returns whether it should be drawn again, with other steps or more pixels
   */
  async probe(scene: Scene, grid: GridFrame, probed: Probed): Promise<boolean> {
    const { ViewQuality, learnFrom } = (this.#tools ??= await loadTools());
    if (!probed.goesOn()) return false;
    const { plan } = probed;
    const drawn = { ...probed, scene, grid };
    const view = new ViewQuality(drawn, this.#targets);
    if (this.undecided) {
      const found = await view.choose();
      if (!found) return false;
      this.#chosen = found.level;
      this.#state(found);
    }
    const target = this.still(grid);
    const isAtRest = plan.scale === 1 && plan.steps === target.steps && plan.sampling === target.sampling;
    if (
      !isAtRest ||
      plan.substeps.max !== target.substeps.max ||
      plan.substeps.voxelsPerStep !== target.substeps.voxelsPerStep
    )
      return true;
    if (this.#targets.steps === 'auto')
      this.#errors = { ...this.#errors, ...(await learnFrom(drawn, this.#hasSpared)) };
    else if (!this.#error) this.#state(await view.measure({ steps: plan.steps, substeps: plan.substeps.max }));
    return false;
  }

  #state(found: QualityFinding | null): void {
    if (found) [this.#error, this.#isKept] = [found.error, found.isKept];
  }
}
