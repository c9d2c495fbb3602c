// In which macrocells patches of values and gradients may be visible.
import { isPolar } from '../../volume/volume.ts';
import type { VolumeData } from '../../volume/volume.ts';
import type { Contribution } from './empty-space-distance.ts';
import { normalsToWorld } from '../rays/gradient.ts';
import { perWorldUnit } from '../rays/patch-classify.ts';
import { minGradient, spanOfPatch } from '../transfer/patches.ts';
import type { Patch } from '../transfer/patches.ts';

/** Allowance for rounding in shaders. */
const slack = 1.001;

/**
 * The largest gradient that each macrocell may have, in data units per world unit. Taps of central differences lie in the cell or a
 * neighbouring one, and two values of these differ by at most their range. If one tap stands for two, as next to places without data, the
 * full difference counts.
 */
export function boundGradients({
  macrocells: {
    dimensions: [nx, ny, nz],
    low,
    high,
  },
  slope,
  grid: coarse,
  finer,
  hasNoData,
}: VolumeData): Float32Array {
  const grid = finer?.finest ?? coarse;
  const m = normalsToWorld(grid);
  const axes = [0, 1, 2].map((axis) => [m[axis], m[4 + axis], m[8 + axis]]);
  // An upper bound of the length of the image of any change of at most 1 along each axis: all products of the axes are summed; for a
  // rectangular grid, those of two different axes are 0.
  const longest = Math.sqrt(
    axes.reduce((sum, a) => axes.reduce((s, b) => s + Math.abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]), sum), 0),
  );
  const perRange = slack * longest * perWorldUnit(grid) * Math.abs(slope) * (hasNoData ? 1 : 0.5);
  const bounds = new Float32Array(low.length);
  for (let k = 0, cell = 0; k < nz; k++)
    for (let j = 0; j < ny; j++)
      for (let i = 0; i < nx; i++, cell++) {
        let [min, max] = [low[cell], high[cell]];
        const include = (isThere: boolean, other: number): void => {
          if (!isThere || !(low[other] <= high[other])) return;
          min = Math.min(min, low[other]);
          max = Math.max(max, high[other]);
        };
        include(i > 0, cell - 1);
        include(i < nx - 1, cell + 1);
        include(j > 0, cell - nx);
        include(j < ny - 1, cell + nx);
        include(k > 0, cell - nx * ny);
        include(k < nz - 1, cell + nx * ny);
        bounds[cell] = min <= max ? perRange * (max - min) : 0;
      }
  return bounds;
}

/** Which cells may have gradients that patches make visible. A radar's gradients may have any size, so all its cells count. */
export function contributionOfGradients(patches: readonly Patch[], volume: VolumeData): Contribution {
  if (isPolar(volume)) return () => true;
  const bounds = boundGradients(volume);
  const parts = patches.map((patch) => ({ span: spanOfPatch(patch), min: minGradient(patch) }));
  return (low, high, cell) => parts.some(({ span, min }) => low <= span[1] && high >= span[0] && bounds[cell] >= min);
}
