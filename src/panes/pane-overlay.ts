import { evaluate, largestOpacity } from '../optics/transfer-function.ts';
import type { ShownOverlay } from '../optics/overlay.ts';
import { invertAffine, transformDirection, transformPoint } from '../volume/matrix.ts';
import type { PaneLabels } from './pane-labels.ts';
import { linearSampler } from './sample-at.ts';

/** Colours of values that are told apart, from the first to the last stop. */
const tableSize = 4096;

/** A second field over greys, in its colours: its largest opacity covers them, as in a legend. Null where its grid is singular. */
export function paneOverlay({ volume, transferFunction }: Pick<ShownOverlay, 'volume' | 'transferFunction'>): PaneLabels | null {
  const { grid, slope, intercept } = volume;
  const worldToIndex = invertAffine(grid.indexToWorld);
  if (!worldToIndex) return null;
  const sampleAt = linearSampler({ ...volume, dimensions: grid.dimensions });
  const [low, high] = [transferFunction[0].value, transferFunction.at(-1)!.value];
  const largest = largestOpacity(transferFunction);
  // Premultiplied, by the middle of each step: a jump lies between two of them.
  const colors = Array.from({ length: tableSize + 2 }, (_, step) =>
    evaluate(transferFunction, step === 0 ? -Infinity : step > tableSize ? Infinity : low + ((step - 0.5) / tableSize) * (high - low)).map((x, c) => (c < 3 ? 255 * x : x) / largest));
  return {
    paint(pixels, picture, [begin, end]) {
      const [ax, ay, az] = transformDirection(worldToIndex, pixels.across);
      const [dx, dy, dz] = transformDirection(worldToIndex, pixels.down);
      const [x0, y0, z0] = transformPoint(worldToIndex, pixels.first);
      for (let row = begin; row < end; row++) {
        for (let column = 0, at = 4 * row * pixels.width; column < pixels.width; column++, at += 4) {
          const value = slope * sampleAt(x0 + row * dx + column * ax, y0 + row * dy + column * ay, z0 + row * dz + column * az) + intercept;
          if (Number.isNaN(value) || picture[at + 3] === 0) continue;
          const [red, green, blue, share] = colors[Math.min(tableSize + 1, Math.max(0, value < low ? 0 : 1 + Math.floor(((value - low) / (high - low || 1)) * tableSize)))];
          if (share === 0) continue;
          picture[at] += red - share * picture[at];
          picture[at + 1] += green - share * picture[at + 1];
          picture[at + 2] += blue - share * picture[at + 2];
        }
      }
    },
    nameAt: () => null,
  };
}
