// How the values of a volume in bricks look, as far as it matters for what bricks bring to a picture.
import type { DetailLight } from '../../bricks/detail-light.ts';
import type { ExtremeLook } from '../../bricks/detail-scene.ts';
import type { PaintedPlane } from '../../bricks/painted-plane.ts';
import { sumSpans } from '../../bricks/span-sums.ts';
import type { PlaneSlice } from '../../optics/attachments/plane-slices.ts';
import { brighten } from '../../optics/transfer/brighten.ts';
import { evaluate, largestOpacity } from '../../optics/transfer/transfer-function.ts';
import type { Premultiplied, Stop, TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** That of `plainMaterial` in optics/transfer/lights.ts, which another part of the package holds. */
const diffuse = 0.7;

/** The light of a picture; undefined for none. Surfaces of values are always lit. @param finest - the voxels of the finest level */
export function lightOf({ shading, surfaces, projection }: VolumeOptics, finest: GridFrame): DetailLight | undefined {
  if (projection || (shading === 'unlit' && !surfaces?.surfaces.length)) return undefined;
  return { diffuse, voxel: finest.dimensions.map((n) => 1 / n) as unknown as Vector3 };
}

/** The largest or smallest value of each ray, if that is what a picture shows: the largest opacity counts as 1, as in `classifyValue`. */
export function extremeOf(
  { projection, intensityThreshold, transferFunction, lightFactor }: VolumeOptics,
  { slope, intercept }: Pick<Volume, 'slope' | 'intercept'>,
): ExtremeLook | undefined {
  if (!projection || projection === 'average') return undefined;
  const looks = brighten(transferFunction, lightFactor);
  const largest = largestOpacity(looks);
  // Values of a file may fall where stored ones rise.
  const sign = (projection === 'max') === slope > 0 ? 1 : -1;
  return {
    sign,
    ...(intensityThreshold !== undefined && { threshold: (sign * (intensityThreshold - intercept)) / slope }),
    colorOf: (value) => evaluate(looks, slope * value + intercept).map((x) => x / largest) as Premultiplied,
  };
}

/** Steps that are so long, in reference lengths, are opaque where values have any opacity. */
const opaqueLength = 1e6;

/** A thick plane is taken to show the values in its middle. */
export function paintedOf(
  { normal, offset, window }: PlaneSlice,
  { transferFunction, lightFactor }: VolumeOptics,
  range: readonly [number, number],
  { slope, intercept }: Pick<Volume, 'slope' | 'intercept'>,
): PaintedPlane {
  const looks: TransferFunction = window
    ? [
        { value: window[0], color: [0, 0, 0], opacity: 1 },
        { value: window[1], color: [1, 1, 1], opacity: 1 },
      ]
    : brighten(transferFunction, lightFactor);
  return { normal, offset, sums: sumSpans(looks, range, { slope, intercept, stepRatio: opaqueLength }) };
}

/** Opacity of a ramp, along the diameter: values differ in it, and one sees through it. */
const rampOpacity = 0.8;

/**
 * How values are seen, and over which length. An average of a ray is taken for a fog of all values, and the first opaque surface for what is opaque
 * behind it: translucent ones in front of it do not count.
 */
export function seenValues(
  { range }: Volume,
  { transferFunction, lightFactor, referenceLength, projection, surfaces }: VolumeOptics,
  diameter: number,
): readonly [TransferFunction, number] {
  if (projection)
    return [
      [
        { value: range[0], color: [0, 0, 0], opacity: 0 },
        { value: range[1], color: [1, 1, 1], opacity: rampOpacity },
      ],
      diameter,
    ];
  const fog = brighten(transferFunction, lightFactor);
  if (!surfaces || surfaces.surfaces.length === 0) return [fog, referenceLength];
  const opaque = surfaces.surfaces.filter(({ opacity }) => opacity > 0.5);
  const { value, color } = (opaque.length > 0 ? opaque : surfaces.surfaces).reduce((one, other) =>
    other.value < one.value ? other : one,
  );
  const before: TransferFunction = surfaces.clear
    ? [{ value, color, opacity: 0 }]
    : [...fog.filter((stop) => stop.value < value), stopAt(fog, value)];
  return [[...before, { value, color, opacity: 1 }], referenceLength];
}

/** What a transfer function shows at a value, as a stop. */
function stopAt(transferFunction: TransferFunction, value: number): Stop {
  const [red, green, blue, opacity] = evaluate(transferFunction, value);
  const scale = opacity > 0 ? 1 / opacity : 0;
  return { value, color: [red * scale, green * scale, blue * scale], opacity };
}
