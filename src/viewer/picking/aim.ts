// A person shows a place in the picture of a view, by a click or a tap, or with a crosshair that keys move: loaded by what asks for places.
import { socketOf } from '../model/view-socket.ts';
import type { ViewPart } from '../model/view-socket.ts';
import type { VolumePosition } from '../model/volume-pick.ts';
import { middleInPage } from '../../page/pointer-place.ts';
import { applySheet } from '../overlays/apply-sheet.ts';
import { clicksOn } from './pick-clicks.ts';
import type { PickedView } from './pick-clicks.ts';

/** A view in which places are shown. */
export interface AimedView extends PickedView {
  positionFromPoint(clientX: number, clientY: number): Promise<VolumePosition | null>;
}

/** Who wants to know a place. */
export interface AimOwner {
  readonly element: HTMLElement;
  /** Whether it waits for a place now. */
  readonly isWaiting: boolean;
  /** Name of the crosshair, and what the keys do. */
  readonly crosshair: string;
  readonly crosshairKeys: string;
  /** What is under the crosshair, in words. @param across - share of the width of the picture; `down` alike */
  describe(found: VolumePosition | null, across: number, down: number): string;
  /** A person shows a place. @param found - null where nothing is seen */
  take(found: VolumePosition | null): void;
  /** The crosshair is gone. @param byKey - a person has ended it by a key, and the focus goes back */
  ended(byKey: boolean): void;
}

/** Steps of the crosshair, CSS pixels: as those of handles. */
const [keyStep, shiftStep] = [4, 40];

const arrows: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** What is under a crosshair that has not moved for this time is said, ms. */
const restMs = 300;

const styles = `
.aim {
  position: absolute;
  inset: 0;
  overflow: clip;
  pointer-events: none;
}
.aim [role='application'] {
  position: absolute;
  translate: -50% -50%;
  inline-size: 33px;
  block-size: 33px;
  border-radius: 50%;
  filter: drop-shadow(0 0 1px #000) drop-shadow(0 0 1px #000);
}
.aim [role='application']::before, .aim [role='application']::after {
  content: '';
  position: absolute;
  inset: 0 15.5px;
  background: linear-gradient(#fff 36%, transparent 36% 64%, #fff 64%);
}
.aim [role='application']::after {
  rotate: 90deg;
}
.aim [role='application']:focus-visible {
  outline: 3px solid var(--volume-view-focus-color, #7db4ff);
}
@media (forced-colors: active) {
  .aim [role='application'] { border: 1px solid CanvasText; }
}
@media print {
  .aim { display: none; }
}`;

/** Over one view's picture. It exists while somebody may ask for places. */
export class Aim implements ViewPart {
  readonly key = 'aim';
  readonly #layer: HTMLElement;
  readonly #status: HTMLElement;
  readonly #abort = new AbortController();
  readonly #release: () => void;
  readonly #owners = new Set<AimOwner>();
  /** Who has the crosshair. */
  #holder: AimOwner | null = null;
  #crosshair: HTMLElement | null = null;
  /** Shares of width and height. */
  #at: readonly [across: number, down: number] = [0.5, 0.5];
  #timer = 0;

