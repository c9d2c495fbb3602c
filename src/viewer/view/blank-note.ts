// A text over a picture at rest that shows nothing: loaded with the first picture that may show nothing.
import type { Pixels } from '../../optics/rays/between-pixels.ts';
import { english } from '../../messages/english-blank.ts';
import { LocaleController } from '../../messages/locale-controller.ts';
import { findBlankCause } from '../frames/blank-cause.ts';
import type { BlankCause } from '../frames/blank-cause.ts';
import type * as ViewQuality from '../frames/view-quality.ts';
import type { RenderStats } from '../model/render-stats.ts';
import type { Scene } from '../model/scene.ts';
import type { Viewer } from './viewer.ts';
import type { VolumePresenter } from './volume-presenter.ts';
import { applySheet } from '../overlays/apply-sheet.ts';

/** Detail of `picture-blank`. */
export interface BlankPicture {
  /**
   * Why nothing is visible: no voxel has a value (`noData`), the transfer function is `transparent` everywhere, or for all
   * `values`; all `labels` are hidden, everything is `cut` away, the volume is out of `sight`, or what the picture shows is too
   * `faint`. For a radar scan: there are `noEchoes`, or only `weakEchoes`; both pictures are right.
   */
  readonly cause: BlankCause['cause'];
  /** The text over the picture. */
  readonly message: string;
}

/** An element whose pictures may show nothing. */
export interface NotedView extends HTMLElement {
  readonly renderStats: RenderStats | null;
  readonly paused: boolean;
  whenRendered(): Promise<void>;
  /** Register an object that is called after each update of the element. */
  addController(controller: { hostUpdated(): void }): void;
}

const styles = `
.blank {
  position: absolute;
  inset: 0;
  display: grid;
  place-content: safe center center;
  justify-items: center;
  padding: 8px;
  box-sizing: border-box;
  overflow: clip;
  pointer-events: none;
  text-align: center;
  text-wrap: balance;
}
.blank > p {
  margin: 0;
  padding: 0.5em 0.9em;
  max-inline-size: 34em;
  border-radius: 8px;
  overflow-wrap: anywhere;
  font-size: 13px;
  background: var(--volume-view-blank-background, rgb(13 16 22 / 0.86));
  color: var(--volume-view-blank-color, #cdd6e4);
}
.blank:empty { display: none; }
@media (forced-colors: active) {
  .blank > p {
    border: 1px solid CanvasText;
    background: Canvas;
    color: CanvasText;
  }
}
@media print {
  .blank { display: none; }
}`;

const noted = new WeakSet<NotedView>();

/** From now on an element shows a note where its pictures at rest show nothing. */
export async function noteBlank(view: NotedView, presenter: VolumePresenter): Promise<void> {
  if (noted.has(view)) return;
  noted.add(view);
  const note = new BlankNote(view, presenter, await import('../frames/view-quality.ts')); // Each picture at rest has it.
  view.addController({ hostUpdated: () => note.follow() });
  note.follow();
}

/** Whether the picture is at rest, and there is no other message about it. While scans play, pictures may be empty. */
function isFinal({ renderStats, paused }: NotedView, { viewer, errors }: VolumePresenter): boolean {
  return viewer !== null && paused && renderStats?.converged === true && !viewer.loop.unfinished && !errors.first;
}

/** The largest opacity in the present picture, 0..1: of the volume and of everything around it. */
function largestAlpha({ data }: Pixels): number {
  let largest = 0;
  for (let i = 3; i < data.length; i += 4) if (data[i] > largest) largest = data[i];
  return largest / 255;
}

class BlankNote {
  readonly #locale: LocaleController<typeof english>;
  #element: HTMLElement | null = null;
  #cause: BlankCause | null = null;
  /** The last frame that was checked. */
  #judged: RenderStats | null = null;
  #pending: RenderStats | null = null;

  constructor(
    readonly view: NotedView,
    readonly presenter: VolumePresenter,
    readonly quality: typeof ViewQuality,
  ) {
    this.#locale = new LocaleController(view as unknown as ConstructorParameters<typeof LocaleController>[0], english);
  }

