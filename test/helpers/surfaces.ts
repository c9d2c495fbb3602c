import { domainOf } from '../../src/optics/transfer/emission.ts';
import { cartesianGradient, flatChange } from '../../src/optics/rays/gradient.ts';
import { lightAt, pointField, towardsEye } from '../../src/optics/rays/lit.ts';
import type { LitScene } from '../../src/optics/rays/lit.ts';
import { cartesianField } from '../../src/optics/rays/ray-field.ts';
import type { RayStyle } from '../../src/optics/rays/ray-style.ts';
import type { ReferenceScene } from '../../src/optics/reference.ts';
import { stylesAt } from '../../src/optics/rays/styled.ts';
import { surfaceFlat, surfaceGather } from '../../src/optics/surfaces/surfaces.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { polarBeamField } from '../../src/radar/polar-field.ts';
import { polarGradient } from '../../src/radar/polar-gradient.ts';
import { isPolar } from '../../src/volume/volume.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** The additional stages of a reference's rays for a volume with surfaces. */
export function surfaceStages(
  volume: Volume,
  { surfaces = [], clear, plain, surfaceStyles }: RayStyle,
  transferFunction: TransferFunction,
  more: Partial<LitScene> = {},
): Pick<ReferenceScene, 'moreFields' | 'gather'> {
  const { grid } = volume;
  const gradient = isPolar(volume)
    ? polarGradient(polarBeamField(volume), volume.grid)
    : cartesianGradient(cartesianField({ ...volume, dimensions: grid.dimensions }), grid);
  const flat = surfaceFlat * flatChange(domainOf(transferFunction), volume.range);
  const chains = surfaceStyles && [{ weight: 1, styles: surfaceStyles }];
  const stylesOf =
    chains &&
    stylesAt({ grid, gradient, flat: flat / surfaceFlat, chains, referenceLength: 1, flatPart: surfaceFlat, ...more });
  const light = plain ? null : lightAt({ grid, gradient, flat, ...more });
  return {
    moreFields: [pointField],
    gather: surfaceGather({
      surfaces,
      isClear: clear === true,
      light,
      toEye: (ray) => towardsEye(grid, ray),
      stylesOf,
    }),
  };
}
