import type { SceneLights } from '../optics/transfer/lights.ts';
import type { ProgramInputs } from '../renderer/device/inputs.ts';
import { createSceneDepth, depthInputs } from '../renderer/ray/modules/scene-depth.ts';
import type { ShapeDepths, SurfacesModule } from '../renderer/ray/ray-module.ts';
import type { ShownSurface } from '../renderer/layers/shown-surfaces.ts';
import { ShapeEdges } from '../renderer/pictures/shape-edges.ts';
import type { Pass, Size } from '../renderer/passes/pass-drawing.ts';
import { castableRays } from '../renderer/pictures/volume-pictures.ts';
import type { Cast, CastLayer } from '../renderer/pictures/volume-pictures.ts';
import { readAuthorCamera } from './author-camera.ts';
import type { AuthorCamera } from './author-camera.ts';
import { AuthorNodes } from './author-nodes.ts';
import { readLights } from './read-lights.ts';
import { readVolume } from './read-volume.ts';
import { toRowMajor } from './scene-camera.ts';
import type { SceneCamera } from './scene-camera.ts';
import { createDepthTarget, SceneDepth } from './scene-depth.ts';
import type { DrawnShapes } from './scene-depth.ts';
import { SceneLines } from './scene-lines.ts';
import type { SceneSurfaces } from './scene-surfaces.ts';
import type { StartedCanvas } from './start-canvas.ts';
import { isTranslucent, TranslucentShapes } from './translucent-shapes.ts';
import type { VolumeDrawing } from './translucent-shapes.ts';
import type { VolumeShape } from './volume-shape.ts';
import type { RenderShape, X3dDrawable, X3dom } from './x3dom-types.ts';

/**
 * The parts that only scenes with more than a volume need: the author's nodes, lines, surfaces, the depth at which
 * these end rays, and translucent shapes inside the volume.
 */
export class OtherShapes {
  readonly author: AuthorNodes;
  readonly lines: SceneLines;
  readonly #depth: SceneDepth;
  /** Ends rays at that depth. */
  readonly depthModule: SurfacesModule;
  #surfaces: SceneSurfaces | null = null;
  #translucent: TranslucentShapes | null = null;
  #edges: ShapeEdges | null | undefined;
  /** The volume's drawing, if it was drawn before the translucent shapes. */
  #drawn: VolumeDrawing | null = null;
  #isDisposed = false;
  /** The arguments with which x3dom drew the last shape. */
  #rest: unknown[] = [];
  readonly #render: RenderShape;

