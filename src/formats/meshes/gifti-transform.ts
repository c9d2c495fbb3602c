import { transformPoint } from '../../volume/matrix.ts';
import type { GiftiArray } from './gifti-array.ts';
import { corrupt } from './mesh-limits.ts';

/** NIfTI's spaces that are world coordinates, best first: in these, a surface lies where the volume does. */
const worlds = ['NIFTI_XFORM_SCANNER_ANAT', 'NIFTI_XFORM_ALIGNED_ANAT', 'NIFTI_XFORM_TALAIRACH', 'NIFTI_XFORM_MNI_152'];

/**
 * The transform from the positions of a GIfTI file to the world, millimetres to the right, front and head. Most files
 * have world coordinates already, and name their space. FreeSurfer's files use FreeSurfer's own space, which GIfTI
 * calls unknown, and contain the transform to the world.
 * @returns null if they are in world coordinates already
 */
export function giftiTransform({
  transforms,
}: GiftiArray): ((places: Float64Array) => Float32Array<ArrayBuffer>) | null {
  const from = transforms.map((one) => one.get('DataSpace')?.trim() ?? '');
  if (from.some((space) => worlds.includes(space))) return null;
  const to = (world: string): Map<string, string> | undefined =>
    transforms.find((one) => one.get('TransformedSpace')?.trim() === world);
  const chosen = worlds.map(to).find(Boolean);
  if (!chosen) return null;
  const matrix = (chosen.get('MatrixData') ?? '').trim().split(/\s+/).map(Number);
  if (matrix.length !== 16 || !matrix.every(Number.isFinite))
    throw corrupt('GIfTI file', 'has a transform that is no matrix of 16 numbers');
  return (places) => {
    const moved = new Float32Array(places.length);
    for (let i = 0; i < places.length; i += 3)
      moved.set(transformPoint(matrix, [places[i], places[i + 1], places[i + 2]]), i);
    return moved;
  };
}
