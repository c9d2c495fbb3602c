import type { CartesianGrid } from '../../volume/grid.ts';
import type { SeriesInfo } from '../base/scan-data.ts';
import type { Frame } from './frame.ts';
import type { ChosenFrames } from './group-frames.ts';
import { modalityOf } from './modality.ts';
import { tags } from './tags.ts';
import type { FileWindows } from './windows.ts';

/** What files say of their numbers, and where these lie. */
export function describeFiles({ frames, left }: ChosenFrames, anatomical: boolean, grid: CartesianGrid): SeriesInfo {
  const [{ unit, picture }] = frames;
  const isBurnedIn = frames.some((frame) => frame.picture.set.text(tags.burnedIn).toUpperCase() === 'YES');
  const { windows, left: ofWindows } = findWindows(frames);
  const all = [
    ...(isBurnedIn
      ? [
          'WARNING: the file says that words are written into its pixels (BurnedInAnnotation), which may be a name: look before you show it to others',
        ]
      : []),
    ...left,
    ...ofWindows,
  ];
  const modality = modalityOf(picture.set);
  return {
    grid,
    anatomical,
    unit,
    format: ['DICOM', modality].filter(Boolean).join(', '),
    ...(all.length > 0 ? { left: all } : {}),
    ...(windows.length > 0 ? { window: [windows[0].from, windows[0].to], windows } : {}),
    isUptake: modality === 'PT',
  };
}

/** Those of the middle frame, or of the first one that has some. */
function findWindows(frames: readonly Frame[]): FileWindows {
  for (const frame of [frames[frames.length >> 1], ...frames]) {
    const found = frame.windows();
    if (found.windows.length > 0) return found;
  }
  return { windows: [], left: [] };
}
