import { VolumeViewError } from '../../core/errors.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { maxVoxelsPerAxis } from '../../volume/grid-limits.ts';

/**
 * @param what - what has the dimensions, for messages
 * @throws {VolumeViewError} `format/too-large`
 */
export function checkDimensions(what: string, dimensions: Vector3): void {
  if (dimensions.every((n) => n <= maxVoxelsPerAxis)) return;
  throw new VolumeViewError(
    'format/too-large',
    `${what} got ${dimensions.join(' x ')} voxels; expected at most ${maxVoxelsPerAxis.toLocaleString('en')} along each axis; check how its data are laid out`,
  );
}
