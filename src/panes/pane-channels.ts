import { planesOf } from '../volume/channels.ts';
import { invertAffine } from '../volume/matrix.ts';
import type { Volume } from '../volume/volume.ts';
import type { PaneLabels } from './pane-labels.ts';
import { linearSampler } from './sample-at.ts';
import { visitPixels } from './visit-pixels.ts';

/**
 * The light of a volume's channels in place of its greys: each gives its colour times the share of its window. Lights add, up to white. Null
 * for other volumes, and if the grid is singular.
 */
export function paneChannels({ grid, channels }: Volume): PaneLabels | null {
  const worldToIndex = channels && invertAffine(grid.indexToWorld);
  if (!worldToIndex) return null;
  const [red, green, blue] = planesOf(channels).map((samples) =>
    linearSampler({ samples, dimensions: grid.dimensions, hasNoData: false }),
  );
  const scale = 255 / channels.full;
  return {
    paint(pixels, picture, rows) {
      visitPixels(pixels, worldToIndex, rows, (at, x, y, z) => {
        if (picture[at + 3] === 0) return;
        picture[at] = scale * red(x, y, z);
        picture[at + 1] = scale * green(x, y, z);
        picture[at + 2] = scale * blue(x, y, z);
      });
    },
    nameAt: () => null,
  };
}
