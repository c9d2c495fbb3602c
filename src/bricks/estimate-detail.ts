// What coarse bricks do to a picture, estimated from what is known of them: rays are cast through what is resident, and at each step
// the values that the voxels may have there are put through the transfer function.
import { crossVolume, rayThrough } from '../optics/rays/rays.ts';
import type { RaySetup } from '../optics/rays/rays.ts';
import type { DetailField } from './detail-field.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { changeIn, hiddenChange, turnedLight } from './detail-light.ts';
import type { DetailLight } from './detail-light.ts';
import type { HiddenValues } from './hidden-values.ts';
import { meetPlane } from './painted-plane.ts';
import type { PaintedPlane } from './painted-plane.ts';
import { sumCount } from './span-sums.ts';
import type { SpanSums } from './span-sums.ts';
import { atOnce } from '../core/waiting.ts';
import type { Waiting } from '../core/waiting.ts';

/** What the estimate needs to know. */
export interface DetailScene {
  readonly field: DetailField;
  readonly rays: RaySetup;
  readonly sums: SpanSums;
  /** Length of a step in bounding diameters: the same as in the sums. */
  readonly step: number;
  /** The same in voxels of the finest level; 1 if undefined. */
  readonly voxels?: number;
  /** What is known of the values near a place. */
  readonly hidden: HiddenValues;
  /** Rays across and down. */
  readonly across: number;
  /** The finest level that counts, by a ray's parameter, see `levelOfPixels`: what is finer is neither missing nor asked for. Undefined: all counts. */
  readonly finestAt?: (t: number) => number;
  /** Whether a place of the unit cube is cut away; nothing is if undefined. */
  readonly isAway?: (x: number, y: number, z: number) => boolean;
  /** Opaque planes on which values are painted. */
  readonly planes?: readonly PaintedPlane[];
  /** Undefined: colours do not depend on the direction in which values change. */
  readonly light?: DetailLight;
  /** Shifts rays within their pixels, 0..1. */
  readonly shift?: readonly [number, number];
}

/** Receives what is found, for each cell that a ray meets. Energies are sums over rays and four channels of squared differences, 0..1. */
export interface DetailListener {
  /** How much less the energy is if the cell has this level instead of its present one. The finest level that counts comes first. */
  gain(cell: number, level: number, energy: number): void;
  /** How much more the energy would be if the cell's brick were not there; undefined if nobody asks. */
  loss?(cell: number, energy: number): void;
}

/** The estimate. */
export interface DetailEstimate {
  /** By cell * number of levels + level: how much less the energy is if the cell has this level; 0 from its present level on. */
  readonly gains: Float64Array;
  /** The root mean square of the differences over the rays that show something, in 1/255. */
  readonly rms: number;
}

/** A ray whose transmittance is below this shows nothing that comes behind. */
const opaque = 1e-3;

/** Share of a residual's variance that a few far values have: half of it, as measured in the bench. */
const farShare = 0.5;

/** Values pass through a narrow peak of the transfer function within so many voxels. */
const passed = 0.5;

/** Differences of a level that is made of noise go together over so many voxels, times 2^level. */
const correlated = 0.5;

/** Light is looked at where a step brings more than this to the eye. */
const leastLit = 0.01;

/** Estimates what the coarse bricks of a picture hide, and what finer ones would bring. @param cells - their number */
export function estimateDetail(scene: DetailScene, cells: number): DetailEstimate {
  const { levels } = scene.field;
  const gains = new Float64Array(cells * levels);
  const { rms } = atOnce(
    seekDetail(scene, { gain: (cell, level, energy) => (gains[cell * levels + level] += energy) }),
  );
  return { gains, rms };
}

/**
 * The same, with a pause after each row of rays.
 * @returns the differences over the rays that show something, in 1/255: their root mean square, and what 99 % of the rays stay below. A ray that shows nothing yet
 * counts by the opacity that is expected of it: empty pixels next to a thing would dilute what is wrong with it. And the finest level that counts anywhere, 0 where nothing shows.
 */
