import type { Block } from '../volume/reduce.ts';

/** Differences between what was read and what is written, in data values. */
export interface ValueError {
  readonly max: number;
  readonly rms: number;
}

/** Adds up differences. */
export class ErrorSum {
  #max = 0;
  /** In shares of the largest one: squares of values beyond 1e154 are no numbers. */
  #squares = 0;
  #count = 0;

  add(difference: number): void {
    const size = Math.abs(difference);
    if (size > this.#max) {
      this.#squares *= (this.#max / size) ** 2;
      this.#max = size;
    }
    if (size > 0) this.#squares += (size / this.#max) ** 2;
    this.#count++;
  }

  get error(): ValueError {
    return { max: this.#max, rms: this.#count > 0 ? this.#max * Math.sqrt(this.#squares / this.#count) : 0 };
  }
}

/** The two cells around each place of an axis, and the share of the second. */
function placesAlong(from: number, to: number): { lower: Int32Array; share: Float64Array } {
  const lower = new Int32Array(from);
  const share = new Float64Array(from);
  for (let i = 0; i < from; i++) {
    const place = Math.min(to - 1, Math.max(0, ((i + 0.5) * to) / from - 0.5));
    lower[i] = Math.min(Math.floor(place), Math.max(0, to - 2));
    share[i] = to > 1 ? place - lower[i] : 0;
  }
  return { lower, share };
}

/** The data value of a sample; NaN for no data. */
export type ValueOf = (sample: number) => number;

/**
 * The difference that remains at the voxels of a volume where a smaller one is shown in its place: there a value is interpolated
 * linearly between the voxels of the smaller one, as a ray does it. Places where one of the two has no data are left out.
 * @param everySlice - of the original, so many slices are skipped from one that is measured to the next
 */
export function measureReduction(
  original: Block & { readonly valueOf: ValueOf },
  smaller: Block & { readonly valueOf: ValueOf },
  everySlice = 1,
): ValueError {
  const [nx, ny, nz] = original.dimensions;
  const [mx, my, mz] = smaller.dimensions;
  const [x, y, z] = [placesAlong(nx, mx), placesAlong(ny, my), placesAlong(nz, mz)];
  const [right, down, deep] = [mx > 1 ? 1 : 0, my > 1 ? mx : 0, mz > 1 ? mx * my : 0];
  const values = Float64Array.from(smaller.samples, smaller.valueOf);
  const sum = new ErrorSum();
  for (let k = (everySlice - 1) >> 1; k < nz; k += everySlice) {
    for (let j = 0; j < ny; j++) {
      const [v, w] = [y.share[j], z.share[k]];
      const row = mx * (y.lower[j] + my * z.lower[k]);
      for (let i = 0; i < nx; i++) {
        const at = row + x.lower[i];
        const u = x.share[i];
        const along = (place: number): number => values[place] + u * (values[place + right] - values[place]);
        const near = along(at) + v * (along(at + down) - along(at));
        const far = along(at + deep) + v * (along(at + deep + down) - along(at + deep));
        const difference = near + w * (far - near) - original.valueOf(original.samples[i + nx * (j + ny * k)]);
        if (difference === difference) sum.add(difference);
      }
    }
  }
  return sum.error;
}
