// Lines that an element beside a view puts into its scene: loaded by the elements that do.
import type { Vector3 } from '../../volume/matrix.ts';
import type { Lines, Scene } from '../model/scene.ts';
import type { Viewer } from '../view/viewer.ts';

/** A view into whose scene lines are put: `render` is fired at it after each frame. */
export interface LinedView extends HTMLElement {
  /** null while it is in no page. */
  readonly _presenter?: { readonly viewer: Viewer | null };
}

/** Red, green and blue, 0..1. */
export type LineColor = readonly [red: number, green: number, blue: number];

/** The lines of one owner in a view's scene, whichever scene that is: contexts come and go. */
export class ViewLines {
  #lines: Lines = [];
  #color: LineColor = [1, 1, 1];
  /** Has the lines, or is about to. */
  #scene: Scene | null = null;
  readonly #abort = new AbortController();

  constructor(readonly view: LinedView) {
    view.addEventListener('render', () => {
      if (this.#present !== this.#scene) this.#bring();
    }, { signal: this.#abort.signal });
  }

  /** Show lines in place of those before. Places are the world's, as it is drawn. */
  show(lines: readonly (readonly Vector3[])[], color: LineColor): void {
    this.#lines = lines;
    this.#color = color;
    this.#bring();
  }

  dispose(): void {
    this.show([], this.#color);
    this.#abort.abort();
  }

  get #present(): Scene | null {
    return this.view._presenter?.viewer?.pictures.parts.keeper.scene ?? null;
  }

  #bring(): void {
    const scene = this.#present;
    // What draws lines is loaded with the first.
    if (!scene || (this.#lines.length === 0 && scene !== this.#scene)) return;
    this.#scene = scene;
    void scene.loadLines().then((lines) => {
      if (this.#scene === scene && this.#present === scene) lines?.show(this.#lines, this, this.#color);
    });
  }
}
