import { viewMatrix } from '../optics/rays/camera.ts';
import type { Camera } from '../optics/rays/camera.ts';
import type { Matrix4 } from '../volume/matrix.ts';
import type { Size } from '../renderer/passes/pass-drawing.ts';
import type { StartedCanvas } from './start-canvas.ts';
import type { View } from '../renderer/layers/volume-layer.ts';
import type { X3dMatrix, X3dom, X3dViewpoint } from './x3dom-types.ts';

/** How an x3dom scene is looked at: through the author's viewpoint, or else through its own. */
export class SceneCamera {
  readonly #own: X3dViewpoint;

  /** @param author - gives the author's viewpoint, null where there is none */
  constructor(readonly x3dom: X3dom, readonly started: StartedCanvas, readonly author: () => X3dViewpoint | null) {
    this.#own = started.document._scene.getViewpoint();
  }

  /** Look through a camera. */
  set(camera: Camera): void {
    const viewpoint = this.author() ?? this.#own;
    if (viewpoint === this.#own && viewpoint._vf.fieldOfView !== camera.fieldOfView) {
      viewpoint._vf.fieldOfView = camera.fieldOfView;
      viewpoint.fieldChanged('fieldOfView');
    }
    viewpoint.setView(new this.x3dom.fields.SFMatrix4f(...viewMatrix(camera)));
  }

  /** Size of the picture in device pixels. */
  resize(width: number, height: number): void {
    const { canvas } = this.started.canvas;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    this.#shape({ width, height });
  }

  /** The view that the next picture will have. */
  view(): View {
    const runtime = this.started.element.runtime!;
    this.forgetProjection();
    return { view: toRowMajor(runtime.viewMatrix()), projection: toRowMajor(runtime.projectionMatrix()) };
  }

  /** x3dom overlooks a new aspect ratio when the clipping planes changed in the same frame. */
  forgetProjection(): void {
    this.started.document._scene.getViewpoint()._projMatrix = null;
  }

  /** The view of a picture of a size: rays follow its shape, which rounding makes another one than the canvas's. */
  viewAt(picture: Size): View {
    return this.at(picture, () => this.view());
  }

  /** Do something as if the canvas had another size. */
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
    m._00, m._01, m._02, m._03,
    m._10, m._11, m._12, m._13,
    m._20, m._21, m._22, m._23,
    m._30, m._31, m._32, m._33,
  ];
}
