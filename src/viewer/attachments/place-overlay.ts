import { VolumeViewError } from '../../core/errors.ts';
import { toOverlay } from '../../optics/attachments/overlay.ts';
import { longestDiagonal } from '../../volume/grid.ts';
import type { CartesianGrid } from '../../volume/grid.ts';
import { transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { isPlaced } from './place-labels.ts';
import { checkSameGates } from '../loading/same-gates.ts';

/** The maximum ratio of size of two volumes of the same body. Metres are a thousand millimetres. */
const sizes = 100;

/**
 * A layer's volume at its place: one without a place gets the grid of the volume below it.
 * @param url - of the file, for messages
 * @throws {VolumeViewError} `format/unsupported` where their relative position is not known, or they do not overlap
 */
export function placeOverlay(volume: Volume, over: Volume, url: string): Volume {
  const name = url.slice(0, 200);
  const refuse = (problem: string, advice: string): VolumeViewError =>
    new VolumeViewError('format/unsupported', `the layer ${name} ${problem}; expected ${advice}.`);
  if (isPolar(over) && isPolar(volume)) {
    checkSameGates(over, volume);
    return volume;
  }
  if (isPolar(over))
    throw refuse(
      'is over a radar scan',
      'another moment of the same scan, or a volume of voxels under it, such as a CT or MRI',
    );
  if (isPolar(volume)) throw refuse('is a radar scan', 'a volume of voxels, such as a PET or a map of statistics');
  const { grid } = over;
  const layer = volume.grid as CartesianGrid;
  if (![over, volume].every((one) => isPlaced({ ...one, grid: one.grid as CartesianGrid }))) {
    const [whole, other] = [over.reduced?.from ?? grid.dimensions, volume.reduced?.from ?? layer.dimensions];
    if (String(whole) !== String(other)) {
      throw refuse(
        `is on a grid of ${other.join(' x ')} voxels and the volume on one of ${whole.join(' x ')}, and an image does not say where it lies`,
        'the same grid, or files with a place, such as NIfTI',
      );
    }
    const matrix = grid.indexToWorld;
    return String(layer.dimensions) === String(grid.dimensions)
      ? { ...volume, grid: { ...layer, indexToWorld: matrix, spacing: grid.spacing } }
      : volume;
  }
  const [here, there] = [longestDiagonal(grid), longestDiagonal(layer)];
  if (Math.max(here / there, there / here) > sizes) {
    throw refuse(`is ${rounded(there)} across and the volume ${rounded(here)}`, 'files in the same unit of length');
  }
  if (!meet(grid, layer))
    throw refuse('and the volume have no place in common', 'files of the same body in the same coordinates');
  return volume;
}

const rounded = (length: number): string => String(Number(length.toPrecision(3)));

/** Whether two boxes overlap, judged along the axes of both. */
function meet(a: Volume['grid'], b: Volume['grid']): boolean {
  return [
    [a, b],
    [b, a],
  ].every(([from, to]) => {
    const matrix = toOverlay(from, to);
    if (!matrix) return false;
    const places = [0, 1, 2, 3, 4, 5, 6, 7].map((corner) =>
      transformPoint(matrix, [corner & 1, (corner >> 1) & 1, corner >> 2] as Vector3),
    );
    return [0, 1, 2].every(
      (axis) =>
        Math.max(...places.map((place) => place[axis])) > 0 && Math.min(...places.map((place) => place[axis])) < 1,
    );
  });
}
