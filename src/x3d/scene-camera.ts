import { viewMatrix } from '../optics/rays/camera.ts';
import type { Camera } from '../optics/rays/camera.ts';
import type { Matrix4 } from '../volume/matrix.ts';
import type { Size } from '../renderer/passes/pass-drawing.ts';
import type { StartedCanvas } from './start-canvas.ts';
import type { View } from '../renderer/layers/volume-layer.ts';
import type { X3dMatrix, X3dom, X3dViewpoint } from './x3dom-types.ts';

/** The camera of an x3dom scene: the author's viewpoint, or else the scene's own. */
export class SceneCamera {
  readonly #own: X3dViewpoint;

  /** @param author - returns the author's viewpoint, null if there is none */
  constructor(
    readonly x3dom: X3dom,
    readonly started: StartedCanvas,
    readonly author: () => X3dViewpoint | null,
  ) {
    this.#own = started.document._scene.getViewpoint();
  }

  /** Sets the camera. */
  set(camera: Camera): void {
    const viewpoint = this.author() ?? this.#own;
    if (viewpoint === this.#own && viewpoint._vf.fieldOfView !== camera.fieldOfView) {
      viewpoint._vf.fieldOfView = camera.fieldOfView;
      viewpoint.fieldChanged('fieldOfView');
    }
    viewpoint.setView(new this.x3dom.fields.SFMatrix4f(...viewMatrix(camera)));
  }

  /** Size of the picture in device pixels. */
  resize(picture: Size): void {
    const { canvas } = this.started.canvas;
    const { width, height } = picture;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    this.#shape(picture);
  }

  /** The view of the next picture. */
  view(): View {
    const runtime = this.started.element.runtime!;
    this.forgetProjection();
    return { view: toRowMajor(runtime.viewMatrix()), projection: toRowMajor(runtime.projectionMatrix()) };
  }

  /** x3dom does not notice a new aspect ratio if the clipping planes changed in the same frame. */
  forgetProjection(): void {
    this.started.document._scene.getViewpoint()._projMatrix = null;
  }

  /**
   * The view of a picture of another size. Rays follow its aspect ratio, which differs from the canvas's because of
   * rounding.
   */
  viewAt(picture: Size): View {
    return this.at(picture, () => this.view());
  }

  /** Runs code as if the canvas had another size. */
  at<T>(picture: Size, work: () => T): T {
    const { _width, _height } = this.started.document._viewarea;
    this.#shape(picture);
    this.forgetProjection();
    try {
      return work();
    } finally {
      this.#shape({ width: _width, height: _height });
    }
  }

  #shape({ width, height }: Size): void {
    const { _viewarea } = this.started.document;
    [_viewarea._width, _viewarea._height] = [width, height];
  }
}

export function toRowMajor(m: X3dMatrix): Matrix4 {
  return [
    m._00,
    m._01,
    m._02,
    m._03,
    m._10,
    m._11,
    m._12,
    m._13,
    m._20,
    m._21,
    m._22,
    m._23,
    m._30,
    m._31,
    m._32,
    m._33,
  ];
}
