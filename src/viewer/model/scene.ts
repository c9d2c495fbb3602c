import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import type { Pixels } from '../../optics/rays/between-pixels.ts';
import type { Camera } from '../../optics/rays/camera.ts';
import type { PixelLattice, RaySetup } from '../../optics/rays/rays.ts';
import type { SceneLights } from '../../optics/transfer/lights.ts';
import type { ViewpointFrame } from '../../optics/rays/viewpoint-frame.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import type { ProjectedRays } from '../../optics/rays/ray-style.ts';
import type { Appearance, Optics } from '../../renderer/ray/ray-module.ts';
import type { RayPlan } from '../../renderer/ray/ray-plan.ts';
import type { AmongShapes } from '../../quality/adaptive-sampling.ts';
import type { RayTwins } from '../../renderer/ray/ray-twin.ts';
import type { Device } from '../../renderer/device/device.ts';
import type { Pass, Size } from '../../renderer/passes/pass-drawing.ts';
import type { Substeps, View } from '../../renderer/layers/volume-layer.ts';
import type { ShownSurface } from '../../renderer/layers/shown-surfaces.ts';
import type { ShownLabels } from '../../volume/labels.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import type { FramePlan, Lines } from './frame-plan.ts';

export type { Lines } from './frame-plan.ts';
export type { Optics } from '../../renderer/ray/ray-module.ts';
export type { Pass, Size } from '../../renderer/passes/pass-drawing.ts';
export type { Substeps, View } from '../../renderer/layers/volume-layer.ts';

/** The author's viewpoint. */
export interface AuthorCamera {
  readonly camera: Camera;
  /** In world coordinates; null where the author gave none. */
  readonly centerOfRotation: Vector3 | null;
  /** How to turn the viewpoint around what is shown. */
  readonly around: (subject: { center: Vector3; radius: number }) => ViewpointFrame;
}

/** Shows lines and surfaces of several owners in a scene. */
export interface SceneLines {
  /** @param color - red, green and blue, 0..1 */
  show(lines: Lines, owner: object, color: readonly [red: number, green: number, blue: number]): void;
  /**
   * @param shown - null for none
   * @returns resolves when the next picture shows it; rejects where the code that draws surfaces could not be loaded
   */
  showSurface(shown: ShownSurface | null, owner: object): Promise<void>;
}

/**
 * A volume among the author's shapes on a canvas with a WebGL context. It draws only when it is called, never by itself. This is
 * all that the viewer knows about drawing; the factory decides which class implements it.
 */
export interface Scene {
  readonly canvas: HTMLCanvasElement;
  readonly device: Pick<Device, 'maxTextureSize' | 'webgl2'>;

  /** Load the code that only some volumes and some optics need. @throws {VolumeViewError} `format/unsupported` */
  prepare(volume: Volume, optics: Optics): Promise<void>;
  /**
   * Put a volume on the GPU; the previous one is shown until the GPU has all of the new one.
   * @returns whether it is in place; false where it was given up or the context was lost
   */
  bringVolume(volume: Volume, givenUp: () => boolean): Promise<boolean>;
  /**
   * Set the optics, the style, or both in the same picture; what is not given stays.
   * @returns resolves when the next picture shows them: at once where no code has to be loaded.
   * @throws {VolumeViewError} `format/unsupported`
   */
  setAppearance(appearance: Partial<Appearance>): Promise<void>;
  /**
   * Show labels of the volume, on its own grid; a volume with other dimensions does not show them. Null removes them. The first
   * call loads the code that draws labels, so callers pass null only where there were labels.
   * @returns resolves when the next picture shows them @throws {VolumeViewError} `format/unsupported`, `format/too-large`
   */
  setLabels(labels: ShownLabels | null): Promise<void>;
  /** Show a second field over its volume; null removes it, where there was one. @returns and @throws as `setLabels` */
  setOverlay(overlay: ShownOverlay | null): Promise<void>;
  /** Load the code that shows lines of other owners. @returns null where it could not be loaded; the scene then works without it */
  loadLines(): Promise<SceneLines | null>;
  /** Resolves when the author's shapes that were added meanwhile are in the scene. */
  othersReady(): Promise<void>;

