import { finestSpacing } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { brighten } from '../transfer/brighten.ts';
import type { OpticalFactors, TransferFunction } from '../transfer/transfer-function.ts';
import { prepareOptics, transferFunctionClassify } from './ray-classify.ts';
import type { RayOptics } from './ray-classify.ts';
import type { ClassifyStage, FieldStage } from './ray-stages.ts';

/** A picture's transfer function and optical settings. */
interface PictureOptics extends OpticalFactors {
  readonly transferFunction: TransferFunction;
  /** World length to which a stop's opacity belongs. */
  readonly referenceLength: number;
}

/** The last optics of each transfer function: it takes longer to prepare them than to cast a ray. */
const kept = new WeakMap<
  TransferFunction,
  { readonly lightFactor: number; readonly voxelRatio: number; readonly optics: RayOptics }
>();

function prepare(transferFunction: TransferFunction, lightFactor: number, voxelRatio: number): RayOptics {
  const last = kept.get(transferFunction);
  if (last?.lightFactor === lightFactor && last.voxelRatio === voxelRatio) return last.optics;
  const optics = prepareOptics(brighten(transferFunction, lightFactor), voxelRatio);
  kept.set(transferFunction, { lightFactor, voxelRatio, optics });
  return optics;
}

/**
 * The classification of values in a picture by its transfer function.
 * @param diameter - of the rays: world length of one unit of a segment's span
 */
export function classifyPicture(
  { transferFunction, lightFactor, opacityFactor, referenceLength }: PictureOptics,
  grid: GridFrame,
  diameter: number,
  field: FieldStage,
): ClassifyStage {
  const optics = prepare(transferFunction, lightFactor, (finestSpacing(grid) / referenceLength) * opacityFactor);
  return transferFunctionClassify(optics, field, (diameter * opacityFactor) / referenceLength);
}
