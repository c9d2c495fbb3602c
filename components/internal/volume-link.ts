import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { CompanionTerms } from '../../src/messages/terms.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { ViewPart } from '../../src/viewer/model/view-socket.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { openRoots } from './open-roots.ts';
import type { VolumeView } from '../volume-view/volume-view.ts';

/** An element that speaks of a <volume-view>. */
export interface Companion extends ReactiveControllerHost, HTMLElement {
  /** The id of that <volume-view>; null for the nearest one. */
  readonly htmlFor: string | null;
}

/** What a volume tells that most companions show. */
const usualEvents: readonly string[] = ['load', 'optics-change'];

/**
 * Finds a companion's <volume-view> and follows it: in whatever order elements are put into the page, defined, named and
 * taken out.
 *
 * With `for` it is the one of this id, in the companion's own tree, in a tree around it, or in any open shadow root.
 * Without, it is the nearest one: that around the companion, else the first in the smallest element that holds both, else
 * the first in any open shadow root.
 */
export class VolumeLink implements ReactiveController {
  /** By it a view knows its companions. */
  readonly #part: ViewPart;
  #view: VolumeView | null = null;
  #stop: (() => void) | null = null;

  /**
   * @param changed - called when there is another volume, another look, or none any more
   * @param events - of the volume, at which it is called too
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

  /** The last good volume of the view, with its samples; null before there is one. */
  get volume(): Volume | null {
    return this.#view && socketOf(this.#view).volume;
  }

  /** What is lacking to show something, in words; null where all is there. */
  describeLack(terms: CompanionTerms): string | null {
    if (this.#view) return this.#view.optics ? null : terms.noVolume;
    return terms.noView(this.host.htmlFor);
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

  /** Look again: the host has another `for`, or the page has changed. */
  find(): void {
    if (!this.host.isConnected) return;
    const { htmlFor } = this.host;
    const found = htmlFor === null ? findNearest(this.host) : findById(this.host, htmlFor);
    if (found !== this.#view) this.#follow(found);
    else if (!found) this.changed(); // The words name another id.
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

/** The element whose shadow tree a node is the root of. */
function hostOf(node: Node): Element | null {
  return node instanceof ShadowRoot ? node.host : null;
}
