import { finestSpacing, unitToWorld } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import {
  add,
  dot,
  length,
  normalize,
  scale,
  subtract,
  transformDirection,
  transformPoint,
} from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { fadeAtCuts, uncut } from './cut-fade.ts';
import { flatShare, weighChange } from './gradient.ts';
import { keepLast } from './keep-last.ts';
import { headlightAlone, maxLights, plainMaterial, shadeSurface, softFacing } from '../transfer/lights.ts';
import type { LitMaterial, SceneLights, Shade } from '../transfer/lights.ts';
import type { LitScene } from './lit.ts';
import type { Sample, ShadeStage } from './ray-stages.ts';
import type { Ray } from './rays.ts';
import {
  buildStyleTable,
  flatFactor,
  flatOf,
  gradientReach,
  shadedOf,
  shareOfChange,
  styleColumns,
} from '../transfer/volume-styles.ts';
import type { StyleChain, Styled, StyledPlace, StyleMaterial, VolumeStyle } from '../transfer/volume-styles.ts';

/** A volume that is drawn in X3D's rendering styles, as far as single places need it. */
export interface StyledPlaces extends Omit<LitScene, 'material'> {
  readonly chains: readonly StyleChain[];
  /** World length to which a stop's opacity belongs. */
  readonly referenceLength: number;
  /** Which share of a flat change counts as flat; if absent, the one that the chains give. */
  readonly flatPart?: number;
}

/** The same with what emission and absorption need. */
export interface StyledScene extends StyledPlaces {
  /** Reference lengths per bounding diameter, times the opacity factor. */
  readonly opticalScale: number;
}

/** The largest opacity over a reference length. */
export const maxOpacity = 0.9999;

/** Factors stay below this, so that products in the shader stay finite. */
const largestFactor = 1e30;

const white: Vector3 = [1, 1, 1];
const { ambient, shininess } = plainMaterial;

/** The material of lit volumes, in X3D's fields. */
const plain: StyleMaterial = { ambient, diffuse: white, specular: white, emissive: [0, 0, 0], shininess };

/** The shares of each kind of light that a material reflects, as a `LitMaterial`, and the colours that multiply them. */
export function splitMaterial(material: StyleMaterial | null): {
  readonly shares: LitMaterial;
  readonly colors: StyleMaterial;
} {
  if (!material) return { shares: plainMaterial, colors: plain };
  return {
    shares: { ambient: material.ambient, diffuse: 1, specular: 1, shininess: material.shininess },
    colors: material,
  };
}

/**
 * Factor for a gradient's length, which is in flat changes (see `flatChange`) per world unit. The product is the change along a reference
 * length, as a share of the transfer function's span. Directions in the world have another scale in cartesian grids, see `normalsToWorld`.
 */
export function perReferenceLength(grid: GridFrame & { readonly kind?: string }, referenceLength: number): number {
  return (flatShare * referenceLength) / (grid.kind === 'polar' ? 1 : finestSpacing(grid));
}

/**
 * Factor for a change along a reference length. The product is a share of the reach of `gradient-opacity`; 0 if the styles have none.
 * @param flat - see `flatChange`
 */
export function perGradientReach(styles: readonly VolumeStyle[], flat: number, referenceLength: number): number {
  const reach = gradientReach(styles);
  return reach > 0 ? Math.min(largestFactor, flat / (flatShare * referenceLength * reach)) : 0;
}

/** The effect of the styles at places of a ray. Twin: shaders/chunks/shade/styled-sample.glsl */
export function stylesAt(scene: StyledPlaces): (ray: Ray) => (known: Sample) => Styled {
  const { grid, gradient, flat, lights = headlightAlone, cuts = uncut, chains, referenceLength } = scene;
  const toWorld = unitToWorld(grid);
  const fade = fadeAtCuts(cuts, grid.dimensions);
  const toChange = perReferenceLength(grid, referenceLength) / flat;
  const lightFlat = (scene.flatPart ?? flatOf(chains)) * flat;
  const tables = chains.map(({ weight, styles }) => ({
    weight,
    table: buildStyleTable(styles),
    flat: flatFactor(styles),
    shaded: shadedOf(styles),
    perReach: perGradientReach(styles, flat, referenceLength),
  }));
  const styleAt = (known: Sample, toEye: Vector3): Styled => {
    const place = known.point as Vector3;
    const { perVoxel, world } = gradient(place, known);
    // The normal is 0 where nothing changes; 1 / Number.MIN_VALUE would be infinite.
    const normal = scale(world, 1 / Math.max(length(world), 1e-300));
    const at = { place: transformPoint(toWorld, place), normal, toEye };
    const here: StyledPlace = {
      facing: Math.min(1, Math.abs(dot(normal, toEye))),
      towards: towardsLights(lights, at),
      change: toChange * length(world),
      weight: fade(place) * weighChange(perVoxel, lightFlat),
    };
    return tables.reduce<Styled>((sum, { weight, table, flat: flatOpacity, shaded, perReach }) => {
      const { shares, colors } = splitMaterial(shaded?.material ?? null);
      const one = lookUpStyle(
        { table, flat: flatOpacity, perReach, shade: shaded ? shadeSurface(lights, shares, at) : null, colors },
        here,
      );
      return {
        gain: add(sum.gain, scale(one.gain, weight)),
        more: add(sum.more, scale(one.more, weight)),
        opacity: sum.opacity + weight * one.opacity,
      };
    }, nothing);
  };
  return keepLast((ray: Ray) => {
    const toEye = scale(normalize(transformDirection(toWorld, ray.direction)), -1);
    return keepLast((known: Sample) => styleAt(known, toEye));
  });
}

