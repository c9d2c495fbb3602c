import { cartesianGradient, flatChange } from '../../src/optics/rays/gradient.ts';
import { domainOf } from '../../src/optics/transfer/emission.ts';
import { litShade, pointField } from '../../src/optics/rays/lit.ts';
import type { LitScene } from '../../src/optics/rays/lit.ts';
import { cartesianField } from '../../src/optics/rays/ray-field.ts';
import type { ReferenceScene } from '../../src/optics/reference.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { polarBeamField } from '../../src/radar/polar-field.ts';
import { polarGradient } from '../../src/radar/polar-gradient.ts';
import type { SceneLight, SceneLights } from '../../src/optics/transfer/lights.ts';
import { styledShade } from '../../src/optics/rays/styled.ts';
import type { StyleChain } from '../../src/optics/transfer/volume-styles.ts';
import { plainOptics, raysOf } from './picture.ts';
import type { View } from './picture.ts';
import { isPolar } from '../../src/volume/volume.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** A directional light of an author, oblique to all axes. */
export const lamp: SceneLight = {
  kind: 'directional',
  color: [1, 0.9, 0.7],
  intensity: 0.8,
  ambientIntensity: 0.1,
  direction: [-0.6, 0.64, -0.48],
  location: [0, 0, 0],
  attenuation: [1, 0, 0],
  radius: Infinity,
  beamWidth: 0.2,
  cutOffAngle: 0.6,
};

/** The gradient of a volume's values at a place. */
const gradientOf = (volume: Volume): LitScene['gradient'] =>
  isPolar(volume)
    ? polarGradient(polarBeamField(volume), volume.grid)
    : cartesianGradient(cartesianField({ ...volume, dimensions: volume.grid.dimensions }), volume.grid);

/** The additional stages of a reference's rays for a lit volume. */
export function litStages(
  volume: Volume,
  transferFunction: TransferFunction,
  more: Partial<LitScene> = {},
): Pick<ReferenceScene, 'moreFields' | 'shades'> {
  const gradient = gradientOf(volume);
  const flat = flatChange(domainOf(transferFunction), volume.range);
  return { moreFields: [pointField], shades: [litShade({ grid: volume.grid, gradient, flat, ...more })] };
}

/** The additional stages of a reference's rays for a volume in X3D's rendering styles. */
export function styledStages(
  view: View,
  chains: readonly StyleChain[],
  lights?: SceneLights,
): Pick<ReferenceScene, 'moreFields' | 'shades'> {
  const { volume, optics = plainOptics } = view;
  const gradient = gradientOf(volume);
  const flat = flatChange(domainOf(optics.transferFunction), volume.range);
  const { referenceLength, opacityFactor } = optics;
  const opticalScale = (raysOf(view).diameter / referenceLength) * opacityFactor;
  return {
    moreFields: [pointField],
    shades: [
      styledShade({
        grid: volume.grid,
        gradient,
        flat,
        chains,
        referenceLength,
        opticalScale,
        ...(lights && { lights }),
      }),
    ],
  };
}
