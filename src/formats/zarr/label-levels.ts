// Which level of a pyramid of labels is read, and what is said of it. Labels have no means.
import { VolumeViewError } from '../../core/errors.ts';
import { coarseEnough, detailOf } from './choose-level.ts';
import type { LevelBox } from './choose-level.ts';
import type { OmeAxes } from './ome-axes.ts';
import type { OmeImage } from './open-image.ts';

/** Labels with voxels that are longer by this factor than those of the volume look coarse in it. */
const muchCoarser = 1.5;

/** The levels that labels may be read of. Values of an image that is not said to have labels may be means in all but the finest one. */
export function labelLevels(
  boxes: readonly LevelBox[],
  detail: number,
  { axes, labels }: OmeImage,
): readonly LevelBox[] {
  return labels ? coarseEnough(boxes, detail, axes) : boxes.slice(0, 1);
}

export function nothingThere(): VolumeViewError {
  return new VolumeViewError(
    'format/unsupported',
    'the labels and the volume have no place in common; expected files of the same body in the same coordinates',
  );
}

export function tooManyLabels(format: string, { dimensions }: LevelBox): VolumeViewError {
  return new VolumeViewError(
    'format/too-large',
    `the ${format} has ${dimensions.join(' x ')} voxels; expected at most 1 GiB of labels, or a pyramid whose metadata have "image-label", of which a coarser level can be read`,
  );
}

/** What is said of labels that look coarse in their volume; undefined where they do not. */
export function sayCoarse(chosen: LevelBox, finest: LevelBox, detail: number, axes: OmeAxes): string | undefined {
  if (!(detailOf(chosen, axes) > muchCoarser * detail)) return undefined;
  return `the labels are those of ${chosen.dimensions.join(' x ')} larger voxels, instead of ${finest.dimensions.join(' x ')}: the finer levels have more than 1 GiB, and small labels may be missing`;
}
