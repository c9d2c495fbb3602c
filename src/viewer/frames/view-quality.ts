import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import { maxSubsteps } from '../../optics/transfer/substep-limits.ts';
import { forecastSampling } from '../../quality/adaptive-sampling.ts';
import { chooseLevel } from '../../quality/choose-level.ts';
import type { ErrorEstimate } from '../../quality/error-estimate.ts';
import { boundProjected, seekMissed, stateError } from '../../quality/largest-error.ts';
import { cutsOfLevels as cutsBy, listLevels } from '../../quality/levels.ts';
import type { Level, LevelCuts } from '../../quality/levels.ts';
import type { ErrorModel } from '../../quality/frame-quality.ts';
import { longSteps } from '../../renderer/ray/long-steps.ts';
import { autoSteps, maxAutoSteps, voxelsAlong } from '../../quality/steps.ts';
import { loadPart } from '../../core/load-part.ts';
import type { AskedQuality, ChosenLevel, QualityFinding } from './chosen-level.ts';
import type { DrawnView } from '../model/drawn-view.ts';
import type { Scene } from '../model/scene.ts';
import { loadSubsteps } from './provide-sampling.ts';
import { aside, errorAtHalf, ErrorProbe } from './measure-quality.ts';
import { measuringTools } from './measuring-tools.ts';
import { timeSampling } from './time-sampling.ts';

export { faint } from '../../quality/error-estimate.ts';
export { chooseFrameQuality } from '../../quality/choose-frame-quality.ts';
export { SteadyTime } from '../../quality/steady-time.ts';
export { loadSubsteps } from './provide-sampling.ts';
export { seenPixels } from './measure-quality.ts';

/** The probes that chose the level of a scene's last view: pictures in motion are compared with the finest of them. */
const lastChosen = new WeakMap<Scene, { readonly quality: ViewQuality; readonly level: Level }>();

/**
 * An upper bound of what sampling may miss in the visible volume, by samples per voxel and by the sampling of cells: it depends on
 * the volume and its appearance, not on the view.
 */
const missed = new WeakMap<
  SeenVolume,
  { readonly samplesAVoxel: number; readonly codes: Uint8Array | null; readonly bound: number }
>();

/** How steps are cut in the pictures of a view, see quality/levels.ts. */
export function cutsOfLevels(oneAVoxel: number, maxError: number | null): LevelCuts {
  return cutsBy(oneAVoxel, maxError, longSteps);
}

/** A little more than the error of rounding to 8 bits, whatever the steps: RMS, 1/255. */
const aboveRounding = 1.2 / Math.sqrt(12);

/** Where bricks that are not there hide more, steps may have this share of what they hide: less would not be seen, and takes long. */
const shareOfHidden = 0.25;

/** Numbers of steps that measure how the error of pictures in motion falls: such pictures have them where time is short. */
const inMotion = [32, 128] as const;

/** Strides between pixels for which the result of adaptive sampling is predicted: for pictures at full, half and quarter size. */
const foretold: readonly number[] = [1, 2, 4];

/** Measures how good pictures of a view are, or would be, by probing its rays. */
export class ViewQuality {
  readonly cuts: LevelCuts;
  readonly #probe: ErrorProbe;

  constructor(
    readonly view: DrawnView,
    readonly asked: AskedQuality,
  ) {
    const { scene, grid, size } = view;
    this.cuts = cutsOfLevels(voxelsAlong(grid), this.#isAuto ? asked.maxError : null);
    this.#probe = new ErrorProbe(scene, { grid, size, cuts: this.cuts });
  }

  /** Whether the viewer chooses the steps. */
  get #isAuto(): boolean {
    return this.asked.steps === 'auto';
  }

