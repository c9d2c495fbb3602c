// Draws small pictures of the data with given attributes, one after another, in a view that nobody sees.
import { asFiles } from '../data/prepare.ts';
import type { LessonData } from '../data/prepare.ts';
import type { ViewAttributes } from '../model/lesson.ts';
import { applyView } from './view-element.ts';
import type { View } from './view-element.ts';

/** CSS pixels; the pictures have twice as many. */
const [width, height] = [144, 108];

/** A picture that was asked for: an address once it is drawn, null while it is not, 'none' where the view refuses the attributes. */
export type Drawn = string | null;

export class Painter {
  readonly #drawn = new Map<string, string>();
  readonly #wanted = new Map<string, ViewAttributes>();
  #data: LessonData | null = null;
  #view: View | null = null;
  #isDrawing = false;

  /** @param changed - a picture is there */
  constructor(readonly changed: () => void) {}

  /** Pictures are of these data from now on. */
  follow(data: LessonData | null): void {
    if (this.#data === data) return;
    this.#data = data;
    for (const address of this.#drawn.values()) if (address !== 'none') URL.revokeObjectURL(address);
    this.#drawn.clear();
    this.#wanted.clear();
    this.#view?.remove();
    this.#view = null;
  }

  /** What is known of a picture; if it is not drawn yet, it will be. @param first - before those that wait already */
  draw(attributes: ViewAttributes, first = false): Drawn {
    const key = JSON.stringify(sortEntries(attributes));
    const known = this.#drawn.get(key);
    if (known !== undefined) return known;
    if (!this.#wanted.has(key)) {
      const others = first ? [...this.#wanted] : [];
      if (first) this.#wanted.clear();
      this.#wanted.set(key, attributes);
      for (const [name, one] of others) this.#wanted.set(name, one);
    }
    void this.#drawAll();
    return null;
  }

  /** Whether some are not drawn yet. */
  get isBusy(): boolean {
    return this.#wanted.size > 0;
  }

  async #drawAll(): Promise<void> {
    if (this.#isDrawing) return;
    this.#isDrawing = true;
    // Not while the page is drawn that asked for them.
    await new Promise((resolve) => setTimeout(resolve));
    for (let next = this.#next(); next; next = this.#next()) {
      const [key, attributes, data] = next;
      const address = await this.#drawOne(attributes, data);
      if (this.#data !== data) continue;
      this.#wanted.delete(key);
      this.#drawn.set(key, address);
      this.changed();
    }
    this.#isDrawing = false;
  }

  #next(): readonly [string, ViewAttributes, LessonData] | null {
    const [first] = this.#wanted;
    return first && this.#data ? [...first, this.#data] : null;
  }

  async #drawOne(attributes: ViewAttributes, data: LessonData): Promise<string> {
    const view = (this.#view ??= makeView(data));
    applyView(view, attributes, true);
    try {
      view.jumpCameraToGoal();
      await view.whenRendered();
      return URL.createObjectURL(await view.toBlob({ type: 'image/webp', width: 2 * width, height: 2 * height }));
    } catch {
      return 'none';
    }
  }
}

function sortEntries(attributes: ViewAttributes): [string, string][] {
  const entries = Object.entries(attributes);
  entries.sort(([a], [b]) => (a < b ? -1 : 1));
  return entries;
}

/** CSS pixels of a poster: as wide as most frames. */
const posterSize = { width: 800, height: 600 } as const;

/** The first picture of a lesson, as good as the view draws it. @returns null where the view refuses the attributes */
export async function drawPoster(attributes: ViewAttributes, data: LessonData): Promise<Blob | null> {
  const view = makeView(data);
  view.removeAttribute('steps');
  view.style.cssText = `inline-size:${posterSize.width}px;block-size:${posterSize.height}px`;
  applyView(view, attributes, true);
  try {
    view.jumpCameraToGoal();
    await view.whenRendered();
    return await view.toBlob({ type: 'image/webp', ...posterSize });
  } catch {
    return null;
  } finally {
    view.remove();
  }
}

function makeView(data: LessonData): View {
  const view = document.createElement('volume-view');
  view.className = 'painter';
  view.setAttribute('aria-hidden', 'true');
  view.setAttribute('interaction', 'none');
  view.setAttribute('interpolation-decay', '0');
  // Small pictures need few steps, and no measure of their error.
  view.setAttribute('steps', '96');
  view.setAttribute('alt', '');
  view.style.cssText = `inline-size:${width}px;block-size:${height}px`;
  view.inert = true;
  view.append(document.createElement('volume-slice'));
  view.files = asFiles(data);
  document.body.append(view);
  return view;
}
