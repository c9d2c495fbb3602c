import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { PaneLabels } from '../../panes/pane-labels.ts';
import type { ShownSurface } from '../../renderer/layers/shown-surfaces.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import type { WorldCut } from '../../volume/world-cut.ts';
import type { ToldFile } from './beside-notices.ts';
import type { ClipShape } from './clip-source.ts';
import type { ErrorBoard } from './error-board.ts';
import type { LabelTarget } from './label-target.ts';
import type { Scene, View } from './scene.ts';
import type { Settings } from './settings.ts';
import type { ViewLabels } from './view-labels.ts';
import type { ViewOverlay } from './view-overlay.ts';
import type { VolumeOptics } from './volume-info.ts';

/**
 * Something that joins a view: a surface, a clip, labels, a companion in the page. All but the key is optional. The socket
 * reads these members whenever they matter; `update` says that one of them has another value.
 */
export interface ViewPart {
  /** What kind of part it is; of an element its tag. */
  readonly key: string;
  /** The element that asks for it. */
  readonly element?: HTMLElement;

  // In the scene.

  /** Put it into a scene: called for each scene that the view gets, before its first picture, and after `update`. What rejects fails the scene, or `update`. */
  apply?(scene: Scene): Promise<void> | void;
  /** Take it out of the scene that is in use, or being built. The part has left by then. */
  remove?(scene: Scene): Promise<void> | void;
  /** The labels of the volume that are shown; of several parts the last one's. */
  readonly labels?: ViewLabels | null;
  /** The second field over the volume; of several parts the last one's. */
  readonly overlay?: ViewOverlay | null;
  /** An opaque surface, which picks meet. */
  readonly surface?: ShownSurface | null;
  /** World places that a camera that frames the volume has in its picture. */
  bounds?(): readonly Vector3[];
  /** What it cuts away of the volume; null for nothing. @throws {VolumeViewError} `attribute/invalid` */
  clip?(): ClipShape | null;
  /** What cuts the volume may have changed. */
  cutsChanged?(): void;

  // Over the picture, and in panes.

  /** Bring what it has over the picture to its place: called after each picture, and after `update`. @param view - the picture's */
  place?(view: View): void;
  /** What lies over the greys of a pane of the volume; null for nothing. @param opacity - 0..1 */
  inPane?(volume: Volume | null, opacity: number): PaneLabels | null;
  /** Where the `cursor` of the view is; null where nobody knows. */
  readonly cursor?: Vector3 | null;

  // For companions and the view itself.

  /** Turns the camera without a hand. `follow`: attributes may have changed, or the viewer. */
  readonly rotation?: { readonly stopped: boolean; toggle(): void; follow(): void };
  /** Show or hide one label. What else is hidden stays so. */
  showLabel?(id: number, isShown: boolean): void;
  /** What labels between the tags of a pane are shown on. */
  readonly labelTarget?: LabelTarget;
  /** What stands in for an attribute of the view that its author has not written, by the name of its property. */
  attribute?(property: string): string | null | undefined;
}

/** What parts and companions may ask of a view; the presenter of the view has it. */
export interface SocketView {
  /** The `<volume-view>`. */
  readonly host: HTMLElement;
  /** The last good volume; null before there is one. */
  readonly volume: Volume | null;
  readonly settings: Settings;
  /** Whether a volume is being loaded, or would be: the picture is near enough to be seen soon. */
  readonly awake: boolean;
  readonly errors: Pick<ErrorBoard, 'report' | 'clear'>;
  /** Its appearance. */
  readonly look: {
    /** null before there is a volume. */
    readonly current: VolumeOptics | null;
    /** The transfer function of a volume that is labels, where its page says none. `readAnew` applies it. */
    dress: { readonly transferFunction: TransferFunction } | null;
    readAnew(): void;
  };
  /** Draws its pictures; null while the view is in no page. */
  readonly viewer: SocketViewer | null;
  /** Work that a script that waits for the picture has to wait for. It does not reject. */
  track(work: Promise<unknown>): void;
  /** What of files that a part shows is not in the picture; empty where all is. @param owner - shows them */
  reportFiles(owner: object, files: readonly ToldFile[]): void;
  /** Read again what cuts the volume. */
  cutAnew(): void;
  /** Show another volume in place of the last one, and tell the page of it. @throws {VolumeViewError} */
  replace(volume: Volume): Promise<void>;
}

export interface SocketViewer {
  /** The volume that pictures are of. */
  readonly volume: Volume | null;
  /** The part of it that is shown, and what cuts it; asked for where there is a volume. */
  readonly shown: { readonly grid: GridFrame; readonly cuts: { readonly region: GridFrame | null; readonly away?: WorldCut } };
  /** In use at the moment; null while there is none. */
  readonly scene: Scene | null;
  /** Draw soon. */
  invalidate(): void;
  /** Frame the subject again, where there is no picture yet and nobody has moved the camera. */
  reframe(): void;
}

