import { unitToWorld } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { length, normalize, scale, transformDirection, transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { fadeAtCuts, uncut } from './cut-fade.ts';
import type { CutFaces } from './cut-fade.ts';
import { weighChange } from './gradient.ts';
import type { GradientStage } from './gradient.ts';
import { keepLast } from './keep-last.ts';
import { fogFlat, fogMaterial, headlightAlone, plainMaterial, shadeSurface } from '../transfer/lights.ts';
import type { LitMaterial, SceneLights, Shade } from '../transfer/lights.ts';
import type { Sample, SecondFieldStage, ShadeStage } from './ray-stages.ts';
import type { Ray } from './rays.ts';

/** The lights of a volume, and the field whose gradient they light. */
export interface LitScene {
  readonly grid: GridFrame;
  readonly gradient: GradientStage;
  /** See `flatChange`. */
  readonly flat: number;
  readonly lights?: SceneLights;
  readonly material?: LitMaterial;
  readonly cuts?: CutFaces;
}

/** Adds the place of each sample: the shading of a piece of a ray needs it at both ends. Twin: shaders/chunks/walk/points.glsl */
export const pointField: SecondFieldStage = (place, known) => {
  known.point = place;
  return known;
};

/** The light at a place. @param toEye - of length 1, world */
export type LightStage = (known: Sample, toEye: Vector3) => Shade;

/** Twin: shaders/chunks/shade/lit-sample.glsl, shadeSample */
export function lightAt({
  grid,
  gradient,
  flat,
  lights = headlightAlone,
  material = plainMaterial,
  cuts = uncut,
}: LitScene): LightStage {
  const toWorld = unitToWorld(grid);
  const fade = fadeAtCuts(cuts, grid.dimensions);
  return (known, toEye) => {
    const place = known.point as Vector3;
    const { perVoxel, world } = gradient(place, known);
    const weight = fade(place) * weighChange(perVoxel, flat);
    if (!(weight > 0)) return unlit;
    const shade = shadeSurface(lights, material, {
      place: transformPoint(toWorld, place),
      normal: scale(world, 1 / Math.max(length(world), Number.MIN_VALUE)),
      toEye,
    });
    const [red, green, blue] = shade.diffuse;
    return {
      diffuse: [1 + weight * (red - 1), 1 + weight * (green - 1), 1 + weight * (blue - 1)],
      specular: scale(shade.specular, weight),
    };
  };
}

/** The direction to the eye, of length 1, world. */
export function towardsEye(grid: GridFrame, ray: Ray): Vector3 {
  return scale(normalize(transformDirection(unitToWorld(grid), ray.direction)), -1);
}

/**
 * Lights the surfaces that a field has everywhere its values change. The colour is multiplied by diffuse light, and white
 * is added in proportion to the opacity; each is the mean of both ends. Flat places keep their colour, and so do places next to a cut.
 * Source: Lum, Wilson and Ma 2004. Twin: shaders/chunks/shade/lit.glsl
 */
export function litShade(scene: LitScene): ShadeStage {
  const light = lightAt({ material: fogMaterial, ...scene, flat: fogFlat * scene.flat });
  // A sample belongs to one ray only.
  const shadesOf = keepLast((ray: Ray) => {
    const toEye = towardsEye(scene.grid, ray);
    return keepLast((known: Sample) => light(known, toEye));
  });
  return ({ front, back }, seen, ray) => {
    if (!(seen[3] > 0)) return seen;
    const shadeAt = shadesOf(ray);
    const near = shadeAt(front.valid ? front : back);
    const far = shadeAt(back.valid ? back : front);
    const channel = (c: 0 | 1 | 2): number =>
      Math.min(
        seen[3],
        (seen[c] * (near.diffuse[c] + far.diffuse[c]) + seen[3] * (near.specular[c] + far.specular[c])) / 2,
      );
    return [channel(0), channel(1), channel(2), seen[3]];
  };
}

const unlit: Shade = { diffuse: [1, 1, 1], specular: [0, 0, 0] };