/**
 * X3D's rendering styles on a piece of a ray: they change colour and opacity by the mean of their effect at both ends. They act on the
 * opacity over a reference length, whatever the length of the piece: t' = -ln(1 - k (1 - exp(-t))). So the steps do not matter.
 * Source: ISO/IEC 19775-1, 41. Twin: shaders/chunks/shade/styled.glsl
 */
export function styledShade(scene: StyledScene): ShadeStage {
  const { opticalScale } = scene;
  const stylesOf = stylesAt(scene);
  return ({ front, back, span }, seen, ray) => {
    if (!(seen[3] > 0)) return seen;
    const styled = stylesOf(ray);
    const near = styled(front.valid ? front : back);
    const far = styled(back.valid ? back : front);
    // If neither end has data in the volume, a layer may be visible over the whole length.
    const ratio = span * opticalScale * (front.valid === back.valid ? 1 : 0.5);
    const own = -Math.expm1(Math.log1p(-Math.min(seen[3], 1 - 1e-16)) / ratio);
    const alpha = -Math.expm1(ratio * Math.log1p(-Math.min(maxOpacity, own * ((near.opacity + far.opacity) / 2))));
    const channel = (c: 0 | 1 | 2): number =>
      alpha * Math.min(1, ((seen[c] / seen[3]) * (near.gain[c] + far.gain[c]) + near.more[c] + far.more[c]) / 2);
    return [channel(0), channel(1), channel(2), alpha];
  };
}

const nothing: Styled = { gain: [0, 0, 0], more: [0, 0, 0], opacity: 0 };

/** How much a surface faces the lights: the mean of n . l by intensity, for the side that faces the eye. */
function towardsLights(
  { headlight, lights }: SceneLights,
  { place, normal, toEye }: { readonly place: Vector3; readonly normal: Vector3; readonly toEye: Vector3 },
): number {
  const facing = dot(normal, toEye);
  const side = Math.min(1, Math.max(-1, facing / softFacing));
  let [sum, weights] = headlight ? [Math.abs(facing), 1] : [0, 0];
  for (const { kind, direction, location, intensity } of lights.slice(0, maxLights)) {
    const toLight = kind === 'directional' ? scale(direction, -1) : normalize(subtract(location, place));
    sum += intensity * side * dot(normal, toLight);
    weights += intensity;
  }
  return sum / Math.max(weights, 1e-6);
}

/** The effect of a chain at a place. */
function lookUpStyle(
  {
    table,
    flat,
    perReach,
    shade,
    colors,
  }: { table: Float64Array; flat: number; perReach: number; shade: Shade | null; colors: StyleMaterial },
  { facing, towards, change, weight }: StyledPlace,
): Styled {
  let [gain, more]: [Vector3, Vector3] = [white, [0, 0, 0]];
  const apply = (factor: Vector3, plus: Vector3): void => {
    const kept: Vector3 = [1 + weight * (factor[0] - 1), 1 + weight * (factor[1] - 1), 1 + weight * (factor[2] - 1)];
    gain = multiplyEach(gain, kept);
    more = add(multiplyEach(more, kept), scale(plus, weight));
  };
  const applyRow = (row: number, share: number): void => {
    const [red, green, blue, kept] = lookUpRow(table, row, share);
    apply([kept, kept, kept], [red, green, blue]);
  };
  applyRow(0, 0.5 + 0.5 * towards);
  applyRow(1, facing);
  if (shade)
    apply(
      multiplyEach(shade.diffuse, colors.diffuse),
      add(multiplyEach(shade.specular, colors.specular), colors.emissive),
    );
  applyRow(2, facing);
  const opacity =
    (flat + weight * (lookUpRow(table, 3, facing)[0] - flat)) * lookUpRow(table, 3, shareOfChange(change))[1];
  return { gain, more, opacity: opacity * (perReach > 0 ? lookUpRow(table, 3, change * perReach)[2] : 1) };
}

/** Interpolates linearly between a row's entries. */
function lookUpRow(table: Float64Array, row: number, share: number): readonly number[] {
  const at = Math.min(1, Math.max(0, share)) * (styleColumns - 1);
  const low = Math.min(styleColumns - 2, Math.floor(at));
  const first = 4 * (row * styleColumns + low);
  const entry = (c: number): number => table[first + c] + (at - low) * (table[first + 4 + c] - table[first + c]);
  return [entry(0), entry(1), entry(2), entry(3)];
}

function multiplyEach(a: Vector3, b: Vector3): Vector3 {
  return [a[0] * b[0], a[1] * b[1], a[2] * b[2]];
}
