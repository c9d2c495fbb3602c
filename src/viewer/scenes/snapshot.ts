/** The last picture of a viewer that has given its WebGL context back: it replaces the canvas, at the same size. */
export class Snapshot {
  #canvas: HTMLCanvasElement | null = null;

  /** @param container - contains the picture */
  constructor(readonly container: Element) {}

  /** Keep what a canvas shows. */
  keep(picture: HTMLCanvasElement): void {
    this.remove();
    const canvas = document.createElement('canvas');
    canvas.width = picture.width;
    canvas.height = picture.height;
    canvas.ariaHidden = 'true';
    canvas.getContext('2d')?.drawImage(picture, 0, 0);
    this.container.prepend(canvas);
    this.#canvas = canvas;
  }

  remove(): void {
    this.#canvas?.remove();
    this.#canvas = null;
  }
}
