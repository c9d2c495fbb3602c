import { cartesianGradient, flatChange } from '../../src/optics/gradient.ts';
import { domainOf } from '../../src/optics/emission.ts';
import { litShade, pointField } from '../../src/optics/lit.ts';
import type { LitScene } from '../../src/optics/lit.ts';
import { cartesianField } from '../../src/optics/ray-field.ts';
import type { ReferenceScene } from '../../src/optics/reference.ts';
import type { TransferFunction } from '../../src/optics/transfer-function.ts';
import { polarBeamField } from '../../src/radar/polar-field.ts';
import { polarGradient } from '../../src/radar/polar-gradient.ts';
import { isPolar } from '../../src/volume/volume.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** What a reference's rays have more where a volume is lit. */
export function litStages(volume: Volume, transferFunction: TransferFunction, more: Partial<LitScene> = {}): Pick<ReferenceScene, 'moreFields' | 'shades'> {
  const gradient = isPolar(volume)
    ? polarGradient(polarBeamField(volume), volume.grid)
    : cartesianGradient(cartesianField({ ...volume, dimensions: volume.grid.dimensions }), volume.grid);
  const flat = flatChange(domainOf(transferFunction), volume.range);
  return { moreFields: [pointField], shades: [litShade({ grid: volume.grid, gradient, flat, ...more })] };
}