  /** Whether the scene moves by itself, so that drawing has to continue. */
  readonly animating: boolean;
  /** null where the author has no viewpoint. */
  authorCamera(): AuthorCamera | null;
  /** Undo what plans did to the author's viewpoint. */
  resetAuthorCamera(): void;
  /**
   * Use a plan: the next picture has all of it, and nothing of the plan before. What must be loaded or uploaded first is no part of a plan:
   * the volume, its optics and style, labels and other fields. They may be set in any order, before and after.
   */
  apply(plan: FramePlan): void;
  /** The view that the next picture will have. */
  getView(): View;
  /** The same for a picture of another size. */
  viewAt(picture: Size): View;
  /** The rays of the next picture; null without a volume. */
  getRays(): RaySetup | null;

  /**
   * The rays of the next picture as they are cast, in float64, without the shapes at which some rays end; null without a volume.
   * The result stays usable when the scene is gone.
   * @param looks - whether rays look for opaque matter at once; where absent, as in pictures with the present plan
   */
  twins(looks?: boolean): RayTwins | null;
  /**
   * How finely each macrocell must be sampled at least, see optics/cells/cell-detail.ts; null where cells do not change the sampling.
   * @param substeps - how steps are cut; where absent, as in the plan
   */
  detail(substeps?: Substeps): Uint8Array | null;
  /** The lights on a lit volume; null for one light at the eye. */
  lights(): SceneLights | null;
  /** Whether substeps change the results of rays at all. */
  readonly cutsSteps: boolean;
  /** Whether the rays of a picture at rest go from one plane of voxels to the next: then the values at the ends of a step never cut it. */
  readonly walksVoxels: boolean;
  /** How rays show single values, if they do; null where they show emission and absorption. @param substeps - how steps are cut */
  projection(substeps: Substeps): ProjectedRays | null;
  /** In which macrocells of the present volume something is visible, and what; null where there is no volume. */
  whatIsSeen(): SeenVolume | null;
  /** Whether the next picture may be drawn with fewer rays than pixels. */
  readonly adaptive: boolean;
  /** Draw one picture by the plan. @throws {VolumeViewError} `webgl/shader` */
  draw(time?: number): void;
  /** Whether the next picture can be drawn piece by piece. */
  readonly gatherable: boolean;
  /** Whether rays of the last picture end at shapes. */
  readonly endsAtShapes: boolean;
  /**
   * Begin a picture that is drawn piece by piece, at the view of the last one.
   * @param rays - what differs from the plan of the last picture
   * @returns its passes, one lattice of pixels after the other
   */
  startGathering(rays: Partial<RayPlan>, picture: Size): readonly Pass[];
  /** Draw some rows of a pass into a buffer that is not on the screen yet. */
  gather(rays: Partial<RayPlan>, part: { pass: Pass; firstRow: number; rows: number }, picture: Size): void;
  /** Show the picture that has been gathered; its plan must be in use. */
  drawGathered(time?: number): void;
  /** Resolves when the GPU has drawn everything that was sent to it. */
  finished(): Promise<void>;
  /** GPU time of the last `draw`, ms; null where it can't be measured. */
  gpuMs(): Promise<number | null>;

  /**
   * Draw some rays of the last picture.
   * @param rays - what differs from the plan of that picture
   * @param alone - no ray ends at a shape
   * @returns a function that reads these rays, once, also after others were drawn; it returns null where the context was lost.
   * null instead of the function where the device can't do it
   */
  startProbe(
    rays: Partial<RayPlan>,
    lattice: PixelLattice,
    picture: Size,
    alone?: boolean,
  ): (() => Float32Array | null) | null;
  /** The last picture: premultiplied, bottom row first. */
  readPicture(): Pixels;
  /** The same: the function waits for the GPU only if that has not `finished` since. */
  startReading(): () => Pixels;
  /**
   * The volume of the last picture, which got all its rays, without the shapes around it, and how these shapes change quads; null
   * where there are no shapes.
   */
  readVolume(): AmongShapes | null;

  /** Give back the author's elements, the memory of the GPU and the context. */
  dispose(): void;
}

/** Makes scenes. */
export interface SceneFactory {
  /**
   * @param host - the element whose X3D children join the scene
   * @param container - where the canvas goes
   * @param needsFrame - called when something in the scene changed and a picture is due
   * @throws {VolumeViewError} `x3dom/unavailable`, `webgl/unavailable` or `webgl/unsupported`
   */
  create(host: Element, container: Element, needsFrame: () => void): Promise<Scene>;
  /** Start to load what scenes need; a failure is reported when the part is needed. @param kind - of the picture; only if it is known */
  warmUp(kind?: 'lit' | 'radar'): void;
}
