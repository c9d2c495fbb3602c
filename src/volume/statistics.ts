/** Statistics of the values of some voxels or gates, in the volume's unit. Fields that need more values are null. */
export interface Statistics {
  /** Number of those that have data. */
  readonly count: number;
  /** Number of those inside without data: they are left out. */
  readonly withoutData: number;
  readonly mean: number | null;
  /** Standard deviation, over count - 1. */
  readonly deviation: number | null;
  /** Standard error of the mean, if the values were independent of each other: deviation / sqrt(count). */
  readonly standardError: number | null;
  /** The smallest value, and the largest. */
  readonly least: number | null;
  readonly largest: number | null;
  /**
   * Number of voxels inside, with or without data, that the surface cuts: a part of them is outside. Null if they were
   * not counted.
   */
  readonly cut: number | null;
}

/** Sums up stored values one by one. */
export class Tally {
  #count = 0;
  #withoutData = 0;
  #cut: number | null = null;
  /** Sums are of differences from the first value: squares of large numbers would lose small differences. */
  #first = 0;
  #sum = 0;
  #squares = 0;
  #min = Infinity;
  #largest = -Infinity;

  /** Adds some samples. It leaves out the one that stands for no data, and those that are not finite. */
  add(samples: ArrayLike<number>, first: number, end: number, noData = NaN): void {
    if (this.#count === 0) this.#first = findFirst(samples, first, end, noData);
    const origin = this.#first;
    let [count, sum, squares, min, largest] = [0, 0, 0, this.#min, this.#largest];
    for (let i = first; i < end; i++) {
      const sample = samples[i];
      if (sample === noData || !Number.isFinite(sample)) continue;
      const apart = sample - origin;
      count++;
      sum += apart;
      squares += apart * apart;
      if (sample < min) min = sample;
      if (sample > largest) largest = sample;
    }
    this.#count += count;
    this.#withoutData += end - first - count;
    this.#sum += sum;
    this.#squares += squares;
    [this.#min, this.#largest] = [min, largest];
  }

  /** Adds to the number of voxels that the surface cuts. */
  addCut(voxels: number): void {
    this.#cut = (this.#cut ?? 0) + voxels;
  }

  /** @param value - of a stored sample: slope * sample + intercept */
  finish({ slope, intercept }: { readonly slope: number; readonly intercept: number }): Statistics {
    const count = this.#count;
    const apart = this.#sum / count;
    const deviation =
      count > 1 ? Math.abs(slope) * Math.sqrt(Math.max(0, this.#squares - count * apart * apart) / (count - 1)) : null;
    const ends = [this.#min, this.#largest].map((sample) => slope * sample + intercept);
    return {
      count,
      withoutData: this.#withoutData,
      mean: count > 0 ? slope * (this.#first + apart) + intercept : null,
      deviation,
      standardError: deviation === null ? null : deviation / Math.sqrt(count),
      least: count > 0 ? Math.min(...ends) : null,
      largest: count > 0 ? Math.max(...ends) : null,
      cut: this.#cut,
    };
  }
}

function findFirst(samples: ArrayLike<number>, first: number, end: number, noData: number): number {
  for (let i = first; i < end; i++) if (samples[i] !== noData && Number.isFinite(samples[i])) return samples[i];
  return 0;
}