  follow(): void {
    const {
      view,
      view: { renderStats },
    } = this;
    if (this.#judged !== renderStats || !isFinal(view, this.presenter)) {
      this.#judged = null;
      if (this.#cause && !this.#isStillBlank()) this.#say(null);
      if (renderStats?.converged && !renderStats.error?.rays && this.#pending !== renderStats)
        void this.#judge(renderStats);
    } else if (this.#cause) this.#write(); // The language may have changed.
  }

  /** Whether the picture is still blank: in motion, before it is final, it may already show something. */
  #isStillBlank(): boolean {
    const {
      view: { paused },
      presenter: { viewer, errors },
    } = this;
    const scene = viewer?.scene;
    return (
      scene !== null &&
      scene !== undefined &&
      paused &&
      !errors.first &&
      largestAlpha(scene.readPicture()) <= this.quality.faint
    );
  }

  async #judge(stats: RenderStats): Promise<void> {
    const { view, presenter } = this;
    this.#pending = stats;
    // Surfaces, labels and shapes that are still loading will show something soon.
    await view.whenRendered().catch(() => {});
    if (this.#pending === stats) this.#pending = null;
    const { viewer } = presenter;
    const isCurrent = (): boolean =>
      view.renderStats === stats && presenter.viewer === viewer && isFinal(view, presenter);
    const scene = viewer?.scene;
    if (!viewer || !scene || !isCurrent()) return;
    const alpha = largestAlpha(scene.readPicture());
    const cause = alpha <= this.quality.faint ? await this.#findCause(viewer, scene, alpha) : null;
    if (!isCurrent()) return;
    this.#judged = stats;
    this.#say(cause);
  }

  async #findCause(viewer: Viewer, scene: Scene, alpha: number): Promise<BlankCause | null> {
    const { seenPixels } = this.quality;
    const { shown, frames } = viewer;
    const { volume, optics, cuts, labels } = shown;
    if (!volume || !optics) return null;
    const seen = scene.whatIsSeen();
    const inSight = seen?.cells.includes(1) ? seenPixels(scene, frames.sizeIn(scene)) !== null : null;
    // In a volume of labels, the drawn values and their range are indices in the list of ids.
    return findBlankCause({ volume, optics, cuts, labels, inSight, isMoved: viewer.leftAttributes, alpha });
  }

  #say(cause: BlankCause | null): void {
    const before = this.#cause;
    this.#cause = cause;
    if (!cause) this.#element?.replaceChildren();
    else this.#write();
    if (JSON.stringify(cause) === JSON.stringify(before)) return; // Another frame with the same message.
    const detail: BlankPicture | null = cause && { cause: cause.cause, message: this.#describe(cause) };
    this.view.dispatchEvent(new CustomEvent('picture-blank', { detail }));
  }

  /** Screen readers announce text that is added to an element that already exists. */
  #write(): void {
    const { shadowRoot: root, ownerDocument: document } = this.view;
    if (!root || !this.#cause) return;
    if (!this.#element) {
      applySheet(root, styles);
      this.#element = document.createElement('div');
      this.#element.className = 'blank';
      this.#element.setAttribute('part', 'blank');
      this.#element.setAttribute('role', 'status');
    }
    if (!this.#element.isConnected) root.append(this.#element);
    const text = this.#describe(this.#cause);
    if (this.#element.textContent === text) return;
    const words = document.createElement('p');
    words.textContent = text;
    this.#element.replaceChildren(words);
  }

  #describe(cause: BlankCause): string {
    const { blankPicture, blankCauses } = this.#locale.messages;
    const write = (value: number): string => this.#locale.number(value, { maximumSignificantDigits: 4 });
    const unit = this.presenter.volume?.unit;
    const withUnit = (value: number): string => (unit ? `${write(value)} ${unit}` : write(value));
    if (cause.cause === 'noEchoes') return blankCauses.noEchoes;
    if (cause.cause === 'weakEchoes') return blankCauses.weakEchoes(withUnit(cause.value));
    return `${blankPicture} ${cause.cause === 'values' ? blankCauses.values(write(cause.low), withUnit(cause.high)) : blankCauses[cause.cause]}`;
  }
}