  /**
   * The first level that keeps the target. A device that can't measure errors gets one step per voxel, with all substeps.
   * @returns null where the view is no longer needed
   */
  async choose(): Promise<ChosenLevel | null> {
    const { isFree } = this.asked;
    return this.#withLoss(
      isFree
        ? await (await loadPart(import('./free-quality.ts'), 'cuts steps')).chooseFree(this, measuringTools)
        : await this.chooseUsual(),
    );
  }

  /** What a lossy form of the volume, or bricks that are not there, leave in its pictures is part of their error, but decides no level. */
  async #withLoss<T extends QualityFinding>(found: T | null): Promise<T | null> {
    const { volume, scene } = this.view;
    if (!found || !(volume?.lossy || volume?.finer)) return found;
    const part = await loadPart(import('./lossy-quality.ts'), 'bounds errors');
    return part.includeLoss(found, volume, scene.whatIsSeen(), this.asked.maxError);
  }

  /** The same where nothing small may be lost. */
  async chooseUsual(): Promise<ChosenLevel | null> {
    const {
      view: { scene, grid, volume, goesOn },
      asked: { maxError },
    } = this;
    const probe = this.#probe;
    const levels = listLevels(autoSteps(grid), scene.cutsSteps && !scene.walksVoxels);
    if (!(await probe.prepare(levels[0], goesOn))) return null;
    if (!probe.estimate(levels[0])) {
      await loadSubsteps();
      return { level: { steps: levels[0].steps, substeps: maxSubsteps }, error: null, isKept: false };
    }
    const choice = await chooseLevel(
      levels,
      async (level) => {
        if (level.substeps > 1) await loadSubsteps();
        const estimate = (await probe.prepare(level, goesOn)) ? probe.estimate(level) : null;
        return estimate && this.#discount(estimate); // The estimate is also null where the context was lost meanwhile.
      },
      Math.max(maxError, shareOfHidden * (volume?.finer?.error?.rms ?? 0)),
    );
    if (choice) this.remember(choice.level);
    const found = choice && (await this.#state(choice.level));
    return found && { level: choice.level, ...found };
  }

  /** With the steps of this level and finer ones, pictures in motion are compared. */
  remember(level: Level): void {
    lastChosen.set(this.view.scene, { quality: this, level });
  }

  /** The error of the level that was chosen. */
  estimate(level: Level): ErrorEstimate | null {
    return this.#probe.estimate(level);
  }

  /** Measure the error of an author's steps; null where there are too many to measure it, or the view is no longer needed. */
  async measure(level: Level): Promise<QualityFinding | null> {
    if (level.steps > maxAutoSteps) return null;
    await loadSubsteps(); // Steps longer than a voxel are compared with steps that are cut.
    return (await this.#probe.prepare(level, this.view.goesOn)) ? this.#withLoss(await this.#state(level)) : null;
  }

  /** If rounding alone exceeds the target, the error is compared without rounding: more steps could not help. */
  #discount(estimate: ErrorEstimate): ErrorEstimate {
    return this.asked.maxError > aboveRounding ? estimate : { ...estimate, rms: estimate.discretization };
  }

  /** @returns null where the view is no longer needed */
  async #state(level: Level): Promise<QualityFinding | null> {
    const {
      view: { scene, grid },
      asked: { maxError },
      cuts,
    } = this;
    const estimate = this.#probe.estimate(level);
    const samplesAVoxel = level.steps / voxelsAlong(grid);
    // Matter behind the eye, or outside the picture, can't be missed.
    const seen = this.#probe.rectangle && scene.whatIsSeen();
    const cut = cuts.own(level);
    const codes = this.#isAuto ? scene.detail(cut) : null;
    const projection = seen && scene.projection(cut);
    const bound = !seen
      ? 0
      : projection
        ? boundProjected(seen, projection, samplesAVoxel)
        : ((await this.#boundAtJumps(seen, level, estimate)) ?? (await this.#bound(seen, samplesAVoxel, codes)));
    if (bound === null) return null;
    return estimate ? stateError(estimate, bound, maxError) : { error: null, isKept: false };
  }

  /** The bound where rays search for what is opaque at once; null if there is nothing of that kind, or it is not known. */
  async #boundAtJumps(seen: SeenVolume, level: Level, estimate: ErrorEstimate | null): Promise<number | null> {
    if (!seen.found || !estimate) return null;
    const part = await loadPart(import('./jump-quality.ts'), 'bounds errors');
    const { view, cuts } = this;
    return part.boundAtJumps({ view, cuts, seen, probe: this.#probe }, level, estimate, measuringTools);
  }

  async #bound(seen: SeenVolume, samplesAVoxel: number, codes: Uint8Array | null): Promise<number | null> {
    const known = missed.get(seen);
    if (known?.samplesAVoxel === samplesAVoxel && known.codes === codes) return known.bound;
    const found = await aside(seekMissed(seen, samplesAVoxel, codes), this.view.scene, this.view.goesOn);
    if (found) missed.set(seen, { samplesAVoxel, codes, bound: found.value });
    return found && found.value;
  }

  /**
   * How the error of pictures in motion, over all pixels, falls with their steps; nothing where it can't be measured, or is no
   * longer needed.
   */
  async learnSteps(level: Level, goesOn: () => boolean): Promise<Partial<ErrorModel>> {
    const max = autoSteps(this.view.grid);
    const steps = [Math.min(inMotion[0], Math.ceil(max / 4)), Math.min(inMotion[1], max)] as const;
    const isPrepared = await this.#probe.prepareDistances(steps, level, goesOn);
    if (!isPrepared) return {};
    const [error, next] = steps.map((n) => this.#probe.distance(n, level));
    if (error === null || next === null) return {};
    const order = Math.min(
      2.5,
      Math.max(1, Math.log(Math.max(1e-6, error) / Math.max(1e-6, next)) / Math.log(steps[1] / steps[0])),
    );
    return { steps: steps[0], error: Math.max(0.01, error), order };
  }
}

/** Give the page time for other work. */
const rest = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/**
 * Measure from the picture at rest on the screen what error fewer steps, pixels and rays would cause in pictures in motion;
 * nothing where the view is no longer needed.
 * @param isTimed - whether to measure the time of fewer rays: this compiles their program, which a page where nothing moves does
 * not need
 */
export async function learnFrom(view: DrawnView, isTimed: boolean): Promise<Partial<ErrorModel>> {
  const { scene } = view;
  const read = scene.startReading();
  await scene.finished();
  if (!view.goesOn()) return {};
  const picture = read();
  const chosen = lastChosen.get(scene);
  const learned = await chosen?.quality.learnSteps(chosen.level, view.goesOn);
  await rest();
  if (!view.goesOn()) return {};
  const { adaptive } = scene;
  const among = adaptive ? scene.readVolume() : null;
  await rest();
  const foreseen = adaptive
    ? await aside(forecastSampling(picture, foretold, among), scene, view.goesOn)
    : { value: [] };
  if (!foreseen) return {};
  const sampling = foreseen.value;
  const cost = isTimed ? await timeSampling(view, [sampling[1] ?? [], sampling[0] ?? []].flat()) : 1;
  return {
    ...learned,
    atHalf: Math.max(0.1, errorAtHalf(picture)),
    sampling: sampling.map((list) => list.map((one) => ({ ...one, cost: one.share * cost }))),
  };
}
