import { add, dot, length, normalize, scale, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/** A light of X3D, in world coordinates. */
export interface SceneLight {
  readonly kind: 'directional' | 'point' | 'spot';
  readonly color: Vector3;
  readonly intensity: number;
  readonly ambientIntensity: number;
  /** The direction in which it shines, of length 1; not used for a point light. */
  readonly direction: Vector3;
  /** Not used for a directional light. */
  readonly location: Vector3;
  /** Constant, linear and quadratic in the distance; world units. */
  readonly attenuation: Vector3;
  /** World length that the light reaches; Infinity if it has no limit. */
  readonly radius: number;
  /** For a spot light, in radians from its axis: full light up to this angle, and no light beyond `cutOffAngle`. */
  readonly beamWidth: number;
  readonly cutOffAngle: number;
}

/** The lights on a volume. */
export interface SceneLights {
  /** Whether a white light shines from the eye. */
  readonly headlight: boolean;
  readonly lights: readonly SceneLight[];
}

/** At most this many lights shine on a volume. */
export const maxLights = 4;

export const headlightAlone: SceneLights = { headlight: true, lights: [] };

/** How a lit volume reflects light. A share of 1 gives the colour that the legend shows. */
export interface LitMaterial {
  readonly ambient: number;
  readonly diffuse: number;
  readonly specular: number;
  readonly shininess: number;
}

/** A surface that faces the headlight keeps its colour, except for a little white. */
export const plainMaterial: LitMaterial = { ambient: 0.3, diffuse: 0.7, specular: 0.05, shininess: 20 };

/**
 * In fog, the flat change is larger by this factor. At a ridge both sides are seen edge on and nothing changes in between; without the
 * factor it would be a bright line.
 */
export const fogFlat = 2.5;

/**
 * For fog, which has no surfaces of its own and faces all directions. Parts that face the headlight must be brighter than their colour, or
 * a lit volume would be darker than an unlit one. The mean over a sphere under the headlight is 0.4 + 2/3 0.8: 0.93 of its colour.
 */
export const fogMaterial: LitMaterial = { ambient: 0.4, diffuse: 0.8, specular: 0.05, shininess: 20 };

/** Up to this cosine between normal and eye, both sides of a surface are mixed, so that there is no edge at which the side jumps. */
export const softFacing = 0.2;

/** Specular light fades out where there is less diffuse light than this. */
export const softSpecular = 0.1;

/** How light changes a colour, by channel: the factor of the colour, and the white that is added. */
export interface Shade {
  readonly diffuse: Vector3;
  readonly specular: Vector3;
}

/**
 * Two-sided Blinn-Phong lighting: the side that faces the eye is visible.
 * @param normal - of length 1, world
 * @param toEye - of length 1, world
 * Source: Blinn 1977; attenuation and spot as in ISO/IEC 19775-1, 17.2.2. Twin: shaders/chunks/shade/lit.glsl and lights.glsl
 */
export function shadeSurface(
  { headlight, lights }: SceneLights,
  material: LitMaterial,
  at: { readonly place: Vector3; readonly normal: Vector3; readonly toEye: Vector3 },
): Shade {
  const facing = dot(at.normal, at.toEye);
  const head = headlight ? 1 : 0;
  const gray = (x: number): Vector3 => [x, x, x];
  let diffuse = gray(material.ambient + head * material.diffuse * Math.abs(facing));
  let specular = gray(head * material.specular * Math.abs(facing) ** material.shininess);
  const front = clamp(0.5 + (0.5 * facing) / softFacing);
  for (const light of lights.slice(0, maxLights)) {
    const { toLight, reach } = beamOf(light, at.place);
    const [lit, half] = [dot(at.normal, toLight), dot(at.normal, normalize(add(toLight, at.toEye)))];
    const sides = (x: number, power: number): number =>
      front * Math.max(0, x) ** power + (1 - front) * Math.max(0, -x) ** power;
    const seen = sides(lit, 1);
    const glint = sides(half, material.shininess) * clamp(seen / softSpecular);
    const fraction = light.ambientIntensity * material.ambient + light.intensity * material.diffuse * seen;
    diffuse = add(diffuse, scale(light.color, reach * fraction));
    specular = add(specular, scale(light.color, reach * light.intensity * material.specular * glint));
  }
  return { diffuse, specular };
}

/** The direction to a light, and the share of its light that reaches a place. */
function beamOf(
  { kind, direction, location, attenuation, radius, beamWidth, cutOffAngle }: SceneLight,
  place: Vector3,
): { toLight: Vector3; reach: number } {
  if (kind === 'directional') return { toLight: scale(direction, -1), reach: 1 };
  const offset = subtract(location, place);
  const distance = Math.max(length(offset), 1e-12);
  const toLight = scale(offset, 1 / distance);
  const [constant, linear, square] = attenuation;
  const reach = distance > radius ? 0 : 1 / Math.max(1, constant + distance * (linear + distance * square));
  if (kind === 'point') return { toLight, reach };
  const angle = Math.acos(Math.min(1, Math.max(-1, -dot(toLight, direction))));
  const inner = Math.min(beamWidth, cutOffAngle);
  return { toLight, reach: reach * clamp((cutOffAngle - angle) / Math.max(1e-4, cutOffAngle - inner)) };
}

function clamp(x: number): number {
  return Math.min(1, Math.max(0, x));
}
