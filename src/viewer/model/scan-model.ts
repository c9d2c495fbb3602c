import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { boundingSphere } from '../../volume/grid.ts';
import { length, subtract } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';

/** A volume without the parts that take much memory. It may already have its transfer function. */
export type ScanModel = Omit<Volume, 'samples' | 'macrocells' | 'indexed' | 'transferFunction'> & {
  readonly transferFunction?: string | TransferFunction;
};

/** A volume that is at least this many times larger, or smaller, gets a new camera and new colours. */
const maxGrowth = 2;

/**
 * The volume that determines camera, window and reference length. Of several scans it is the first one, so that nothing jumps from
 * one scan to the next, as long as they are of one kind and size.
 */
export function followModel(model: ScanModel | null, volume: Volume): ScanModel {
  if (model && isAlike(model, volume)) return model;
  const { samples: _samples, macrocells: _macrocells, indexed: _indexed, ...rest } = volume;
  return rest;
}

function isAlike(model: ScanModel, volume: ScanModel): boolean {
  const [before, now] = [boundingSphere(model.grid), boundingSphere(volume.grid)];
  const growth = now.radius / before.radius;
  return (
    model.unit === volume.unit &&
    growth <= maxGrowth &&
    growth >= 1 / maxGrowth &&
    length(subtract(now.center, before.center)) <= before.radius
  );
}
