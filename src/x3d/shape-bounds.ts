import type { DeviceRectangle } from '../optics/cells/bound-seen-cells.ts';
import { multiply } from '../volume/matrix.ts';
import type { View } from '../renderer/layers/volume-layer.ts';
import type { Size } from '../renderer/passes/pass-drawing.ts';
import { toRowMajor } from './scene-camera.ts';
import type { X3dDrawable } from './x3dom-types.ts';

const wholePicture: DeviceRectangle = [-1, -1, 1, 1];

/** Corners nearer to the eye than this share of the farthest one's distance may be projected anywhere in the picture. */
const minDepth = 1e-3;

/** Lines are at most this wide, and polygons reach a little beyond their corners. Pixels. */
const margin = 16;

/**
 * Whether a shape consists of lines or points: it may be thinner than the distance of neighbouring rays when rays are
 * skipped.
 */
export function isThin({ shape }: X3dDrawable): boolean {
  const type = shape._webgl?.primType;
  return typeof type === 'number' && type < WebGLRenderingContext.TRIANGLES;
}

/** The part of a picture that may contain shapes; null if there are none. */
export function boundShapes(
  shapes: readonly X3dDrawable[],
  { view, projection }: View,
  { width, height }: Size,
): DeviceRectangle | null {
  if (shapes.length === 0) return null;
  const corners = shapes.map((drawable) => cornersOf(drawable));
  if (corners.includes(null)) return wholePicture;
  const toClip = multiply(projection, view);
  const places = corners.flatMap((some) => some!.map((corner) => applyTo(toClip, corner)));
  const depths = places.map(([, , , w]) => w);
  if (!(Math.min(...depths) > minDepth * Math.max(...depths))) return wholePicture;
  const end = (axis: 0 | 1, sign: 1 | -1, pixels: number): number =>
    sign * Math.min(1, Math.max(...places.map((place) => (sign * place[axis]) / place[3])) + (2 * margin) / pixels);
  return [end(0, -1, width), end(1, -1, height), end(0, 1, width), end(1, 1, height)];
}

/**
 * The corners of a shape's box in the world; null if the shape may reach beyond it: points have sizes, and shaders move
 * corners.
 */
function cornersOf({ shape, transform }: X3dDrawable): number[][] | null {
  const box = shape.getVolume();
  const isMoved =
    shape._webgl?.primType === WebGLRenderingContext.POINTS || Boolean(shape._cf.appearance?.node?._shader);
  if (isMoved || !box.isValid()) return null;
  const toWorld = toRowMajor(transform);
  const ends = [box.min, box.max];
  return Array.from({ length: 8 }, (_, i) =>
    applyTo(toWorld, [ends[i & 1].x, ends[(i >> 1) & 1].y, ends[i >> 2].z, 1]),
  );
}

function applyTo(m: readonly number[], p: readonly number[]): number[] {
  return [0, 4, 8, 12].map((row) => p.reduce((sum, x, column) => sum + m[row + column] * x, 0));
}
