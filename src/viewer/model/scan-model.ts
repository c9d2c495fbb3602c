import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { boundingSphere } from '../../volume/grid.ts';
import { length, subtract } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';

/** A volume but for what takes memory. Its transfer function may be there already. */
export type ScanModel = Omit<Volume, 'samples' | 'macrocells' | 'indexed' | 'transferFunction'> & { readonly transferFunction?: string | TransferFunction };

/** A volume this many times as large, or as small, is framed and coloured anew. */
const maxGrowth = 2;

/**
 * The volume that camera, window and reference length go by: of several scans the first one, so that nothing jumps from one
 * to the next, as long as they are of one kind and size.
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
    growth <= maxGrowth && growth >= 1 / maxGrowth &&
    length(subtract(now.center, before.center)) <= before.radius
  );
}