export function* seekDetail(
  scene: DetailScene,
  listener: DetailListener,
): Waiting<{ readonly rms: number; readonly p99: number; readonly finest: number }> {
  const { field, rays, step, across, shift = [0.5, 0.5] } = scene;
  const tracer = traceRays(scene, listener.loss !== undefined);
  const found: { readonly energy: number; readonly cover: number }[] = [];
  let finest = field.levels;
  for (let row = 0; row < across; row++) {
    for (let column = 0; column < across; column++) {
      const ray = rayThrough(rays, ((column + shift[0]) / across) * 2 - 1, 1 - ((row + shift[1]) / across) * 2);
      const [enter, exit] = crossVolume(rays, ray);
      const entry = Math.max(enter, rays.eyeT);
      if (!(exit > entry)) continue;
      const seen = tracer(ray, entry, exit, step / ray.lengthPerT);
      if (!seen) continue;
      finest = Math.min(finest, ...seen.finest);
      found.push({ energy: addGains(seen, field.levels, listener), cover: seen.cover });
    }
    yield;
  }
  const sum = found.reduce((all, { energy }) => all + energy, 0);
  const covered = found.reduce((all, { cover }) => all + cover, 0);
  found.sort((a, b) => b.energy - a.energy);
  let above = 0;
  const p99 = found.find(({ cover }) => (above += cover) > 0.01 * covered)?.energy ?? 0;
  const inBytes = (energy: number): number => Math.min(255, 255 * Math.sqrt(energy));
  // All of a ray's difference may be in one channel.
  return {
    rms: covered > 0 ? inBytes(sum / (4 * covered)) : 0,
    p99: inBytes(p99),
    finest: found.length > 0 ? finest : 0,
  };
}

/** What one ray says: for each cell that it meets, and each level up to its present one, its bias and its variance. */
interface RayDetail {
  readonly cells: readonly number[];
  readonly present: readonly number[];
  /** The finest level of each cell that counts. */
  readonly finest: readonly number[];
  /** The level of each cell without its brick. */
  readonly without: readonly number[];
  /** Whether it shows something, 1; else the opacity that is expected of it. */
  readonly cover: number;
  /** Cell by cell and level by level: four biases, then the sum of the variances of all channels. */
  readonly found: Float64Array;
}

const perLevel = 5;

/**
 * Biases of a ray's cells add up, variances do too. What a cell brings is the part of the ray's whole energy that goes with it.
 * @returns the energy of the ray
 */
function addGains(
  { cells, present, finest, without, found }: RayDetail,
  levels: number,
  listener: DetailListener,
): number {
  const total = new Float64Array(perLevel);
  cells.forEach((_, n) => {
    const at = (n * levels + present[n]) * perLevel;
    for (let c = 0; c < perLevel; c++) total[c] += found[at + c];
  });
  cells.forEach((cell, n) => {
    const now = (n * levels + present[n]) * perLevel;
    for (let level = finest[n]; level < present[n]; level++) {
      const then = (n * levels + level) * perLevel;
      let [shared, own] = [0, 0];
      for (let c = 0; c < 4; c++) {
        shared += (found[now + c] - found[then + c]) * total[c];
        own += found[now + c] ** 2 - found[then + c] ** 2;
      }
      listener.gain(cell, level, Math.max(0, found[now + 4] - found[then + 4] + Math.max(shared, own)));
    }
    if (!listener.loss || without[n] === present[n]) return;
    const next = (n * levels + without[n]) * perLevel;
    let more = found[next + 4] - found[now + 4];
    for (let c = 0; c < 4; c++) more += found[next + c] ** 2 - found[now + c] ** 2;
    listener.loss(cell, Math.max(0, more));
  });
  return total[4] + total[0] ** 2 + total[1] ** 2 + total[2] ** 2 + total[3] ** 2;
}

type Tracer = (
  ray: { readonly point: readonly number[]; readonly direction: readonly number[] },
  entry: number,
  exit: number,
  dt: number,
) => RayDetail | null;

/** The level of what is cut away. */
const cut = 255;

/** Steps of a ray; longer rays are cut. */
const maxSteps = 8192;

/**
 * Walks a ray twice: forward for what would reach the eye from each step if the hidden values were there, backward for what the resident
 * levels show behind it. With both, the differences of all steps add up to the difference of the two rays, however large it is:
 * C' - C = sum of T'_n (S'_n - S_n - (a'_n - a_n) B_n).
 * @param isLossAsked - the level that a cell would have without its brick is looked at too
 */
