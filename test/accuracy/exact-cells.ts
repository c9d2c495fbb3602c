// Rays through a volume in float64, cell by cell: what a ray-caster with endlessly many steps would show.
import { opaqueExtinction } from '../../src/optics/transfer/emission.ts';
import { extinction } from '../../src/optics/transfer/opacity.ts';
import { crossVolume, rayThrough, setUpRays } from '../../src/optics/rays/rays.ts';
import type { Ray, RaySetup } from '../../src/optics/rays/rays.ts';
import type { Stop, TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import type { View } from '../../src/renderer/device/view.ts';
import type { Size } from '../../src/viewer/model/scene.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** What is cast. */
export interface ExactScene {
  /** On a cartesian grid, with data everywhere. */
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  /** World length. */
  readonly referenceLength: number;
}

/** Between two stops, or beyond all of them: no jump is in it. */
interface Piece {
  readonly from: Stop;
  readonly to: Stop;
}

/** Optical depth of the parts in which a ray is summed up, at the most. */
const finest = 0.02;

/** Parts of a way that is smooth, at least and at the most. */
const parts = [2, 96] as const;

/** What is left of the light behind this changes no byte. */
const nothing = 1e-6;

/**
 * Between planes of voxels' centres a tri-linear value is a polynomial of the third degree along a ray. So each piece of it is cut where values turn, and in what is left where
 * they pass the value of a stop, by bisection: no crossing can be missed, however short the way behind it is. Between two cuts nothing jumps.
 */
export class ExactCells {
  readonly #pieces: readonly Piece[];
  readonly #cuts: readonly number[];
  readonly #firstSeen: number;
  readonly #lastSeen: number;

  constructor(readonly scene: ExactScene) {
    const { transferFunction: stops } = scene;
    const [first, last] = [stops[0], stops[stops.length - 1]];
    this.#cuts = [...new Set(stops.map(({ value }) => value))];
    this.#pieces = [
      { from: first, to: first },
      ...this.#cuts.slice(1).map((value, i) => ({
        from: stops.filter((stop) => stop.value === this.#cuts[i]).at(-1)!,
        to: stops.find((stop) => stop.value === value)!,
      })),
      { from: last, to: last },
    ];
    const seen = this.#pieces.map(({ from, to }) => from.opacity > 0 || to.opacity > 0);
    const begin = seen.indexOf(true);
    const end = seen.lastIndexOf(true);
    this.#firstSeen = begin <= 0 ? (begin < 0 ? Infinity : -Infinity) : this.#cuts[begin - 1];
    this.#lastSeen = end === this.#pieces.length - 1 ? Infinity : (this.#cuts[end] ?? -Infinity);
  }

  /** All pixels of a view. @returns RGBA, premultiplied, 0..1, bottom row first; null where the grid is singular */
  draw({ view, projection }: View, { width, height }: Size): Float32Array | null {
    const setup = setUpRays(this.scene.volume.grid, view, projection);
    if (!setup) return null;
    const picture = new Float32Array(4 * width * height);
    for (let row = 0; row < height; row++) {
      for (let column = 0; column < width; column++) {
        picture.set(
          this.cast(setup, rayThrough(setup, (2 * (column + 0.5)) / width - 1, (2 * (row + 0.5)) / height - 1)),
          4 * (row * width + column),
        );
      }
    }
    return picture;
  }

  cast(setup: RaySetup, ray: Ray): [number, number, number, number] {
    const [from, exit] = crossVolume(setup, ray);
    const entry = Math.max(from, setup.eyeT);
    const color: [number, number, number, number] = [0, 0, 0, 0];
    if (!(exit > entry)) return color;
    const {
      volume: {
        grid: { dimensions },
        samples,
        slope,
        intercept,
      },
      referenceLength,
    } = this.scene;
    const [nx, ny, nz] = dimensions;
    const depthPerT = (ray.lengthPerT * setup.diameter) / referenceLength;
    // In voxels from the first one's centre.
    const origin = ray.point.map((x, axis) => x * dimensions[axis] - 0.5);
    const forward = ray.direction.map((x, axis) => x * dimensions[axis]);
    const next = [0, 1, 2].map((axis) => nextPlane(origin[axis], forward[axis], entry, dimensions[axis]));
    const corners = new Float64Array(8);
    const clamp = (i: number, n: number): number => (i < 0 ? 0 : i > n - 1 ? n - 1 : i);
    for (let t = entry; t < exit;) {
      const end = Math.min(exit, next[0].t, next[1].t, next[2].t);
      const middle = (t + end) / 2;
      const i = Math.floor(origin[0] + middle * forward[0]);
      const j = Math.floor(origin[1] + middle * forward[1]);
      const k = Math.floor(origin[2] + middle * forward[2]);
      let [min, max] = [Infinity, -Infinity];
      for (let corner = 0; corner < 8; corner++) {
        const at =
          clamp(i + (corner & 1), nx) + nx * (clamp(j + ((corner >> 1) & 1), ny) + ny * clamp(k + (corner >> 2), nz));
        const value = slope * samples[at] + intercept;
        corners[corner] = value;
        if (value < min) min = value;
        if (value > max) max = value;
      }
      if (max >= this.#firstSeen && min <= this.#lastSeen) {
        const valueAt = (share: number): number => {
          const at = t + share * (end - t);
          return interpolateCorners(
            corners,
            origin[0] + at * forward[0] - i,
            origin[1] + at * forward[1] - j,
            origin[2] + at * forward[2] - k,
          );
        };
        this.#addCell(
          color,
          cubicThrough(valueAt(0), valueAt(1 / 3), valueAt(2 / 3), valueAt(1)),
          (end - t) * depthPerT,
        );
        if (1 - color[3] < nothing) return color;
      }
      for (let axis = 0; axis < 3; axis++)
        if (next[axis].t <= end) next[axis] = nextPlane(origin[axis], forward[axis], end, dimensions[axis]);
      t = end;
    }
    return color;
  }

  /** @param length - of the cell's way, reference lengths */
  #addCell(color: number[], cubic: Cubic, length: number): void {
    const turns = [0, ...turnsOf(cubic), 1];
    for (let n = 1; n < turns.length; n++) {
      const [a, b] = [turns[n - 1], turns[n]];
      const [from, to] = [evaluateCubic(cubic, a), evaluateCubic(cubic, b)];
      const between = this.#cuts.filter((value) => value > Math.min(from, to) && value < Math.max(from, to));
      if (to < from) between.reverse();
      const places = [a, ...between.map((value) => findCrossing(cubic, a, b, value)), b];
      for (let m = 1; m < places.length; m++) this.#addSmooth(color, cubic, [places[m - 1], places[m]], length);
    }
  }

  #addSmooth(color: number[], cubic: Cubic, [from, to]: readonly [number, number], length: number): void {
    const span = (to - from) * length;
    if (!(span > 0)) return;
    const { from: low, to: high } = this.#pieceAt(evaluateCubic(cubic, (from + to) / 2));
    if (low.opacity === 0 && high.opacity === 0) return;
    const range = high.value - low.value;
    const opacityAt = (share: number): number => {
      const t =
        range > 0
          ? Math.min(1, Math.max(0, (evaluateCubic(cubic, from + share * (to - from)) - low.value) / range))
          : 0;
      return low.opacity + t * (high.opacity - low.opacity);
    };
    const thickest = Math.max(opacityAt(0), opacityAt(0.5), opacityAt(1));
    const isOneOpacity = low.opacity === high.opacity && low.color.every((x, c) => x === high.color[c]);
    const count = isOneOpacity
      ? 1
      : Math.min(
          parts[1],
          Math.max(parts[0], Math.ceil((Math.min(opaqueExtinction, extinction(thickest)) * span) / finest)),
        );
    for (let n = 0; n < count; n++) {
      const t =
        range > 0
          ? Math.min(
              1,
              Math.max(0, (evaluateCubic(cubic, from + ((n + 0.5) / count) * (to - from)) - low.value) / range),
            )
          : 0;
      const alpha = low.opacity + t * (high.opacity - low.opacity);
      if (!(alpha > 0)) continue;
      const seen = -Math.expm1((-Math.min(opaqueExtinction, extinction(alpha)) * span) / count);
      const visible = (1 - color[3]) * seen;
      for (let c = 0; c < 3; c++)
        color[c] += (visible * (low.color[c] * low.opacity * (1 - t) + high.color[c] * high.opacity * t)) / alpha;
      color[3] += visible;
      if (1 - color[3] < nothing) return;
    }
  }

  #pieceAt(value: number): Piece {
    let n = 0;
    while (n < this.#cuts.length && value >= this.#cuts[n]) n++;
    return this.#pieces[n];
  }
}

