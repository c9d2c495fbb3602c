import { VolumeViewError } from '../../core/errors.ts';
import { axialIndexToWorld, cartesianGrid, corners } from '../../volume/grid.ts';
import type { CartesianGrid } from '../../volume/grid.ts';
import type { LabelMap } from '../../volume/labels.ts';
import { invertAffine, multiply, scaleAndTranslate } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { reduceLabels } from '../../volume/reduce-labels.ts';
import { resampleLabels } from '../../volume/resample-labels.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { inPieces } from '../../core/in-pieces.ts';
import type { LabelFile, LabelPart } from '../loading/label-files.ts';

/**
 * The labels of a file on a volume's grid.
 * @param url - of the file, for messages
 * @throws {VolumeViewError} `format/unsupported` where their relative position is not known, or they do not overlap; the signal's
 * reason
 */
export async function placeLabels(
  file: LabelFile,
  volume: Volume,
  url: string,
  signal: AbortSignal,
): Promise<LabelMap> {
  const name = url.slice(0, 200);
  refuseRadar(volume);
  const grid = volume.grid as CartesianGrid;
  const whole = wholeGrid(grid, volume.reduced);
  const unknown = [
    { ...volume, grid: whole },
    { ...file, grid: file.voxels.grid },
  ].some((one) => !isPlaced(one));
  if (unknown && String(whole.dimensions) !== String(file.voxels.grid.dimensions)) {
    throw new VolumeViewError(
      'format/unsupported',
      `the labels of ${name} are on a grid of ${file.voxels.grid.dimensions.join(' x ')} voxels and the volume on one of ${whole.dimensions.join(' x ')}, and an image does not say where it lies; expected the same grid, or files with a place, such as NIfTI.`,
    );
  }
  const voxels = unknown ? { ...file.voxels, grid: whole } : file.voxels;
  // On the grid of a volume that was made smaller, each box gets its most frequent label; from any other grid, the label at its
  // centre.
  const goal = isSameGrid(voxels.grid, whole) ? whole : grid;
  const resampled = await inPieces(resampleLabels(voxels, file.found, goal), () => !signal.aborted);
  signal.throwIfAborted();
  const { map, within } = resampled!;
  if (within > 0) return goal === grid || !volume.reduced ? map : reduceLabels(map, grid.dimensions);
  throw new VolumeViewError(
    'format/unsupported',
    `the labels of ${name} and the volume have no place in common; expected files of the same body in the same coordinates.`,
  );
}

/** @throws {VolumeViewError} `format/unsupported` */
export function refuseRadar(volume: Volume): void {
  if (isPolar(volume))
    throw new VolumeViewError(
      'format/unsupported',
      "<volume-labels> got a radar scan; expected a volume of voxels, such as a CT or MRI. A radar's gates have no labels.",
    );
}

/** The volume's grid before it was made smaller for the device. */
function wholeGrid({ dimensions, indexToWorld }: CartesianGrid, reduced: Volume['reduced']): CartesianGrid {
  const from = reduced?.from ?? dimensions;
  const scale = from.map((n, axis) => n / dimensions[axis]) as unknown as Vector3;
  const larger = invertAffine(scaleAndTranslate(scale, scale.map((s) => (s - 1) / 2) as unknown as Vector3))!;
  return cartesianGrid(from, reduced ? multiply(indexToWorld, larger) : indexToWorld);
}

function isSameGrid(a: CartesianGrid, b: CartesianGrid): boolean {
  const near = 1e-3 * Math.min(...a.spacing);
  return (
    String(a.dimensions) === String(b.dimensions) &&
    a.indexToWorld.every(
      (entry, i) => Math.abs(entry - b.indexToWorld[i]) * (i % 4 < 3 ? a.dimensions[i % 4] : 1) < near,
    )
  );
}

/** Whether a file has a place: that of a patient, or of its format. An image has none, but its manifest may give one. */
export function isPlaced({
  format,
  anatomical,
  grid: { dimensions, spacing, indexToWorld },
}: Pick<Volume, 'format' | 'anatomical'> & { readonly grid: CartesianGrid }): boolean {
  if (anatomical || /^(nifti|nrrd|metaimage)/i.test(format)) return true;
  const usual = axialIndexToWorld(dimensions, spacing);
  return indexToWorld.some((entry, i) => Math.abs(entry - usual[i]) > 1e-6 * Math.max(...spacing));
}

/** What of a pyramid is read for a volume: where the volume is, as finely as the volume is; undefined for one without a place. */
export function labelPartOf(volume: Volume): LabelPart | undefined {
  if (isPolar(volume)) return undefined;
  const grid = volume.grid as CartesianGrid;
  const all = corners(grid);
  const ends = [Math.min, Math.max].flatMap((end) => [0, 1, 2].map((axis) => end(...all.map((one) => one[axis]))));
  return isPlaced({ ...volume, grid }) ? { region: ends, labelDetail: Math.min(...grid.spacing) } : undefined;
}
