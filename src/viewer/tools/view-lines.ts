// Lines that an element attached to a view puts into its scene: loaded by the elements that have such lines.
import type { Vector3 } from '../../volume/matrix.ts';
import type { Lines, Scene } from '../model/scene.ts';
import type { ViewPart, ViewSocket } from '../model/view-socket.ts';

/** Red, green and blue, 0..1. */
export type LineColor = readonly [red: number, green: number, blue: number];

/** The lines of one owner in the scenes of a view. */
export class ViewLines implements ViewPart {
  readonly key = 'lines';
  #lines: Lines = [];
  #color: LineColor = [1, 1, 1];
  /** Scenes that have, or had, lines. */
  readonly #appliedTo = new WeakSet<Scene>();

  constructor(readonly socket: ViewSocket) {
    void socket.join(this);
  }

  /** Show these lines in place of the previous ones. Places are in the world as it is drawn. */
  show(lines: readonly (readonly Vector3[])[], color: LineColor): void {
    if (JSON.stringify([lines, color]) === JSON.stringify([this.#lines, this.#color])) return;
    this.#lines = lines;
    this.#color = color;
    void this.socket.update(this);
  }

  dispose(): void {
    this.#lines = [];
    void this.socket.leave(this);
  }

  apply(scene: Scene): void {
    // The code that draws lines is loaded with the first lines.
    if (this.#lines.length === 0 && !this.#appliedTo.has(scene)) return;
    this.#appliedTo.add(scene);
    void scene.loadLines().then((lines) => lines?.show(this.#lines, this, this.#color));
  }

  remove(scene: Scene): void {
    this.apply(scene);
  }
}
