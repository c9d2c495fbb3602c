import { maxLights } from '../../../optics/transfer/lights.ts';
import type { SceneLight, SceneLights } from '../../../optics/transfer/lights.ts';
import { unitToWorld } from '../../../volume/grid.ts';
import { subtract, transformPoint } from '../../../volume/matrix.ts';
import type { VolumeData } from '../../../volume/volume.ts';
import type { Uniforms } from '../../device/inputs.ts';

/** The kinds of lights, in the order of their numbers in the shader, which start at 1; 0 means no light. */
const kinds: readonly SceneLight['kind'][] = ['directional', 'point', 'spot'];

/** A radius that is larger than any scene. */
const everywhere = 1e30;

/**
 * The uniforms of shaders/chunks/shade/lights.glsl. Places are relative to the volume's centre: far from the world's origin float32
 * would have too few digits.
 */
export function lightUniforms({ headlight, lights }: SceneLights, { grid }: VolumeData): Uniforms {
  const uHeadlight = Number(headlight);
  if (lights.length === 0) return { uHeadlight };
  const center = transformPoint(unitToWorld(grid), [0.5, 0.5, 0.5]);
  const columns = (write: (light: SceneLight) => readonly number[]): number[] =>
    Array.from({ length: maxLights }, (_, i) => (lights[i] ? write(lights[i]) : [0, 0, 0, 0])).flat();
  return {
    uHeadlight,
    uLightPlaces: columns(({ location, radius }) => [...subtract(location, center), Math.min(everywhere, radius)]),
    uLightDirections: columns(({ direction, kind }) => [...direction, kinds.indexOf(kind) + 1]),
    uLightColors: columns(({ color, intensity }) => [...color, intensity]),
    uLightFades: columns(({ attenuation, ambientIntensity }) => [...attenuation, ambientIntensity]),
    uLightBeams: columns(({ beamWidth, cutOffAngle }) => [beamWidth, cutOffAngle, 0, 0]),
  };
}
