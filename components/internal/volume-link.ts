import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { CompanionMessages } from '../../src/messages/messages.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { ViewPart } from '../../src/viewer/model/view-socket.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { openRoots } from './open-roots.ts';
import type { VolumeView } from '../volume-view/volume-view.ts';

/** An element that shows something about a <volume-view>. */
export interface Companion extends ReactiveControllerHost, HTMLElement {
  /** The id of that <volume-view>; null for the nearest one. */
  readonly htmlFor: string | null;
}

/** The events of a view after which most companions update. */
const usualEvents: readonly string[] = ['load', 'optics-change'];

/**
 * Finds the <volume-view> of a companion and follows it. It works in whatever order the elements are inserted, defined, named and removed.
 *
 * With `for` it is the view with this id: in the companion's own tree, in a tree around it, or in any open shadow root. Without `for`, it
 * is the nearest view: the one around the companion, else the first one in the smallest element that contains both, else the first one in
 * any open shadow root.
 */
export class VolumeLink implements ReactiveController {
  /** The part through which a view knows its companion. */
  readonly #part: ViewPart;
  #view: VolumeView | null = null;
  #stop: (() => void) | null = null;

  /**
   * @param changed - called when there is another volume, another appearance, or no volume any longer
   * @param events - events of the view after which `changed` is called too
   */
  constructor(
    readonly host: Companion,
    readonly changed: () => void,
    readonly events = usualEvents,
  ) {
    this.#part = { key: host.localName, element: host };
    host.addController(this);
  }

  get view(): VolumeView | null {
    return this.#view;
  }

  /** The last volume of the view that loaded without error, with its samples; null before there is one. */
  get volume(): Volume | null {
    return this.#view && socketOf(this.#view).volume;
  }

  /** A sentence that says what is missing before something can be shown; null where nothing is missing. */
  describeLack(messages: CompanionMessages): string | null {
    if (this.#view) return this.#view.optics ? null : messages.noVolume;
    return messages.noView(this.host.htmlFor);
  }

  hostConnected(): void {
    this.#stop = openRoots.listen({ changed: () => this.find() });
    openRoots.notice(this.host);
    this.find();
  }

  hostDisconnected(): void {
    this.#stop?.();
    this.#stop = null;
    this.#follow(null);
  }

  /** Search again: the host has another `for`, or the page has changed. */
  find(): void {
    if (!this.host.isConnected) return;
    const { htmlFor } = this.host;
    const found = htmlFor === null ? findNearest(this.host) : findById(this.host, htmlFor);
    if (found !== this.#view) this.#follow(found);
    else if (!found) this.changed(); // The message names another id.
  }

  #follow(view: VolumeView | null): void {
    for (const type of this.events) this.#view?.removeEventListener(type, this.changed);
    if (this.#view) void socketOf(this.#view).leave(this.#part);
    this.#view = view;
    if (view) void socketOf(view).join(this.#part);
    for (const type of this.events) view?.addEventListener(type, this.changed);
    this.changed();
    if (view?.matches(':not(:defined)')) void customElements.whenDefined('volume-view').then(() => this.changed());
  }
}

function findById(start: Element, id: string): VolumeView | null {
  for (let root: Node | null = start.getRootNode(); root; root = hostOf(root)?.getRootNode() ?? null) {
    const found = (root as Document | ShadowRoot).getElementById(id);
    if (found) return found.localName === 'volume-view' ? (found as VolumeView) : null;
  }
  return openRoots.find((root) => root.querySelector<VolumeView>(`volume-view#${CSS.escape(id)}`));
}

function findNearest(start: Element): VolumeView | null {
  const around = start.closest('volume-view');
  if (around) return around;
  for (let node: Node | null = start.parentNode; node; node = node.parentNode ?? hostOf(node)) {
    const found = (node as ParentNode).querySelector('volume-view');
    if (found) return found;
  }
  return openRoots.find((root) => root.querySelector('volume-view'));
}

/** The element whose shadow root a node is; null for any other node. */
function hostOf(node: Node): Element | null {
  return node instanceof ShadowRoot ? node.host : null;
}
