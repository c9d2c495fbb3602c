import { unitToWorld } from '../../volume/grid.ts';
import { invertAffine, multiply, transformPoint } from '../../volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../volume/matrix.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Grid, Volume, VolumeData } from '../../volume/volume.ts';
import { brighten } from '../transfer/brighten.ts';
import { exactMeans } from '../transfer/exact-means.ts';
import { extinction } from '../transfer/opacity.ts';
import { cartesianField } from '../rays/ray-field.ts';
import type { FieldStage, RayStages, Sample, SecondFieldStage, Segment, ShadeStage } from '../rays/ray-stages.ts';
import { largestOpacity } from '../transfer/transfer-function.ts';
import type { Color, OpticalFactors, Premultiplied, TransferFunction } from '../transfer/transfer-function.ts';

/** How a second field joins the first: as a second medium in the same place, or as the colour of the first. */
export type OverlayBlend = 'mix' | 'color';

export const overlayBlends: readonly OverlayBlend[] = ['mix', 'color'];

/** A second field over a volume. */
export interface ShownOverlay {
  /** The layer's samples, on a grid of its own; or another moment of the same radar's gates. */
  readonly volume: Volume;
  /** The volume below the layer. A radar's moment belongs to one scan; any other layer belongs to a place in the world. */
  readonly over: VolumeData;
  readonly transferFunction: TransferFunction;
  readonly blend: OverlayBlend;
  /** Multiplies the layer's extinction, in addition to the picture's own factor. */
  readonly opacityFactor: number;
  /** The colour of the volume where the layer has no data; null for the volume's own colour. */
  readonly missing: Color | null;
}

/** A piece of a ray with a larger optical depth is opaque: float32 cannot distinguish larger depths. */
export const deepest = 12;

/** Where a layer ends together with the volume, rounding must not decide whether a ray's ends are inside. In shares of the layer's edges. */
export const edgeSlack = 1e-5;

/**
 * This opacity stands for the full colour of a layer. It is so small that extinction is proportional to it, and large enough
 * for a half float.
 */
const allOfColor = 0.004;

/** The colours of a layer's table. With the blend `color`, the largest opacity stands for the layer's full colour. */
export function overlayColors({ transferFunction, blend }: ShownOverlay, lightFactor: number): TransferFunction {
  const bright = brighten(transferFunction, lightFactor);
  if (blend === 'mix') return bright;
  const largest = largestOpacity(transferFunction);
  return bright.map((stop) => ({ ...stop, opacity: (stop.opacity / largest) * allOfColor }));
}

/** The extinction in the table that stands for the layer's full colour. */
export const fullColor = extinction(allOfColor);

/** Whether a layer belongs to a volume: the volume may have changed in the meantime. */
export function isOver({ over }: ShownOverlay, volume: VolumeData): boolean {
  if (volume === over) return true;
  if (isPolar(volume) || isPolar(over)) return false;
  const [a, b] = [over, volume].map(({ grid }) => unitToWorld(grid));
  return a.every((entry, i) => Math.abs(entry - b[i]) <= 1e-6 * Math.max(1, Math.abs(entry)));
}

/** Maps the volume's unit cube to the layer's; null if there is no such map. */
export function toOverlay(grid: Grid, overlay: Grid): Matrix4 | null {
  const back = invertAffine(unitToWorld(overlay));
  return back && multiply(back, unitToWorld(grid));
}

/** A sample of a volume that has a layer over it. */
export interface OverlaidSample extends Sample {
  /** Data value of the layer; NaN if it has none. */
  readonly overlay: number;
}

/** The field of a layer, by places of the volume's unit cube. Twin: shaders/chunks/attachments/overlay-cartesian.glsl */
export function cartesianOverlay({ volume, over }: ShownOverlay): FieldStage {
  const field = cartesianField({ ...volume, dimensions: volume.grid.dimensions });
  const toUnit = toOverlay(over.grid, volume.grid);
  return {
    sampleAt: (place) => {
      const there: Vector3 = toUnit ? transformPoint(toUnit, place) : [-1, -1, -1];
      return there.every((x) => x >= -edgeSlack && x <= 1 + edgeSlack)
        ? field.sampleAt(there)
        : { value: NaN, valid: false };
    },
    isFolded: () => false,
  };
}

