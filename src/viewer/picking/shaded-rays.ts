// Light on rays that are cast on the CPU: loaded with the first picture that is checked.
import { domainOf } from '../../optics/transfer/emission.ts';
import { flatChange } from '../../optics/rays/gradient.ts';
import type { SceneLights } from '../../optics/transfer/lights.ts';
import { lightAt, litShade, pointField, towardsEye } from '../../optics/rays/lit.ts';
import type { ReferenceScene } from '../../optics/reference.ts';
import { brightenSurfaces, surfaceFlat, surfaceGather } from '../../optics/surfaces/surfaces.ts';
import { withLight } from '../../optics/transfer/volume-styles.ts';
import { cutFacesOf, gradientOf, styledStages, surfaceStylesOf } from './pick-styles.ts';
import type { StyledRays } from './pick-styles.ts';

interface ShadedRays extends StyledRays {
  readonly lights: SceneLights;
}

type Shaded = Required<Pick<ReferenceScene, 'moreFields' | 'shades'>> & Pick<ReferenceScene, 'gather'>;

/** What light, styles and surfaces do to rays, as in the picture. Between labels nothing faces anywhere. */
export function shadedRays(rays: ShadedRays): Shaded {
  const { volume, optics, setup, cuts, lights } = rays;
  const { surfaces, shading, styles, lightFactor, transferFunction } = optics;
  if (volume.isDiscrete) return { moreFields: [], shades: [] };
  const { grid } = volume;
  const flat = flatChange(domainOf(transferFunction), volume.range);
  const scene = { grid, gradient: gradientOf(volume), flat, lights, cuts: cutFacesOf(cuts, setup) };
  const isClear = surfaces?.clear === true;
  const isLit = shading === 'lit';
  const shades = isClear ? [] : styles ? styledStages(rays, isLit ? withLight(styles) : styles).shades : isLit ? [litShade(scene)] : [];
  if (!surfaces) return { moreFields: shades.length > 0 ? [pointField] : [], shades };
  const light = surfaces.plain ? null : lightAt({ ...scene, flat: surfaceFlat * flat });
  const gather = surfaceGather({ surfaces: brightenSurfaces(surfaces.surfaces, lightFactor), isClear, light, toEye: (ray) => towardsEye(grid, ray), stylesOf: surfaces.surfaceStyles && !surfaces.plain ? surfaceStylesOf(rays, surfaces.surfaceStyles) : undefined });
  return { moreFields: [pointField], shades, gather };
}
