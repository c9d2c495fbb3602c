// What X3D's rendering styles do to rays that are cast on the CPU: loaded with the first such ray of a volume that wears some.
import { uncut } from '../../optics/rays/cut-fade.ts';
import type { CutFaces } from '../../optics/rays/cut-fade.ts';
import type { Cutout, HalfSpace } from '../../optics/rays/clip-intervals.ts';
import { domainOf } from '../../optics/transfer/emission.ts';
import { cartesianGradient, flatChange } from '../../optics/rays/gradient.ts';
import type { GradientStage } from '../../optics/rays/gradient.ts';
import type { SceneLights } from '../../optics/transfer/lights.ts';
import { pointField } from '../../optics/rays/lit.ts';
import { cartesianField } from '../../optics/rays/ray-field.ts';
import type { ReferenceScene } from '../../optics/reference.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { styledShade, stylesAt } from '../../optics/rays/styled.ts';
import type { StyledPlaces } from '../../optics/rays/styled.ts';
import { surfaceFlat } from '../../optics/surfaces/surfaces.ts';
import type { SurfaceScene } from '../../optics/surfaces/surfaces.ts';
import type { StyleChain } from '../../optics/transfer/volume-styles.ts';
import { polarBeamField } from '../../radar/polar-field.ts';
import { polarGradient } from '../../radar/polar-gradient.ts';
import type { RayCut } from '../../renderer/ray/ray-module.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

export interface StyledRays {
  readonly volume: Volume;
  readonly optics: VolumeOptics;
  readonly setup: RaySetup;
  readonly cuts: readonly RayCut[];
  /** A light at the eye where absent: where light comes from says nothing about how opaque places are. */
  readonly lights?: SceneLights;
}

/** What emits and absorbs, in styles. */
export function styledStages(rays: StyledRays, chains: readonly StyleChain[]): Required<Pick<ReferenceScene, 'moreFields' | 'shades'>> {
  if (rays.volume.isDiscrete) return { moreFields: [], shades: [] };
  const { setup, optics: { referenceLength, opacityFactor } } = rays;
  return { moreFields: [pointField], shades: [styledShade({ ...placesOf(rays, chains), opticalScale: (setup.diameter / referenceLength) * opacityFactor })] };
}

/** Surfaces alone, in styles. */
export function surfaceStylesOf(rays: StyledRays, styles: StyleChain['styles']): SurfaceScene['stylesOf'] {
  return stylesAt({ ...placesOf(rays, [{ weight: 1, styles }]), flatPart: surfaceFlat });
}

function placesOf({ volume, optics, setup, cuts, lights }: StyledRays, chains: readonly StyleChain[]): StyledPlaces {
  const { referenceLength, transferFunction } = optics;
  const flat = flatChange(domainOf(transferFunction), volume.range);
  return { grid: volume.grid, gradient: gradientOf(volume), flat, cuts: cutFacesOf(cuts, setup), chains, referenceLength, ...(lights && { lights }) };
}

/** The gradients of a volume, as its picture has them. */
export function gradientOf(volume: Volume): GradientStage {
  const { grid } = volume;
  return isPolar(volume) ? polarGradient(polarBeamField(volume), volume.grid) : cartesianGradient(cartesianField({ ...volume, dimensions: grid.dimensions }), grid);
}

/** The faces at which what is cut open shows values, and no light. */
export function cutFacesOf(cuts: readonly RayCut[], { unitToRegion }: RaySetup): CutFaces {
  const items = cuts.flatMap((cut) => cut.items) as readonly (HalfSpace | Cutout | { readonly kind: 'plane' })[];
  return {
    ...uncut,
    unitToRegion,
    halfSpaces: items.filter((item) => item.kind === 'half-space'),
    unitToCutout: items.find((item) => item.kind === 'cutout')?.unitToBox ?? null,
  };
}
