import type { SceneLight, SceneLights } from '../optics/transfer/lights.ts';
import { length, scale, transformDirection, transformPoint } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { AuthorNodes } from './author-nodes.ts';
import { toRowMajor } from './scene-camera.ts';
import type { X3dLight } from './x3dom-types.ts';

const kinds: Readonly<Record<string, SceneLight['kind']>> = {
  directionallight: 'directional',
  pointlight: 'point',
  spotlight: 'spot',
};

/**
 * The lights of an author's X3D that shine on a volume: lights that are on, and the light at the eye unless it is
 * switched off.
 */
export function readLights(author: AuthorNodes): SceneLights {
  const elements = [...author.host.querySelectorAll(Object.keys(kinds).join())];
  const lights = elements.flatMap((element) => {
    const node = author.nodeOf(element) as X3dLight | null;
    const light = node?._vf.on === true ? readLight(element, node) : null;
    return light ? [light] : [];
  });
  // x3dom uses the scene's own NavigationInfo, which is bound first.
  const navigation = author.host.querySelector('navigationinfo');
  return { headlight: (navigation && author.nodeOf(navigation))?._vf.headlight !== false, lights };
}

/** null for a light without a position or direction. */
function readLight(element: Element, node: X3dLight): SceneLight | null {
  const { color, intensity, ambientIntensity, direction, location, attenuation, radius, beamWidth, cutOffAngle } =
    node._vf;
  const m = toRowMajor(node.getCurrentTransform());
  const kind = kinds[element.localName];
  const read = (vector: X3dLight['_vf']['location']): Vector3 => (vector ? [vector.x, vector.y, vector.z] : [0, 0, 0]);
  const towards = transformDirection(m, read(direction));
  const long = length(towards);
  const light: SceneLight = {
    kind,
    color: [color.r, color.g, color.b],
    intensity,
    ambientIntensity,
    direction: long > 0 ? scale(towards, 1 / long) : [0, 0, 0],
    location: transformPoint(m, read(location)),
    attenuation: attenuation ? read(attenuation) : [1, 0, 0],
    // X3D's default radius of 100 ends inside a head, whose units are mm.
    radius: radius !== undefined && element.hasAttribute('radius') ? radius : Infinity,
    beamWidth: beamWidth ?? 0,
    cutOffAngle: cutOffAngle ?? 0,
  };
  const numbers = [
    ...light.color,
    intensity,
    ambientIntensity,
    ...light.direction,
    ...light.location,
    ...light.attenuation,
    light.beamWidth,
    light.cutOffAngle,
  ];
  return numbers.every(Number.isFinite) && (kind === 'point' || long > 0) ? light : null;
}
