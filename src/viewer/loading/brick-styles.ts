// What rendering styles make of many values of a ray, for estimates.
import type { Gradient } from '../../optics/rays/gradient.ts';
import { keepLast } from '../../optics/rays/keep-last.ts';
import type { Ray } from '../../optics/rays/rays.ts';
import type { stylesAt } from '../../optics/shading-twins.ts';
import type { Styled } from '../../optics/transfer/volume-styles.ts';
import { unitToWorld } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { add, cross, dot, normalize, scale, transformDirection } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';

/** Bins of the cosine between a change and the direction to the eye; of an octave of how large it is; and octaves to both sides of a flat change. */
const [facings, perOctave, octaves] = [64, 4, 31];

const sizes = 2 * perOctave * octaves + 1;

/** Many times as fast as Math.hypot, where no number is extreme. */
const quickLength = (a: Vector3): number => Math.sqrt(dot(a, a));

/** A direction in the unit cube. */
interface Directed {
  readonly direction: readonly number[];
}

/**
 * With the light of the eye alone, what styles do depends on the angle between a change and the eye, and on how large the change is: it is worked out once for changes
 * that are alike. Next to the faces of the grid, where light fades, it is worked out each time.
 * @param flat - a change that counts as flat, see `flatChange`
 * @param stylesOf - what the styles do, for a gradient that it asks for
 */
export function lookUpStyles(
  { grid, flat }: { readonly grid: GridFrame; readonly flat: number },
  stylesOf: (gradient: () => Gradient) => ReturnType<typeof stylesAt>,
): (ray: Directed, place: Vector3, gradient: Gradient) => Styled {
  const toWorld = unitToWorld(grid);
  const towardsEye = keepLast(({ direction }: Directed) =>
    normalize(transformDirection(toWorld, direction.map((x) => -x) as unknown as Vector3)),
  );
  const ray: Directed = { direction: [0, 0, 1] };
  const eye = towardsEye(ray);
  const aside = normalize(cross(eye, Math.abs(eye[0]) < 0.5 ? [1, 0, 0] : [0, 1, 0]));
  let example: Gradient;
  const styled = stylesOf(() => example);
  const voxel = grid.dimensions.map((n) => 1 / n);
  const isAtFace = ([x, y, z]: Vector3): boolean =>
    Math.min(x, 1 - x) < voxel[0] || Math.min(y, 1 - y) < voxel[1] || Math.min(z, 1 - z) < voxel[2];
  const known = new Map<number, Styled>();
  /** 0 where nothing changes. */
  const binOf = (size: number): number =>
    Math.min(sizes, Math.max(0, Math.round(perOctave * (Math.log2(size / flat) + octaves)) + 1));
  const sizeOf = (bin: number): number => (bin === 0 ? 0 : flat * 2 ** ((bin - 1) / perOctave - octaves));
  return (seen, place, gradient) => {
    if (isAtFace(place)) {
      example = gradient;
      return styled(seen as Ray)({ value: 0, valid: true, point: place });
    }
    const { perVoxel, world } = gradient;
    const size = quickLength(world);
    const cosine = size > 0 ? Math.abs(dot(world, towardsEye(seen))) / size : 0;
    const [facing, ofVoxel, ofWorld] = [Math.round(cosine * facings), binOf(quickLength(perVoxel)), binOf(size)];
    const key = facing + (facings + 1) * (ofVoxel + (sizes + 1) * ofWorld);
    let found = known.get(key);
    if (!found) {
      const share = facing / facings;
      const direction = add(scale(eye, share), scale(aside, Math.sqrt(1 - share ** 2)));
      example = { perVoxel: [sizeOf(ofVoxel), 0, 0], world: scale(direction, sizeOf(ofWorld)) };
      found = styled(ray as Ray)({ value: 0, valid: true, point: [0.5, 0.5, 0.5] });
      known.set(key, found);
    }
    return found;
  };
}
