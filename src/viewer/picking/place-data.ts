// One voxel of all volumes of a file: where its numbers lie, and what values they stand for.
import type { PlaceData, ScanBytes, ScanNumbers } from '../../formats/base/scan-data.ts';
import { scanTypes } from '../../formats/series/scan-types.ts';
import { cartesianGrid } from '../../volume/grid.ts';
import { scaleAndTranslate } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { valueAt } from './pick-voxel.ts';

/**
 * Where the numbers of one voxel lie. They are read as a volume of as many voxels as there are times, so that each value is made as those
 * of the picture.
 */
export function placeDataOf(data: readonly ScanNumbers[], voxel: Vector3): PlaceData {
  const [{ type, series, littleEndian, slope, intercept }] = data;
  const [nx, ny] = series.grid.dimensions;
  const { bytesPerSample } = scanTypes.get(type)!;
  const start = bytesPerSample * (voxel[0] + nx * (voxel[1] + ny * voxel[2]));
  return {
    from: data.map(({ from }) => cut(from, start, start + bytesPerSample)),
    type,
    littleEndian,
    ...(isScaledAlike(data) ? { slope, intercept } : { slope: 1, intercept: 0 }),
    // Of each place another text: equal requests of two views share their answer.
    format: `voxel ${voxel.join(' ')}`,
    series: {
      grid: cartesianGrid([data.length, 1, 1], scaleAndTranslate([1, 1, 1], [0, 0, 0])),
      anatomical: false,
      unit: '',
      format: series.format,
    },
  };
}

/** The values at all times. @param read - what was read by `placeDataOf` */
export function valuesOfPlace(read: Volume, data: readonly ScanNumbers[]): number[] {
  const isAlike = isScaledAlike(data);
  return data.map(({ slope, intercept }, i) => (isAlike ? valueAt(read, i) : slope * valueAt(read, i) + intercept));
}

/** Files may scale each volume by itself: then the numbers are read as they are. */
const isScaledAlike = ([first, ...others]: readonly ScanNumbers[]): boolean =>
  others.every(({ slope, intercept }) => slope === first.slope && intercept === first.intercept);

function cut(from: ScanBytes, start: number, end: number): ScanBytes {
  return from instanceof Blob
    ? from.slice(start, end)
    : { url: from.url, start: from.start + start, end: from.start + end };
}
