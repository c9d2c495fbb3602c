import { loadPart } from '../../core/load-part.ts';
import { countSamples } from '../../optics/rays/count-samples.ts';
import type { FrameQuality } from '../../quality/frame-quality.ts';
import type { Volume } from '../../volume/volume.ts';
import type { AuthorView } from '../camera/author-view.ts';
import type { FrameLoop } from '../scenes/frame-loop.ts';
import type { Pieces } from './gather-picture.ts';
import { planFrame } from '../model/frame-plan.ts';
import type { FramePlan } from '../model/frame-plan.ts';
import type { PictureSize } from '../model/picture-size.ts';
import type { RenderStats } from '../model/render-stats.ts';
import type { Scene } from '../model/scene.ts';
import type { ViewSocket } from '../model/view-socket.ts';
import type { SceneController } from '../scenes/scene-controller.ts';
import type { ShownVolume } from '../cuts/shown-volume.ts';

/** The parts that drawing uses. */
export interface DrawingParts {
  readonly shown: ShownVolume;
  readonly author: AuthorView;
  /** The parts that show something over the picture have joined here. */
  readonly socket: Pick<ViewSocket, 'place'>;
  readonly loop: FrameLoop;
  readonly controller: SceneController;
}

/** A picture that has been drawn. */
export interface DrawnPicture {
  readonly stats: RenderStats;
  /** GPU time, ms; null where it is not known. */
  readonly gpuMs: number | null;
  /** Whether its program was compiled first: then its time does not predict the next one's. */
  readonly compiled: boolean;
}

/** Draws pictures of the shown volume by a plan, at once or piece by piece, and returns the facts about them. */
export class PictureDrawing {
  #drawn: Volume | null = null;
  /** The share of the piecewise picture that is drawn, 0..1; null where there is no such picture. */
  gathered: number | null = null;

  constructor(readonly parts: DrawingParts) {}

  /** The volume in the last picture. */
  get drawn(): Volume | null {
    return this.#drawn;
  }

  /**
   * Draw a picture at once, and wait for the GPU.
   * @param full - pixels of the picture at a scale of 1
   */
  async draw(scene: Scene, time: number, quality: FrameQuality, full: PictureSize): Promise<DrawnPicture> {
    const { shown, controller, loop } = this.parts;
    const { volume } = shown;
    loop.takeChanges();
    const plan = this.#plan(quality, full);
    this.#apply(scene, plan);
    const began = performance.now();
    const compiled = controller.isNew;
    scene.draw(time);
    controller.hasDrawn();
    await this.#finish(scene, volume);
    const frameMs = performance.now() - began;
    const gpuMs = await scene.gpuMs();
    return { stats: this.#describe(quality, plan, frameMs), gpuMs, compiled };
  }

  /**
   * Draw a picture at rest that takes long, piece by piece.
   * @param pieces - rows of the first piece, and the time that each may take, ms
   * @returns null where something changed meanwhile
   * @throws {VolumeViewError} `format/unsupported` where that part of the package could not be loaded
   */
  async gather(scene: Scene, quality: FrameQuality, size: PictureSize, pieces: Pieces): Promise<RenderStats | null> {
    const { shown, controller, loop } = this.parts;
    const { gatherPicture } = await loadPart(import('./gather-picture.ts'), 'shows pictures');
    if (controller.scene !== scene) return null;
    const { volume } = shown;
    loop.takeChanges();
    const plan = this.#plan(quality, size);
    const goesOn = (): boolean =>
      !loop.dirty && !loop.host.moving && !loop.host.animating && controller.scene === scene;
    const frameMs = await gatherPicture(scene, { plan, ...pieces }, goesOn, (share) => (this.gathered = share));
    this.gathered = null;
    if (frameMs === null) return null;
    this.#apply(scene, plan);
    scene.drawGathered();
    await this.#finish(scene, volume);
    return this.#describe(quality, plan, frameMs);
  }

  /** Draw a picture of any size into the canvas, without waiting for the GPU. */
  drawAtRest(scene: Scene, quality: FrameQuality, size: PictureSize): void {
    this.#apply(scene, this.#plan(quality, size));
    scene.draw();
    this.parts.controller.hasDrawn();
  }

  #plan(quality: FrameQuality, size: PictureSize): FramePlan {
    const { shown, author } = this.parts;
    return planFrame({ shown, quality, size, camera: author.cameraFor(size.width / size.height) });
  }

  #apply(scene: Scene, plan: FramePlan): void {
    scene.apply(plan);
    this.parts.author.applied(scene, plan.camera);
  }

  async #finish(scene: Scene, volume: Volume | null): Promise<void> {
    this.parts.socket.place(scene.getView());
    await scene.finished();
    this.#drawn = volume;
  }

  #describe(
    { steps, substeps, sampling: { share, maxCurvature } }: FrameQuality,
    { stepLength, picture }: FramePlan,
    frameMs: number,
  ): RenderStats {
    const rays = this.parts.controller.scene?.getRays();
    const samples = rays ? countSamples(rays, stepLength, picture.width * picture.height * share) : 0;
    return {
      frameMs,
      steps,
      substeps: substeps.max,
      stepLength,
      ...picture,
      rays: share,
      maxCurvature,
      samples,
      converged: false,
      error: null,
      keepsMaxError: null,
    };
  }
}
