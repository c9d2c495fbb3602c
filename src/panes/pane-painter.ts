import { fillRows } from './fill-slice.ts';
import type { SliceField, SlicePixels, Slab } from './fill-slice.ts';
import type { Painter } from './paint-slice.ts';
import type { PaneLabels } from './pane-labels.ts';

/** A picture to paint. */
export interface PaneJob {
  /** Size in pixels of the canvas. A picture of fewer pixels stands in while the full one takes long. */
  readonly columns: number;
  readonly rows: number;
  readonly pixelsOf: (columns: number, rows: number) => SlicePixels;
  readonly field: SliceField;
  readonly slab: Slab;
  /** Approximate number of samples for each pixel. */
  readonly samples: number;
  readonly painter: Painter;
  /** Labels that cover it; null for none. */
  readonly labels: PaneLabels | null;
}

/** Milliseconds of a frame that painting may take. */
const budget = 12;

/**
 * The number of samples that take about that long on a slow phone. Only pictures that are certainly quick are painted
 * at once.
 */
const quickSamples = 2 ** 19;

/** Paints slices into a canvas: at once, or first a coarse picture and then the full one piece by piece between frames. */
export class PanePainter {
  #canvas: HTMLCanvasElement | null = null;
  #running = 0;
  #frame = 0;
  #done: Promise<void> = Promise.resolve();
  #settle: () => void = () => {};

  get canvas(): HTMLCanvasElement | null {
    return this.#canvas;
  }

  set canvas(canvas: HTMLCanvasElement | null) {
    this.#canvas = canvas;
  }

  /** Resolves when the last job has been painted, or cancelled. */
  get done(): Promise<void> {
    return this.#done;
  }

  /** Begins a job and cancels the one before. */
  paint(job: PaneJob): void {
    this.stop();
    const { columns, rows, slab } = job;
    const context = this.#canvas?.getContext('2d');
    if (!context || columns < 1 || rows < 1) return;
    const samples = columns * rows * job.samples;
    if (samples <= quickSamples) {
      const picture = new PanePicture(job, columns, rows);
      picture.fill(Infinity);
      return picture.put(context);
    }
    // Fewer pixels and fewer planes; for a slab of the largest value, planes matter more than pixels.
    const less = samples / quickSamples;
    const planes = Math.max(1, Math.round(job.samples / Math.min(4, Math.sqrt(less))));
    const shrink = Math.sqrt(Math.max(1, (columns * rows * planes) / quickSamples));
    const coarse = new PanePicture(
      { ...job, slab: { ...slab, planes } },
      Math.ceil(columns / shrink),
      Math.ceil(rows / shrink),
    );
    coarse.fill(Infinity);
    coarse.put(context);
    this.#done = new Promise((resolve) => (this.#settle = resolve));
    const run = ++this.#running;
    const picture = new PanePicture(job, columns, rows);
    const go = (): void => {
      if (run !== this.#running) return;
      if (picture.fill(budget)) {
        picture.put(context);
        this.#settle();
      } else this.#frame = requestAnimationFrame(go);
    };
    this.#frame = requestAnimationFrame(go);
  }

  stop(): void {
    this.#running++;
    cancelAnimationFrame(this.#frame);
    this.#settle();
  }
}

/** One picture of a job, row by row. */
class PanePicture {
  readonly #values: Float64Array;
  readonly #pixels: SlicePixels;
  readonly #image: ImageData;
  #row = 0;

  constructor(
    readonly job: PaneJob,
    readonly columns: number,
    readonly rows: number,
  ) {
    this.#values = new Float64Array(columns * rows);
    this.#pixels = job.pixelsOf(columns, rows);
    this.#image = new ImageData(columns, rows);
  }

  /** Fills more rows. @param milliseconds - approximate time to use @returns whether all are filled */
  fill(milliseconds: number): boolean {
    const { field, slab, painter, labels } = this.job;
    const end = performance.now() + milliseconds;
    while (this.#row < this.rows && performance.now() < end) {
      const rows = [this.#row, Math.min(this.rows, this.#row + 4)] as const;
      fillRows({ field, pixels: this.#pixels, slab }, this.#values, rows);
      painter(this.#values, this.#image.data, [rows[0] * this.columns, rows[1] * this.columns]);
      labels?.paint(this.#pixels, this.#image.data, rows);
      this.#row = rows[1];
    }
    return this.#row >= this.rows;
  }

  /** Draws it on the canvas, scaled to the canvas' size. */
  put(context: CanvasRenderingContext2D): void {
    const { canvas } = context;
    const { columns, rows } = this.job;
    if (canvas.width !== columns || canvas.height !== rows) [canvas.width, canvas.height] = [columns, rows];
    if (this.columns === columns && this.rows === rows) return context.putImageData(this.#image, 0, 0);
    const small = document.createElement('canvas');
    [small.width, small.height] = [this.columns, this.rows];
    small.getContext('2d')?.putImageData(this.#image, 0, 0);
    context.clearRect(0, 0, columns, rows);
    context.drawImage(small, 0, 0, columns, rows);
  }
}