  private constructor(
    readonly view: AimedView,
    readonly picture: HTMLElement,
  ) {
    const { ownerDocument: document } = view;
    this.#layer = document.createElement('div');
    this.#layer.className = 'aim';
    this.#status = document.createElement('div');
    this.#status.setAttribute('role', 'status');
    this.#status.className = 'status'; // The class of the view's own messages to screen readers.
    this.#layer.append(this.#status);
    picture.after(this.#layer);
    this.#release = clicksOn(view).take((event) => this.#click(event));
    const { signal } = this.#abort;
    for (const type of ['pointerenter', 'pointerleave'] as const)
      view.addEventListener(
        type,
        ({ pointerType }) => {
          if (pointerType === 'mouse')
            picture.style.cursor = type === 'pointerenter' && this.#findOwner() ? 'crosshair' : '';
        },
        { signal },
      );
    void socketOf(view).join(this);
  }

  /** The one of a view. @param picture - the part of the view that holds its picture */
  static of(view: AimedView, picture: HTMLElement): Aim {
    return socketOf(view).parts.find((part) => part instanceof Aim) ?? new Aim(view, picture);
  }

  add(owner: AimOwner): void {
    this.#owners.add(owner);
  }

  drop(owner: AimOwner): void {
    this.#owners.delete(owner);
    if (this.#holder === owner) this.#end(false);
    if (this.#owners.size > 0) return;
    this.#abort.abort();
    this.#release();
    this.#layer.remove();
    this.picture.style.cursor = '';
    void socketOf(this.view).leave(this);
  }

  /** Show the crosshair, with the focus. */
  begin(owner: AimOwner): void {
    if (this.#holder) this.#end(false);
    applySheet(this.view.shadowRoot!, styles); // Each document needs its own styles.
    this.#holder = owner;
    const crosshair = this.view.ownerDocument.createElement('div');
    crosshair.setAttribute('role', 'application');
    crosshair.setAttribute('part', 'crosshair');
    crosshair.tabIndex = 0;
    crosshair.ariaLabel = owner.crosshair;
    crosshair.ariaDescription = owner.crosshairKeys;
    crosshair.addEventListener('keydown', (event) => this.#onKey(event));
    crosshair.addEventListener('blur', () => this.#end(false));
    this.#layer.prepend(crosshair);
    this.#crosshair = crosshair;
    this.#move([0.5, 0.5]);
    this.view.scrollIntoView({ block: 'nearest' });
    crosshair.focus({ preventScroll: true });
  }

  /** Who gets a click: the one with the crosshair, else the view itself for its author, else the first one of the page that waits. */
  #findOwner(): AimOwner | null {
    const waiting = [...this.#owners].filter(({ isWaiting }) => isWaiting);
    waiting.sort((a, b) => (a.element.compareDocumentPosition(b.element) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1));
    const [first = null] = waiting;
    return this.#holder ?? waiting.find(({ element }) => element === this.view) ?? first;
  }

  #click({ clientX, clientY }: MouseEvent): void {
    const owner = this.#findOwner();
    if (owner) void this.#take(owner, clientX, clientY);
  }

  async #take(owner: AimOwner, clientX: number, clientY: number): Promise<void> {
    const found = await this.#look(clientX, clientY);
    if (found === undefined || !this.#owners.has(owner) || !owner.isWaiting) return;
    owner.take(found);
    if (!owner.isWaiting && this.#holder === owner) this.#end(true);
    else if (this.picture.style.cursor !== '' && !this.#findOwner()) this.picture.style.cursor = '';
  }

  /** @returns undefined where a part of the package could not be loaded */
  async #look(clientX: number, clientY: number): Promise<VolumePosition | null | undefined> {
    try {
      return await this.view.positionFromPoint(clientX, clientY);
    } catch (error) {
      console.warn(error);
      return undefined;
    }
  }

  #onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { key, shiftKey } = event;
    if (Object.hasOwn(arrows, key)) {
      const step = shiftKey ? shiftStep : keyStep;
      const room = [this.view.clientWidth, this.view.clientHeight];
      const [across, down] = this.#at.map((share, axis) =>
        Math.min(1, Math.max(0, share + (arrows[key][axis] * step) / Math.max(1, room[axis]))),
      );
      this.#move([across, down]);
    } else if (key === 'Enter') {
      const { clientX, clientY } = middleInPage(this.#crosshair!);
      void this.#take(this.#holder!, clientX, clientY);
    } else if (key === 'Escape') this.#end(true);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  #move(at: readonly [number, number]): void {
    this.#at = at;
    const { style } = this.#crosshair!;
    [style.left, style.top] = at.map((share) => `${(100 * share).toFixed(3)}%`);
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => void this.#say(), restMs);
  }

  async #say(): Promise<void> {
    const [holder, at] = [this.#holder, this.#at];
    if (!holder) return;
    const { clientX, clientY } = middleInPage(this.#crosshair!);
    const found = await this.#look(clientX, clientY);
    if (found !== undefined && this.#holder === holder && this.#at === at)
      this.#status.textContent = holder.describe(found, ...at);
  }

  #end(byKey: boolean): void {
    const [holder, crosshair] = [this.#holder, this.#crosshair];
    if (!holder) return;
    this.#holder = this.#crosshair = null;
    clearTimeout(this.#timer);
    this.#status.textContent = '';
    crosshair?.remove();
    holder.ended(byKey);
  }
}