/** Adds the layer's value to each sample. @param field - of the layer, by places of the volume's unit cube */
export function overlayField(field: FieldStage): SecondFieldStage {
  return (place, known) => {
    known.overlay = field.sampleAt(place).value;
    return known;
  };
}

/**
 * The stages that a layer adds to rays.
 * @param field - of the layer, by places of the volume's unit cube
 * @param optics - of the picture
 * @param diameter - of the rays: world length of one unit of a segment's span
 */
export function overlayStages(
  overlay: ShownOverlay,
  field: FieldStage,
  {
    optics,
    diameter,
  }: { readonly optics: OpticalFactors & { readonly referenceLength: number }; readonly diameter: number },
): Pick<RayStages, 'moreFields' | 'shades'> {
  return {
    moreFields: [overlayField(field)],
    shades: [
      overlayShade(overlay, field, {
        lightFactor: optics.lightFactor,
        opticalScale: (diameter * optics.opacityFactor * overlay.opacityFactor) / optics.referenceLength,
      }),
    ],
  };
}

/** Twin: overlayShade in shaders/chunks/attachments/overlay.glsl, which explains it. */
export function overlayShade(
  overlay: ShownOverlay,
  field: Pick<FieldStage, 'isFolded'>,
  { lightFactor, opticalScale }: { readonly lightFactor: number; readonly opticalScale: number },
): ShadeStage {
  const means = exactMeans(overlayColors(overlay, lightFactor));
  const appearance = (segment: Segment): { readonly mean: Premultiplied; readonly known: number } => {
    const [front, back] = [segment.front, segment.back].map((end) => (end as OverlaidSample).overlay);
    const known = (Number.isNaN(front) ? 0 : 0.5) + (Number.isNaN(back) ? 0 : 0.5);
    if (known === 0) return { mean: [0, 0, 0, 0], known };
    const [from, to] = [Number.isNaN(front) ? back : front, Number.isNaN(back) ? front : back];
    if (!field.isFolded(from, to)) return { mean: means.mean(from, to), known };
    const [near, far] = [means.mean(from, from), means.mean(to, to)];
    return { mean: near.map((x, c) => (x + far[c]) / 2) as Premultiplied, known };
  };
  return overlay.blend === 'mix'
    ? (segment, seen) => {
        const { mean, known } = appearance(segment);
        return mix(seen, mean, known * segment.span * opticalScale);
      }
    : (segment, seen) => {
        const { mean, known } = appearance(segment);
        return tint(seen, mean, { known, missing: overlay.missing });
      };
}

/** Adds the extinctions, and the light of both. @param ratio - this length, divided by the length to which the mean belongs */
function mix(seen: Premultiplied, mean: Premultiplied, ratio: number): Premultiplied {
  const depth = Math.min(deepest, mean[3] * ratio);
  if (!(depth > 0)) return seen;
  const before = Math.min(deepest, -Math.log1p(-seen[3]));
  const opacity = -Math.expm1(-(before + depth));
  const of = (c: number): number =>
    (opacity / (before + depth)) * ((seen[3] > 0 ? (before * seen[c]) / seen[3] : 0) + (depth * mean[c]) / mean[3]);
  return [of(0), of(1), of(2), opacity];
}

/** Keeps the volume's extinction, and gives it the layer's colour. */
function tint(
  seen: Premultiplied,
  mean: Premultiplied,
  { known, missing }: { readonly known: number; readonly missing: Color | null },
): Premultiplied {
  const own = known * Math.min(1, mean[3] / fullColor);
  const lacking = missing ? 1 - known : 0;
  const of = (c: number): number =>
    (1 - own - lacking) * seen[c] +
    seen[3] * ((own > 0 ? (own * mean[c]) / mean[3] : 0) + lacking * (missing?.[c] ?? 0));
  return [of(0), of(1), of(2), seen[3]];
}
