/** Frames whose waits are remembered: pages change. */
const kept = 8;

/**
 * What a frame usually takes. The clock of one frame says little about it: the page collects garbage, the machine has
 * other work, and the page learns some milliseconds late that the GPU has finished.
 */
export class SteadyTime {
  /** What the last frames took besides the GPU's time, ms. */
  #waits: number[] = [];

  /**
   * @param ms - of one frame, from the call to the GPU being seen to have finished
   * @param gpuMs - the GPU's share of it; null if not known
   * @returns the GPU's time and what frames take besides, the median of the last eight; never more than the clock's
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