function traceRays(
  { field, sums, hidden, isAway, planes = [], light, finestAt = () => 0, voxels = 1 }: DetailScene,
  isLossAsked: boolean,
): Tracer {
  const { levels } = field;
  const levelWithout = (cell: number, level: number): number =>
    isLossAsked ? (field.levelWithout?.(cell) ?? Math.min(levels - 1, level + 1)) : level;
  const [values, visible] = [new Float64Array(maxSteps), new Float64Array(maxSteps)];
  const [shown, spreads] = [new Float64Array(4 * maxSteps), new Float64Array(sumCount * maxSteps)];
  const [cellOf, blockOf] = [new Int32Array(maxSteps), new Int32Array(maxSteps)];
  const [levelAt, dueAt] = [new Uint8Array(maxSteps), new Uint8Array(maxSteps)];
  const togetherAt = new Float64Array(maxSteps);
  /** How values change with a voxel, where that matters for light, else -1; and the cosine between that direction and the ray's. */
  const [changeAt, facingAt] = [new Float64Array(maxSteps), new Float64Array(maxSteps)];
  const [means, spread] = [new Float64Array(sumCount), new Float64Array(sumCount)];
  /** The step at which the ray ends on a plane, and what values look like on it. */
  let [planeStep, ofPlane] = [-1, sums];
  const correlationOf = (level: number): number => hidden.correlation?.(level) ?? correlated * 2 ** level;
  /**
   * What the hidden values of a level would show at a step.
   * @returns over how many voxels it goes together; 0 where the level hides nothing
   */
  const seeHidden = (n: number, level: number, into: Float64Array): number => {
    const [block, due] = [blockOf[n], dueAt[n]];
    if (level <= due) return 0;
    const [low, high, all] = [hidden.low(block), hidden.high(block), hidden.rms(block, level)];
    const rms = due > 0 ? Math.sqrt(Math.max(0, all ** 2 - hidden.rms(block, due) ** 2)) : all;
    const max = hidden.max(block, level) * (due > 0 && all > 0 ? rms / all : 1);
    if (!(max > 0) || !(low <= high)) return 0;
    // Where the resident level shows no data, the middle of what may be there stands for it.
    const center = Number.isNaN(values[n]) ? (low + high) / 2 : values[n];
    const previous = n > 0 && !Number.isNaN(values[n - 1]) ? values[n - 1] : center;
    if (n === planeStep) {
      // A single place: its difference is that of a whole voxel.
      meanOfHidden(ofPlane, { center, previous: center, rms, max, low, high }, into);
      return voxels;
    }
    const { linear, isPeaked } = meanOfHidden(sums, { center, previous, rms, max, low, high }, into);
    const least = isPeaked ? passed : 1;
    return least + linear * Math.max(0, correlationOf(level) - least);
  };
  const isPlaneShown = (plane: PaintedPlane, places: readonly Vector3[]): boolean => {
    const value = field.valueAt(...places[0]);
    if (Number.isNaN(value)) return false;
    // A plane on the face of a cut is there.
    if (isAway && places.every((place) => isAway(...place))) return false;
    return plane.sums.meanOpacity(value, value) > 0.5;
  };
  const levelAtPlace = (place: Vector3): number => field.levelOf(field.cellAt(...place));
  const coarsestOf = (places: readonly Vector3[]): Vector3 =>
    places.reduce((one, other) => (levelAtPlace(other) > levelAtPlace(one) ? other : one));
  return ({ point, direction }, entry, exit, dt) => {
    const plane = planes.length > 0 ? meetPlane(planes, { point, direction, entry, exit }, isPlaneShown) : null;
    const count = Math.min(maxSteps, plane ? Math.floor((plane.t - entry) / dt) + 1 : Math.ceil((exit - entry) / dt));
    planeStep = plane ? count - 1 : -1;
    ofPlane = plane?.plane.sums ?? sums;
    let [through, used, last, isShown] = [1, 0, NaN, false];
    for (; used < count && through > opaque; used++) {
      const isOnPlane = used === planeStep;
      const t = isOnPlane ? plane!.t : entry + (used + 0.5) * dt;
      const [x, y, z] = [point[0] + t * direction[0], point[1] + t * direction[1], point[2] + t * direction[2]];
      const isCut = !isOnPlane && isAway?.(x, y, z) === true;
      const value = isCut ? NaN : field.valueAt(x, y, z);
      // Where a plane lies between two cells, pixels may show either: the coarser one counts.
      const [atX, atY, atZ] = isOnPlane ? coarsestOf(plane!.places) : [x, y, z];
      const cell = field.cellAt(atX, atY, atZ);
      cellOf[used] = cell;
      blockOf[used] = hidden.blockAt(atX, atY, atZ);
      values[used] = value;
      visible[used] = through;
      means.fill(0);
      if (isOnPlane) ofPlane.addMeans(value, value, 1, means);
      else if (!Number.isNaN(value)) sums.addMeans(Number.isNaN(last) ? value : last, value, 1, means);
      for (let c = 0; c < 4; c++) shown[4 * used + c] = means[c];
      const level = isCut ? cut : field.levelOf(cell);
      levelAt[used] = level;
      dueAt[used] = finestAt(t);
      togetherAt[used] = isCut || level === 0 ? 0 : seeHidden(used, level, spread);
      if (togetherAt[used] === 0) spread.set(means);
      spreads.set(spread, sumCount * used);
      changeAt[used] = -1;
      if (light && !isOnPlane && !isCut && (level > 0 || isLossAsked) && through * spread[3] > leastLit)
        [changeAt[used], facingAt[used]] = changeIn(field, [x, y, z], direction, light);
      through *= 1 - spread[3];
      isShown ||= means[3] > 0;
      last = value;
    }
    const cover = isShown ? 1 : 1 - through;
    if (!(cover > 0)) return null;
    const cells: number[] = [];
    const present: number[] = [];
    const finest: number[] = [];
    const without: number[] = [];
    const found: number[] = [];
    const back = [0, 0, 0, 0];
    for (let n = used - 1; n >= 0; n--) {
      const cell = cellOf[n];
      const level = levelAt[n];
      const own = 4 * n;
      if (level !== cut && (level > 0 || isLossAsked)) {
        let slot = cells.length - 1;
        if (cells[slot] !== cell) {
          slot = cells.indexOf(cell);
          if (slot < 0) {
            slot = cells.push(cell) - 1;
            present.push(level);
            finest.push(levels);
            without.push(levelWithout(cell, level));
            for (let i = 0; i < levels * perLevel; i++) found.push(0);
          }
        }
        finest[slot] = Math.min(finest[slot], dueAt[n]);
        for (let at = 1; at <= without[slot]; at++) {
          if (at > level && at < without[slot]) continue;
          const together = at === level ? togetherAt[n] : seeHidden(n, at, spread);
          if (together === 0) continue;
          if (at === level) spread.set(spreads.subarray(sumCount * n, sumCount * (n + 1)));
          const start = (slot * levels + at) * perLevel;
          const more = spread[3] - shown[own + 3];
          let variance = 0;
          for (let c = 0; c < 4; c++) {
            found[start + c] += visible[n] * (spread[c] - shown[own + c] - more * back[c]);
            // The variance of colour - opacity * what is behind.
            const product = c < 3 ? spread[8 + c] : spread[7];
            const square = spread[4 + c] - 2 * back[c] * product + back[c] ** 2 * spread[7];
            variance += Math.max(0, square - (spread[c] - back[c] * spread[3]) ** 2);
          }
          found[start + 4] += visible[n] ** 2 * variance * (together / voxels);
          if (changeAt[n] < 0) continue;
          const ratio = hiddenChange(hidden, blockOf[n], dueAt[n], at) / Math.max(changeAt[n], 1e-30);
          const { darker, variance: ofLight } = turnedLight(facingAt[n], Math.min(1e3, ratio));
          // Steps within the same surface have the same light.
          const same = Math.min(1 / spread[3], Math.max(1, 2 ** (at - 1) / voxels));
          for (let c = 0; c < 3; c++) {
            const lit = visible[n] * spread[c] * light!.diffuse;
            found[start + c] -= lit * darker;
            found[start + 4] += lit ** 2 * ofLight * same;
          }
        }
      }
      for (let c = 0; c < 4; c++) back[c] = shown[own + c] + (1 - shown[own + 3]) * back[c];
    }
    return { cells, present, finest, without, cover, found: Float64Array.from(found) };
  };
}

