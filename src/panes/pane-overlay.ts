import { evaluate, largestOpacity } from '../optics/transfer/transfer-function.ts';
import type { ShownOverlay } from '../optics/attachments/overlay.ts';
import { invertAffine } from '../volume/matrix.ts';
import type { PaneLabels } from './pane-labels.ts';
import { linearSampler } from './sample-at.ts';
import { visitPixels } from './visit-pixels.ts';

/** Number of different colours, from the first to the last stop. */
const tableSize = 4096;

/**
 * A second field over greys, in its colours. It covers them with its maximum opacity, as in a legend. Null if its grid
 * is singular.
 */
export function paneOverlay({
  volume,
  transferFunction,
}: Pick<ShownOverlay, 'volume' | 'transferFunction'>): PaneLabels | null {
  const { grid, slope, intercept } = volume;
  const worldToIndex = invertAffine(grid.indexToWorld);
  if (!worldToIndex) return null;
  const sampleAt = linearSampler({ ...volume, dimensions: grid.dimensions });
  const [low, high] = [transferFunction[0].value, transferFunction.at(-1)!.value];
  const largest = largestOpacity(transferFunction);
  // Premultiplied, from the middle of each step, so that a jump lies between two steps.
  const colors = Array.from({ length: tableSize + 2 }, (_, step) =>
    evaluate(
      transferFunction,
      step === 0 ? -Infinity : step > tableSize ? Infinity : low + ((step - 0.5) / tableSize) * (high - low),
    ).map((x, c) => (c < 3 ? 255 * x : x) / largest),
  );
  return {
    paint(pixels, picture, rows) {
      visitPixels(pixels, worldToIndex, rows, (at, x, y, z) => {
        const value = slope * sampleAt(x, y, z) + intercept;
        if (Number.isNaN(value) || picture[at + 3] === 0) return;
        const [red, green, blue, share] =
          colors[
            Math.min(
              tableSize + 1,
              Math.max(0, value < low ? 0 : 1 + Math.floor(((value - low) / (high - low || 1)) * tableSize)),
            )
          ];
        if (share === 0) return;
        picture[at] += red - share * picture[at];
        picture[at + 1] += green - share * picture[at + 1];
        picture[at + 2] += blue - share * picture[at + 2];
      });
    },
    nameAt: () => null,
  };
}
