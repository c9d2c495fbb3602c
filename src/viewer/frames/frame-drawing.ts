import type { FrameQuality } from '../../quality/frame-quality.ts';
import type { PictureDrawing } from './picture-drawing.ts';
import { pictureSize } from '../model/picture-size.ts';
import type { PictureSize } from '../model/picture-size.ts';
import { firstFrame, standInFrame } from './quality-control.ts';
import type { QualityControl } from './quality-control.ts';
import type { RenderStats } from '../model/render-stats.ts';
import type { Scene } from '../model/scene.ts';

/**
 * A small first volume with fewer bytes than this, which is shown in place of a large one, is replaced soon: it is not drawn a
 * second time.
 */
const lastingBytes = 2 ** 21;

/** Draws frames: each with the steps, pixels and rays that the quality control chooses. The control learns from each frame. */
export class FrameDrawing {
  /** Whether the frame in progress, or the last one, has shown the final picture. What is measured for pictures in motion comes after it. */
  isFinal = false;

  /**
   * @param host - the element, whose size the picture has
   * @param notify - called with the facts about each frame
   */
  constructor(
    readonly host: Element,
    readonly quality: QualityControl,
    readonly pictures: PictureDrawing,
    readonly notify: (stats: RenderStats) => void,
  ) {}

  /** Draw the next frame. @returns whether another must follow, because this one is not final */
  async drawFrame(time: number): Promise<boolean> {
    const { controller, loop, shown } = this.pictures.parts;
    this.isFinal = false;
    await this.quality.prepare();
    const { volume } = shown;
    if (!volume) return false;
    const inMotion = loop.host.moving || loop.host.animating;
    const { coarse, samples } = volume;
    const isBrief = coarse === true && samples.byteLength < lastingBytes;
    const isFirst = this.pictures.drawn === null && this.quality.untimed;
    if (!inMotion && (isBrief || isFirst)) return this.#drawStandIn(time, !isBrief);
    // At rest too, a quick picture shows how long others take, once its program is compiled.
    const { untimed } = this.quality;
    if (untimed && (inMotion || controller.isNew)) await this.#time(time);
    const { scene } = controller;
    if (!scene) return false;
    const size = this.sizeIn(scene);
    // At rest too, the first picture of a view appears within a frame's time, and a better one follows.
    const quick = inMotion || (this.quality.undecided && !volume.finer?.moving);
    const plan = !quick
      ? this.planAtRest
      : untimed && !inMotion
        ? standInFrame
        : this.quality.moving(shown.grid, size.width * size.height);
    const rows = quick || !scene.gatherable ? null : this.quality.rowsOfPieces(size, plan);
    const stats = rows
      ? await this.pictures.gather(scene, plan, size, { rows, pieceMs: this.quality.pieceMs })
      : await this.#draw(scene, time, plan);
    if (!stats) return true;
    // What is coming changes the picture: its error is measured when all is there.
    const atRest = !inMotion && !loop.dirty && controller.scene === scene && !volume.finer?.moving;
    // Report the picture at once if its error is known; else when the error has been measured.
    const isKnown = quick || this.quality.error !== null;
    if (isKnown) this.#notify(stats);
    const goesOn = (): boolean => !loop.dirty && !loop.host.moving && controller.scene === scene;
    const again = atRest && (await this.quality.probe(scene, shown.grid, { plan, size, goesOn, volume }));
    if (!isKnown || (quick && atRest && !again)) this.#notify(stats);
    return again || inMotion;
  }

  /** Draw a coarse picture at once: the time of a frame is not known yet. @returns `again` */
  async #drawStandIn(time: number, again: boolean): Promise<boolean> {
    const { scene } = this.pictures.parts.controller;
    this.quality.warmUp();
    if (scene) this.#notify(await this.#draw(scene, time, standInFrame, false));
    return again;
  }

  /** Draw the present picture at rest at once. */
  async drawNow(scene: Scene): Promise<RenderStats> {
    return this.#notify(await this.#draw(scene, performance.now(), this.planAtRest));
  }

  get planAtRest(): FrameQuality {
    return this.quality.still(this.pictures.parts.shown.grid);
  }

  sizeIn(scene: Scene): PictureSize {
    return pictureSize(this.host, scene.device.maxTextureSize);
  }

  /**
   * Draw a small picture, no smaller than the one on the screen, to measure how long larger ones take. The first picture of a
   * scene compiles the shader, so its time is not used.
   */
  async #time(time: number): Promise<void> {
    const { controller } = this.pictures.parts;
    const plan = this.pictures.drawn ? standInFrame : firstFrame;
    this.quality.warmUp();
    if (controller.isNew && controller.scene) await this.#draw(controller.scene, time, plan, false);
    if (controller.scene) await this.#draw(controller.scene, time, plan);
  }

  async #draw(scene: Scene, time: number, plan: FrameQuality, counts = true): Promise<RenderStats> {
    const full = this.sizeIn(scene);
    const { stats, gpuMs, compiled } = await this.pictures.draw(scene, time, plan, full);
    if (counts && !compiled) this.quality.took(plan, full.width * full.height, stats.frameMs, gpuMs);
    return stats;
  }

  /** Report the picture that was drawn, together with its measured error. */
  #notify(drawn: RenderStats): RenderStats {
    const converged = this.#converges(drawn);
    const error = converged ? this.quality.error : null;
    // A picture that shows nothing keeps no error target.
    const { loop, shown } = this.pictures.parts;
    const { finer } = shown.volume!;
    const keepsMaxError = error && this.quality.isKept && error.rays > 0;
    const stats = { ...drawn, converged, error, keepsMaxError, ...(finer && { bricks: finer.held }) };
    this.notify(stats);
    this.isFinal = converged;
    loop.wake();
    return stats;
  }

  #converges({ width, height, steps, substeps, maxCurvature }: RenderStats): boolean {
    const { controller, loop, shown } = this.pictures.parts;
    const { coarse, finer } = shown.volume!;
    if (!controller.scene || loop.dirty || loop.host.moving || coarse || finer?.moving || this.quality.undecided)
      return false;
    const full = this.sizeIn(controller.scene);
    const plan = this.planAtRest;
    return (
      width === full.width &&
      height === full.height &&
      steps === plan.steps &&
      substeps === plan.substeps.max &&
      maxCurvature === plan.sampling.maxCurvature
    );
  }
}