/**
 * Means over the values that voxels may have where a level shows `center`: two boxes around it, a wide one up to the largest residual, and a
 * narrow one for the rest of the variance.
 * @returns the share of the opacity's variance that is linear in the value, 0..1: it goes together as far as values do, the rest less; and whether the opacity is
 * lower at both ends of the values, so that rays pass through a peak
 */
function meanOfHidden(
  sums: SpanSums,
  {
    center,
    previous,
    rms,
    max,
    low,
    high,
  }: {
    readonly center: number;
    readonly previous: number;
    readonly rms: number;
    readonly max: number;
    readonly low: number;
    readonly high: number;
  },
  into: Float64Array,
): { readonly linear: number; readonly isPeaked: boolean } {
  const clamp = (value: number): number => Math.min(high, Math.max(low, value));
  const far = Math.min(0.5, (3 * farShare * rms ** 2) / max ** 2);
  const width = Math.sqrt((3 * Math.max(0, rms ** 2 - (far * max ** 2) / 3)) / (1 - far));
  const [from, to] = [Math.min(previous, center), Math.max(previous, center)];
  into.fill(0);
  sums.addMeans(clamp(center - max), clamp(center + max), far, into);
  sums.addMeans(clamp(from - width), clamp(to + width), 1 - far, into);
  const middle = (from + to) / 2;
  const half = (to - from) / 2 + width;
  const slopeOf = (at: number, reach: number): number =>
    sums.meanOpacity(at, clamp(at + reach)) - sums.meanOpacity(clamp(at - reach), at);
  const together = (far * max * slopeOf(center, max) + (1 - far) * half * slopeOf(middle, half)) / 3;
  const variance = (far * max ** 2 + (1 - far) * half ** 2) / 3;
  const ofOpacity = into[7] - into[3] ** 2;
  const opacityAt = (value: number): number => sums.meanOpacity(clamp(value), clamp(value));
  return {
    linear: ofOpacity > 1e-12 && variance > 0 ? Math.min(1, together ** 2 / (variance * ofOpacity)) : 1,
    isPeaked: into[3] > Math.max(opacityAt(center - max), opacityAt(center + max)),
  };
}
