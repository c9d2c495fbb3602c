import type { Camera, Orbit } from '../../optics/rays/camera.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { PaneLabels } from '../../panes/pane-labels.ts';
import type { SlicePane } from '../../panes/slice-pane.ts';
import type { ShownSurface } from '../../renderer/layers/shown-surfaces.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import type { WorldCut } from '../../volume/world-cut.ts';
import type { NoticePlace } from './file-notices.ts';
import type { ClipShape } from './clip-source.ts';
import type { ErrorState } from './error-state.ts';
import type { LabelTarget } from './label-target.ts';
import type { Scene, View } from './scene.ts';
import type { ScansOfView } from './scans-of-view.ts';
import type { Settings } from './settings.ts';
import type { ViewLabels } from './view-labels.ts';
import type { ViewOverlay } from './view-overlay.ts';
import type { VolumeOptics } from './volume-info.ts';

/**
 * Something that joins a view: a surface, a clip, labels, a companion in the page. Only the key is required. The socket reads
 * these members whenever it needs them; `update` reports that one of them has a new value.
 */
export interface ViewPart {
  /** The kind of the part; for an element, its tag. */
  readonly key: string;
  /** The element that owns the part. */
  readonly element?: HTMLElement;

  // Members for the scene.

  /**
   * Put the part into a scene: called for each scene that the view gets, before its first picture, and after `update`. If it
   * rejects, the scene, or `update`, fails.
   */
  apply?(scene: Scene): Promise<void> | void;
  /** Remove the part from the scene that is in use, or is being built. At that time the part has already left the socket. */
  remove?(scene: Scene): Promise<void> | void;
  /** The labels that are shown on the volume; if several parts have labels, the view uses those of the last. */
  readonly labels?: ViewLabels | null;
  /** The second field over the volume; if several parts have one, the view uses that of the last. */
  readonly overlay?: ViewOverlay | null;
  /** An opaque surface, which picks can hit. */
  readonly surface?: ShownSurface | null;
  /** World places that must be in the picture when the camera frames the volume. */
  bounds?(): readonly Vector3[];
  /** Whether the camera frames the part even if it comes after the first picture. */
  readonly isExpected?: boolean;
  /** What the part cuts away from the volume; null for nothing. @throws {VolumeViewError} `attribute/invalid` */
  clip?(): ClipShape | null;
  /** Called when the cuts of the volume may have changed. */
  cutsChanged?(): void;

  // Members over the picture, and in panes.

  /** Move what the part shows over the picture to its place: called after each picture, and after `update`. @param view - of the picture */
  place?(view: View): void;
  /** What the part shows over the grey values of a pane of the volume; null for nothing. @param opacity - 0..1 */
  inPane?(volume: Volume | null, opacity: number): PaneLabels | null;
  /** Move what the part shows over a pane of the view to its place: called after each picture of the pane. @param picture - its element */
  placeInPane?(picture: HTMLElement, pane: SlicePane): void;
  /** The pane belongs to this view no longer. */
  leavePane?(picture: HTMLElement): void;
  /** Draw the pane again. */
  readonly redraw?: () => void;
  /** The place of the view's `cursor`; null where the part does not know it. */
  readonly cursor?: Vector3 | null;

  // Members for companions and for the view itself.

  /** Turns the camera without interaction. The view calls `follow` when attributes, or the viewer, may have changed. */
  readonly rotation?: { readonly stopped: boolean; toggle(): void; follow(): void };
  /** Show or hide one label. Other hidden labels stay hidden. */
  showLabel?(id: number, isShown: boolean): void;
  /** The target for labels that are children of a pane. */
  readonly labelTarget?: LabelTarget;
  /** The substitute for an attribute of the view that its author has not written, by the name of its property. */
  attribute?(property: string): string | null | undefined;
}

/** What parts and companions can use of a view; the view's presenter implements it. */
export interface SocketView extends NoticePlace {
  /** The `<volume-view>`. */
  readonly host: HTMLElement & { readonly fetch?: typeof globalThis.fetch | null };
  /** The last good volume; null before there is one. */
  readonly volume: Volume | null;
  /** The session of the view, for what companions do with several scans. */
  readonly user: NoticePlace['user'] & { readonly loader?: { readonly scans: ScansOfView | null } };
  readonly settings: Settings;
  /** Whether a volume is loading, or would load if there were one: the picture is near enough to be visible soon. */
  readonly awake: boolean;
  readonly errors: Pick<ErrorState, 'report' | 'clear'>;
  /** Its appearance. */
  readonly look: {
    /** null before there is a volume. */
    readonly current: VolumeOptics | null;
    /** The transfer function of a volume that is labels, where its page gives none. `readAgain` applies it. */
    replacement: { readonly transferFunction: TransferFunction } | null;
    readAgain(): void;
    /** A part has joined or left. */
    attachmentsChanged(): void;
  };
  /** Draws the pictures of the view; null while the view is in no page. */
  readonly viewer: SocketViewer | null;
  /** Add work that scripts wait for when they wait for the picture. It does not reject. */
  track(work: Promise<unknown>): void;
  /** Read again which cuts the volume has. */
  cutAgain(): void;
  /** Show another volume in place of the last one, and notify the page. @throws {VolumeViewError} */
  replace(volume: Volume): Promise<void>;
}

/** A place of the camera: its orbit around a target. */
export interface SocketPose extends Orbit {
  /** World coordinates. */
  readonly target: Vector3;
  /** Vertical, radians. */
  readonly fieldOfView: number;
}

/** The camera of a view. */
export interface SocketRig {
  /** The place to which it is going. */
  readonly goal: SocketPose;
  cameraAt(pose: SocketPose): Camera;
  /** Go to a side of the world, by the shorter way, radians. */
  turnTo(theta: number, phi: number): void;
  /** Go to a place, as far as its limits allow. @param touched - whether a person moved it there */
  aim(goal: SocketPose, touched: boolean): void;
}