/** Coefficients of powers, from the third on. */
type Cubic = readonly [number, number, number, number];

function evaluateCubic([a, b, c, d]: Cubic, t: number): number {
  return ((a * t + b) * t + c) * t + d;
}

/** By its values at 0, 1/3, 2/3 and 1. */
function cubicThrough(p: number, q: number, r: number, s: number): Cubic {
  return [
    (9 * (3 * q - 3 * r - p + s)) / 2,
    (9 * (2 * p - 5 * q + 4 * r - s)) / 2,
    (-11 * p + 18 * q - 9 * r + 2 * s) / 2,
    p,
  ];
}

/** Where it turns, between 0 and 1, in order. */
function turnsOf([a, b, c]: Cubic): number[] {
  const inside = (t: number): boolean => t > 0 && t < 1;
  const [two, one] = [3 * a, 2 * b];
  const root = one * one - 4 * two * c;
  if (!(root > 0)) return two === 0 && one !== 0 ? [-c / one].filter(inside) : [];
  const q = -0.5 * (one + (one < 0 ? -1 : 1) * Math.sqrt(root));
  const turns = [q / two, c / q].filter(inside);
  turns.sort((x, y) => x - y);
  return turns;
}

const bisections = 48;

/** Where it has a value that is between those at both ends of a way on which it does not turn. */
function findCrossing(cubic: Cubic, from: number, to: number, value: number): number {
  const isBelow = evaluateCubic(cubic, from) < value;
  let [a, b] = [from, to];
  for (let i = 0; i < bisections; i++) {
    const middle = (a + b) / 2;
    if (evaluateCubic(cubic, middle) < value === isBelow) a = middle;
    else b = middle;
  }
  return b;
}

function interpolateCorners(corners: Float64Array, x: number, y: number, z: number): number {
  const row = (at: number): number => corners[at] + x * (corners[at + 1] - corners[at]);
  const plane = (at: number): number => {
    const below = row(at);
    return below + y * (row(at + 2) - below);
  };
  const front = plane(0);
  return front + z * (plane(4) - front);
}

/** Where a ray passes the next plane of voxels' centres along an axis. */
function nextPlane(origin: number, forward: number, after: number, count: number): { readonly t: number } {
  if (forward === 0) return { t: Infinity };
  const place = origin + after * forward;
  // A place on a plane may be a little before it.
  let plane = forward > 0 ? Math.floor(place + 1e-9) + 1 : Math.ceil(place - 1e-9) - 1;
  plane = forward > 0 ? Math.max(0, plane) : Math.min(count - 1, plane);
  const isBeyond = forward > 0 ? plane > count - 1 : plane < 0;
  return { t: isBeyond ? Infinity : (plane - origin) / forward };
}
