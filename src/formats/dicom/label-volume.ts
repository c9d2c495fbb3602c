// What segmentations and structure sets become: a volume of labels.
import { cartesianGrid } from '../../volume/grid.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import type { Budget } from '../base/budget.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { LabelPainter } from '../base/label-painter.ts';
import { numberTypes } from '../base/number-types.ts';

type Painter = LabelPainter<Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>>;

/**
 * An empty grid of labels.
 * @param largest - of all ids
 * @throws {VolumeViewError} `format/too-large`
 */
export function startLabels(dimensions: Vector3, largest: number, budget: Budget, what: string): Painter {
  const type = largest < 256 ? 'uint8' : 'uint16';
  budget.take(countSampleBytes(what, dimensions, numberTypes[type]), what);
  const voxels = dimensions[0] * dimensions[1] * dimensions[2];
  return new LabelPainter(type === 'uint8' ? new Uint8Array(voxels) : new Uint16Array(voxels));
}

/** @param left - what of the file is not shown, in words */
export function labelVolume(
  { dimensions, indexToWorld }: { readonly dimensions: Vector3; readonly indexToWorld: Matrix4 },
  { samples }: Painter,
  { format, named, left }: Pick<DecodedCartesianVolume, 'format' | 'named'> & { readonly left: readonly string[] },
): DecodedCartesianVolume {
  return {
    grid: cartesianGrid(dimensions, indexToWorld),
    anatomical: true,
    samples,
    slope: 1,
    intercept: 0,
    unit: '',
    format,
    isLabels: true,
    named,
    ...(left.length > 0 ? { left } : {}),
  };
}