export interface SocketViewer {
  /** The volume in the pictures. */
  readonly volume: Volume | null;
  /** The part of the volume that is shown, and its cuts; to be read only where there is a volume. */
  readonly shown: {
    readonly grid: GridFrame;
    readonly cuts: {
      readonly region: GridFrame | null;
      readonly away?: WorldCut;
      readonly cuts: readonly { readonly items: readonly unknown[] }[];
    };
  };
  /** The scene in use; null while there is none. */
  readonly scene: Scene | null;
  /** Where the camera is going. */
  readonly rig: SocketRig;
  /** Draw soon. */
  invalidate(): void;
  /** When frames are drawn. */
  readonly loop: {
    /** Whether something has changed since the last picture was started, and the picture in progress. */
    readonly dirty: boolean;
    readonly drawing: Promise<void> | null;
    /** Draw the same view again, as finely as before. */
    request(): void;
    /** Resolves after the next frame. */
    change(): Promise<void>;
  };
  /** Holds its scene. `withScene` does some work with it: the scene stays until the work ends. */
  readonly controller: { withScene<T>(work: (scene: Scene) => Promise<T>): Promise<T> };
  /** Whether there is a picture; the volume in it. */
  readonly drawn: Volume | null;
  /** Frame the subject again, if nobody has moved the camera. */
  reframe(): void;
}

/**
 * Where parts join one view. The socket belongs to the element and exists as long as the element: the element may not be defined
 * yet, and its view, scene and volume come and go.
 */
export class ViewSocket {
  /** null before the element is defined. */
  view: SocketView | null = null;
  #parts: readonly ViewPart[] = [];
  /** Number of the present state of the parts; it counts their changes. */
  #version = 0;
  readonly #versions = new Map<ViewPart, number>();
  /** For each scene: its parts, and the version of each. */
  readonly #applied = new WeakMap<Scene, Map<ViewPart, number>>();

  /** In the order in which they joined. */
  get parts(): readonly ViewPart[] {
    return this.#parts;
  }

  /** Counts the changes of parts: a scene that is being built compares it, to know whether it has all parts. */
  get version(): number {
    return this.#version;
  }

  /** The last good volume; null before there is one. */
  get volume(): Volume | null {
    return this.view?.volume ?? null;
  }

  /** The value of this member in the last part that has one; null where no part has one. */
  last<Name extends keyof ViewPart>(name: Name): NonNullable<ViewPart[Name]> | null {
    return (
      this.#parts
        .map((part) => part[name])
        .filter((value) => value !== undefined && value !== null)
        .at(-1) ?? null
    );
  }

  /**
   * Let a part join.
   * @param isFirst - whether the part comes before all others; the others may then make room for it, or cover it
   * @returns resolves when the next picture shows it; rejects with what its `apply` throws
   */
  join(part: ViewPart, isFirst = false): Promise<void> {
    this.#parts = isFirst ? [part, ...this.#parts] : [...this.#parts, part];
    this.view?.look.attachmentsChanged();
    return this.#change(part);
  }

  /** Apply the changes of a part that has joined. @returns and @throws as `join` */
  async update(part: ViewPart): Promise<void> {
    if (this.#versions.has(part)) await this.#change(part);
  }

  /** Remove a part, if it has joined. @returns resolves when the next picture no longer shows it */
  async leave(part: ViewPart): Promise<void> {
    if (!this.#versions.delete(part)) return;
    this.#parts = this.#parts.filter((one) => one !== part);
    this.#version++;
    this.view?.look.attachmentsChanged();
    await this.#show(part, (scene) => this.#remove(part, scene));
  }

  /** Apply to a scene all parts that it does not have yet. A scene that is being built calls it. */
  async applyTo(scene: Scene): Promise<void> {
    for (const part of this.#applied.get(scene)?.keys() ?? [])
      if (!this.#versions.has(part)) await this.#remove(part, scene);
    for (const part of this.#parts) await this.#apply(part, scene);
  }

  #change(part: ViewPart): Promise<void> {
    this.#versions.set(part, ++this.#version);
    const scene = this.view?.viewer?.scene;
    if (scene && part.place) part.place(scene.getView());
    return this.#show(part, (scene) => this.#apply(part, scene));
  }

  /** Called when a picture has been drawn: each part moves what it shows over the picture. */
  place(view: View): void {
    for (const part of this.#parts) {
      try {
        part.place?.(view);
      } catch (error) {
        console.error(error); // The other parts still get their turn, and so does the next picture.
      }
    }
  }

  async #show(part: ViewPart, change: (scene: Scene) => Promise<void> | void): Promise<void> {
    const { view } = this;
    if (part.clip) view?.cutAgain();
    const { viewer } = view ?? {};
    if (!viewer) return;
    if (!part.apply && !part.remove && !part.bounds) return;
    // A scene that is being built applies the part itself. It comes into use when all callbacks that are ready now have run.
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

/**
 * The symbol is in the global registry: a page may have several copies of the script, and a companion may come from another copy
 * than its view.
 */
const key = Symbol.for('volume-view.socket');

/** The socket of a view, or of an element that may become one: the element may not be defined yet. */
export function socketOf(element: Element & { [key]?: ViewSocket }): ViewSocket {
  return (element[key] ??= new ViewSocket());
}

/**
 * The substitute for an attribute that an author has not written, for instance from an X3D scene among the children. null for
 * none.
 * @param property - name of the attribute's property
 */
export function standIn(view: Element, property: string): string | null {
  return (
    socketOf(view)
      .parts.map((part) => part.attribute?.(property) ?? null)
      .find((text) => text !== null) ?? null
  );
}