  /** @param host - the element whose X3D children join the scene */
  constructor(
    readonly x3dom: X3dom,
    readonly started: StartedCanvas,
    readonly host: Element,
  ) {
    const { canvas, document } = started;
    this.author = new AuthorNodes(x3dom, document, host);
    this.lines = new SceneLines(document, (shown, owner) => this.#showSurface(shown, owner));
    this.#depth = new SceneDepth(canvas.gl!);
    this.depthModule = createSceneDepth(canvas.gl!.ctx3d);
    const context = canvas.gl!;
    const renderShape = (this.#render = context.renderShape.bind(context));
    context.renderShape = (drawable, ...rest) => {
      this.#rest = rest;
      const render = (one: X3dDrawable): void => renderShape(one, ...rest);
      if (this.#drawn?.shownCast?.depths && isTranslucent(drawable))
        (this.#translucent ??= new TranslucentShapes(context, this.#drawn.layer)).draw(drawable, this.#drawn, render);
      else render(drawable);
    };
  }

  /** Whether the next picture will probably contain shapes, before x3dom's list is known. */
  get hasAny(): boolean {
    return this.started.element.querySelectorAll('shape').length > 1;
  }

  /** Show a surface of an owner; what draws surfaces is loaded with the first. */
  async #showSurface(shown: ShownSurface | null, owner: object): Promise<void> {
    if (!this.#surfaces && !shown) return;
    const { SceneSurfaces } = await import('./scene-surfaces.ts');
    if (this.#isDisposed) return;
    this.#surfaces ??= new SceneSurfaces(this.x3dom, this.started.document);
    this.#surfaces.show(shown, owner);
  }

  /**
   * Draws the depth of all opaque shapes except the volume's, when x3dom comes to it.
   * @param drawing - the volume's
   * @param draw - lets x3dom draw a shape
   * @param picture - pixels
   * @returns null if there are no other shapes, or the device can't do it
   */
  drawDepths(
    volume: VolumeShape,
    drawing: VolumeDrawing,
    { view, draw }: Pick<DrawnShapes, 'view' | 'draw'>,
    picture: Size = this.started.canvas.canvas,
  ): ShapeDepths | null {
    const { document } = this.started;
    const collection = document._scene.drawableCollection;
    const all = Array.from({ length: collection?.length ?? 0 }, (_, i) => collection!.get(i));
    const others = all.filter(({ shape }) => !volume.owns(shape));
    const isNeeded =
      Boolean(this.started.canvas.gl!.ctx3d.getContextAttributes()?.stencil) && others.some(isTranslucent);
    const depths = this.#depth.draw(picture, {
      shapes: others.filter(({ sortType }) => sortType !== 'transparent'),
      view,
      draw,
      isNeeded,
    });
    this.#drawn = depths && isNeeded ? drawing : null;
    return depths;
  }

  /** The same for a picture of another size, with the camera of the last one, outside of x3dom's own drawing. */
  drawDepthsAt(picture: Size, camera: SceneCamera, volume: VolumeShape, drawing: VolumeDrawing): ShapeDepths | null {
    const {
      canvas,
      document: { _viewarea },
    } = this.started;
    const { ctx3d: gl, stateManager } = canvas.gl!;
    return camera.at(picture, () => {
      const [viewArea, lights, count, viewMatrix, , lightMatrix, , ...rest] = this.#rest;
      const projection = _viewarea.getProjectionMatrix();
      const drawn = [
        viewArea,
        lights,
        count,
        viewMatrix,
        _viewarea.getWCtoCCMatrix(),
        lightMatrix,
        projection,
        ...rest,
      ];
      stateManager.unsetProgram();
      stateManager.enable(gl.DEPTH_TEST);
      try {
        return this.drawDepths(
          volume,
          drawing,
          { view: camera.view(), draw: (shape) => this.#render(shape, ...drawn) },
          picture,
        );
      } finally {
        stateManager.disable(gl.DEPTH_TEST);
        stateManager.unsetProgram();
      }
    });
  }

  /**
   * The passes that draw the other sides of shapes' edges, for a picture that will be shown among the shapes: only a
   * picture at rest has them. The canvas is bound.
   */
  edgePasses(layer: CastLayer, cast: Cast, isAtRest: boolean): Pass[] {
    const edges = this.#edgesOf(cast);
    if (isAtRest && edges && cast.depths!.solidBounds)
      return edges.passes(cast.picture, cast.depths!, depthOf(layer, cast, true));
    edges?.forget();
    return [];
  }

  /** Shows the volume among the shapes whose depth ended its rays. The canvas is bound. */
  showVolume({ pictures, layer, shownCast }: VolumeDrawing): void {
    const { picture } = shownCast!;
    const edges = this.#edgesOf(shownCast!);
    if (edges) edges.show(pictures.gathered!, picture, depthOf(layer, shownCast!));
    else pictures.show(picture);
  }

  /** null if no shape is visible, or their edges are not smooth. */
  #edgesOf({ depths }: Cast): ShapeEdges | null {
    const [left, , right] = depths!.bounds;
    return left < right
      ? (this.#edges ??= ShapeEdges.create(this.started.canvas.gl!.ctx3d, (gl) => createDepthTarget(gl)!))
      : null;
  }

  /** The volume's part of a picture that contains shapes. */
  readonly readVolume = readVolume;

  /** The lights that shine on a volume. */
  lights(): SceneLights {
    return readLights(this.author);
  }

  /** The author's viewpoint as a camera, or null if there is none. */
  get camera(): AuthorCamera | null {
    return readAuthorCamera(this.author, this.started.element);
  }

  /**
   * Draws the scene. If the author's elements make that impossible, they are left out, and the rest is drawn.
   * @throws what drawing throws without any of them
   */
  draw(draw: () => void): void {
    this.#drawn = null;
    if (this.author.isEmpty) return draw();
    let failure: unknown;
    const works = (): boolean => {
      try {
        draw();
        return this.#hasFiniteView();
      } catch (error) {
        failure = error;
        return false;
      }
    };
    if (works()) return;
    const isLost = this.started.canvas.gl!.ctx3d.isContextLost();
    const isDrawn = !isLost && this.author.leaveOutCulprits(works);
    if (!isDrawn && failure) throw failure;
  }

  /** x3dom's view depends on what is in the scene. */
  #hasFiniteView(): boolean {
    const runtime = this.started.element.runtime!;
    return [...toRowMajor(runtime.viewMatrix()), ...toRowMajor(runtime.projectionMatrix())].every(Number.isFinite);
  }

  dispose(): void {
    this.#isDisposed = true;
    this.author.dispose();
    this.#depth.dispose();
    this.depthModule.dispose!();
    this.#translucent?.dispose();
    this.#edges?.dispose();
  }
}

/**
 * The program's input for the depth of the shapes in a picture. @param isCoarse - only for shapes that are neither
 * lines nor points
 */
function depthOf(layer: CastLayer, { view, picture, depths }: Cast, isCoarse = false): ProgramInputs {
  const rays = castableRays(layer, view);
  const lattice = { stride: 1, first: [0, 0], width: picture.width, height: picture.height, isCoarse } as const;
  return depthInputs({ depths: depths!, projection: view.projection, picture, lattice }, [
    rays.planeDepth,
    rays.diameter,
  ]);
}
