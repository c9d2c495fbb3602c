// What X3D's rendering styles do to rays that are cast on the CPU: loaded with the first pick of a volume that wears some.
import { uncut } from '../optics/cut-fade.ts';
import type { Cutout, HalfSpace } from '../optics/clip-intervals.ts';
import { domainOf } from '../optics/emission.ts';
import { cartesianGradient, flatChange } from '../optics/gradient.ts';
import { pointField } from '../optics/lit.ts';
import { cartesianField } from '../optics/ray-field.ts';
import type { ReferenceScene } from '../optics/reference.ts';
import type { RaySetup } from '../optics/rays.ts';
import { styledShade } from '../optics/styled.ts';
import type { StyleChain } from '../optics/volume-styles.ts';
import { polarBeamField } from '../radar/polar-field.ts';
import { polarGradient } from '../radar/polar-gradient.ts';
import type { RayCut } from '../renderer/ray/ray-module.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import type { VolumeOptics } from './volume-info.ts';

interface StyledRays {
  readonly volume: Volume;
  readonly optics: VolumeOptics & { readonly styles: readonly StyleChain[] };
  readonly setup: RaySetup;
  readonly cuts: readonly RayCut[];
}

/** Where light comes from says nothing about how opaque places are. */
export function styledStages({ volume, optics, setup, cuts }: StyledRays): Required<Pick<ReferenceScene, 'moreFields' | 'shades'>> {
  if (volume.isDiscrete) return { moreFields: [], shades: [] };
  const { grid } = volume;
  const { styles: chains, referenceLength, opacityFactor, transferFunction } = optics;
  const gradient = isPolar(volume) ? polarGradient(polarBeamField(volume), volume.grid) : cartesianGradient(cartesianField({ ...volume, dimensions: grid.dimensions }), grid);
  const items = cuts.flatMap((cut) => cut.items) as readonly (HalfSpace | Cutout | { readonly kind: 'plane' })[];
  const faces = {
    ...uncut,
    unitToRegion: setup.unitToRegion,
    halfSpaces: items.filter((item) => item.kind === 'half-space'),
    unitToCutout: items.find((item) => item.kind === 'cutout')?.unitToBox ?? null,
  };
  const opticalScale = (setup.diameter / referenceLength) * opacityFactor;
  return { moreFields: [pointField], shades: [styledShade({ grid, gradient, flat: flatChange(domainOf(transferFunction), volume.range), cuts: faces, chains, referenceLength, opticalScale })] };
}
