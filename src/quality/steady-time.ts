/** Number of frames whose waits are kept: older ones do not count, because pages change. */
const kept = 8;

/**
 * The usual time of a frame. The clock time of one frame says little about it: the page collects garbage, the machine has
 * other work, and the page gets the notice that the GPU has finished some milliseconds late.
 */
export class SteadyTime {
  /** The time of the last frames in addition to the GPU's time, ms. */
  #waits: number[] = [];

  /**
   * @param ms - of one frame, from the call until the page sees that the GPU has finished
   * @param gpuMs - the GPU's share of it; null if it is not known
   * @returns the GPU's time, plus the median of the last eight frames' additional time; at most the clock time
   */
  of(ms: number, gpuMs: number | null): number {
    if (gpuMs === null) return ms;
    this.#waits = [...this.#waits, Math.max(0, ms - gpuMs)].slice(-kept);
    return Math.min(ms, gpuMs + median(this.#waits));
  }
}

function median(values: readonly number[]): number {
  const sorted = [...values];
  sorted.sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