/**
 * Where parts join one view. It belongs to the element and lasts as long: the element may not be defined yet, and its view,
 * scene and volume come and go.
 */
export class ViewSocket {
  /** null before the element is defined. */
  view: SocketView | null = null;
  #parts: readonly ViewPart[] = [];
  /** Which state of the parts it is; counts their changes. */
  #version = 0;
  readonly #versions = new Map<ViewPart, number>();
  /** Of each scene, which parts it has, in which version. */
  readonly #applied = new WeakMap<Scene, Map<ViewPart, number>>();

  /** In the order in which they joined. */
  get parts(): readonly ViewPart[] {
    return this.#parts;
  }

  /** Counts the changes of parts: a scene that is being built looks whether it has all. */
  get version(): number {
    return this.#version;
  }

  /** The last good volume; null before there is one. */
  get volume(): Volume | null {
    return this.view?.volume ?? null;
  }

  /** What the last part that has such a member has there; null where none has one. */
  last<Name extends keyof ViewPart>(name: Name): NonNullable<ViewPart[Name]> | null {
    return this.#parts.map((part) => part[name]).filter((value) => value !== undefined && value !== null).at(-1) ?? null;
  }

  /**
   * Let a part join.
   * @param isFirst - whether it comes before all others, which may make room for it or cover it
   * @returns resolves when the next picture shows it. What its `apply` throws comes here
   */
  join(part: ViewPart, isFirst = false): Promise<void> {
    this.#parts = isFirst ? [part, ...this.#parts] : [...this.#parts, part];
    return this.#change(part);
  }

  /** A part that has joined has changed. @returns and @throws as `join` */
  async update(part: ViewPart): Promise<void> {
    if (this.#versions.has(part)) await this.#change(part);
  }

  /** A part leaves, if it has joined. @returns resolves when the next picture shows nothing of it */
  async leave(part: ViewPart): Promise<void> {
    if (!this.#versions.delete(part)) return;
    this.#parts = this.#parts.filter((one) => one !== part);
    this.#version++;
    await this.#show(part, (scene) => this.#remove(part, scene));
  }

  /** Put into a scene all that it does not have yet. A scene that is being built asks for it. */
  async applyTo(scene: Scene): Promise<void> {
    for (const part of this.#applied.get(scene)?.keys() ?? []) if (!this.#versions.has(part)) await this.#remove(part, scene);
    for (const part of this.#parts) await this.#apply(part, scene);
  }

  #change(part: ViewPart): Promise<void> {
    this.#versions.set(part, ++this.#version);
    const scene = this.view?.viewer?.scene;
    if (scene && part.place) part.place(scene.getView());
    return this.#show(part, (scene) => this.#apply(part, scene));
  }

  /** A picture has been drawn: what lies over it goes to its place. */
  place(view: View): void {
    for (const part of this.#parts) {
      try {
        part.place?.(view);
      } catch (error) {
        console.error(error); // The others, and the next picture, come all the same.
      }
    }
  }

  async #show(part: ViewPart, change: (scene: Scene) => Promise<void> | void): Promise<void> {
    const { view } = this;
    if (part.clip) view?.cutAnew();
    const { viewer } = view ?? {};
    if (!viewer) return;
    if (part.bounds) viewer.reframe();
    if (!part.apply && !part.remove && !part.bounds) return;
    // A scene that is being built takes it along, and is in use when all that waits for nothing is done.
    if (!viewer.scene) await new Promise((resolve) => setTimeout(resolve));
    if (viewer.scene) await change(viewer.scene);
    viewer.invalidate();
  }

  #apply(part: ViewPart, scene: Scene): Promise<void> | void {
    const applied = this.#applied.get(scene) ?? new Map<ViewPart, number>();
    const version = this.#versions.get(part);
    if (version === undefined || applied.get(part) === version) return;
    this.#applied.set(scene, applied.set(part, version));
    return part.apply?.(scene);
  }

  #remove(part: ViewPart, scene: Scene): Promise<void> | void {
    if (this.#applied.get(scene)?.delete(part)) return part.remove?.(scene);
  }
}

/** The name is registered: a page may have several copies of the script, and one's element a companion of another. */
const key = Symbol.for('volume-view.socket');

/** The socket of a view, or of what may become one: it does not have to be defined. */
export function socketOf(element: Element & { [key]?: ViewSocket }): ViewSocket {
  return (element[key] ??= new ViewSocket());
}

/** What stands in for an attribute that an author has not written: an X3D scene among the children, say. null for nothing. @param property - its name */
export function standIn(view: Element, property: string): string | null {
  return socketOf(view).parts.map((part) => part.attribute?.(property) ?? null).find((text) => text !== null) ?? null;
}
