/** The time of drawing: T = a + b w, where w is the number of pixels times the steps along the longest ray. */
export interface TimeModel {
  /** Time in ms that every frame takes, however little is drawn. */
  readonly a: number;
  /** Time in ms for each pixel and step. */
  readonly b: number;
}

/** One drawn frame. */
export interface FrameTime {
  /** Pixels times steps. */
  readonly work: number;
  /** From the call until the GPU has finished. */
  readonly ms: number;
}

/** Number of frames that the model is fitted to: views change, and old frames describe other views. */
const kept = 8;

/** A frame of another size is kept for this many frames: with one size alone, a and b cannot be separated. */
const keptOfOtherSizes = 120;

/** The largest share of a frame's time that may count as independent of what is drawn. */
const maxFixed = 0.8;

/** Sizes count as the same if they differ by at most a factor of about two. */
function sizeOf({ work }: FrameTime): number {
  return Math.round(Math.log2(work));
}

/** Fits the time model while frames are drawn. */
export class FrameTimer {
  #frames: FrameTime[] = [];
  /** The latest frame of each size, and its number. */
  readonly #bySize = new Map<number, { readonly frame: FrameTime; readonly number: number }>();
  #number = 0;

  get model(): TimeModel | null {
    const recent = new Set(this.#frames.map(sizeOf));
    const others = [...this.#bySize].filter(
      ([size, { number }]) => !recent.has(size) && this.#number - number <= keptOfOtherSizes,
    );
    return fitTimes([...others.map(([, { frame }]) => frame), ...this.#frames]);
  }

  add(frame: FrameTime): void {
    if (!(frame.work > 0) || !(frame.ms > 0)) return;
    this.#frames.push(frame);
    if (this.#frames.length > kept) this.#frames.shift();
    this.#bySize.set(sizeOf(frame), { frame, number: ++this.#number });
  }

  /** Call this for another volume or transfer function: old times say nothing about the new one. */
  forget(): void {
    this.#frames = [];
    this.#bySize.clear();
  }
}

/**
 * Fits by least squares of relative errors, so that short frames count as much as long ones.
 * @returns null without frames; if all have one size, the time is assumed to be proportional to the work
 */
export function fitTimes(frames: readonly FrameTime[]): TimeModel | null {
  if (frames.length === 0) return null;
  let [s0, s1, s2, t0, t1] = [0, 0, 0, 0, 0];
  for (const { work, ms } of frames) {
    const weight = 1 / ms ** 2;
    s0 += weight;
    s1 += weight * work;
    s2 += weight * work * work;
    t0 += weight * ms;
    t1 += weight * work * ms;
  }
  const min = Math.min(...frames.map(({ ms }) => ms));
  const determinant = s0 * s2 - s1 * s1;
  const spread = determinant / (s0 * s2);
  const fixed = spread > 1e-3 ? (t0 * s2 - t1 * s1) / determinant : 0;
  const a = Math.min(maxFixed * min, Math.max(0, fixed));
  return { a, b: (t1 - a * s1) / s2 };
}
