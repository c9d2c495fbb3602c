// What coarse bricks do to what rays show of all values: emission and absorption, values on planes, light.
import { add, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { levelWithoutBrick } from './detail-field.ts';
import { changeAlong, changeIn, hiddenChange, turnedLight } from './detail-light.ts';
import { maxSteps } from './detail-scene.ts';
import type { DetailListener, DetailRay, DetailScene, RayEstimate } from './detail-scene.ts';
import { meanOfHidden, spreadAt } from './hidden-means.ts';
import { planeFinder } from './painted-plane.ts';
import { sumCount } from './span-sums.ts';
import type { SpanSums } from './span-sums.ts';
import { addStyled, anyChange, stepMeans } from './steep-looks.ts';
import type { AddedChange } from './steep-looks.ts';

/** A ray whose transmittance is below this shows nothing that comes behind. */
const opaque = 1e-3;

/** Values pass through a narrow peak of the transfer function within so many voxels. */
const passed = 0.25;

/** Differences of a level that is made of noise go together over so many voxels, times 2^level. */
const correlated = 0.5;

/** Light is looked at where a step brings more than this to the eye. */
const leastLit = 0.01;

/** How values change is looked at where a step is more opaque than this, or could bring more than this to the eye. */
const leastSteep = 0.001;

/** For each cell that a ray meets, and each level up to its present one, its bias and its variance. */
interface FoundCells {
  readonly cells: readonly number[];
  readonly present: readonly number[];
  /** The finest level of each cell that counts. */
  readonly finest: readonly number[];
  /** The level of each cell without its brick. */
  readonly without: readonly number[];
  /** Cell by cell and level by level: four biases, then the sum of the variances of all channels. */
  readonly found: Float64Array;
}

const perLevel = 5;

/**
 * Biases of a ray's cells add up, variances do too. What a cell brings is the part of the ray's whole energy that goes with it.
 * @returns the energy of the ray
 */
function addGains(
  { cells, present, finest, without, found }: FoundCells,
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

/** The level of what is cut away. */
const cut = 255;

/**
 * Walks a ray twice: forward for what would reach the eye from each step if the hidden values were there, backward for what the resident
 * levels show behind it. With both, the differences of all steps add up to the difference of the two rays, however large it is:
 * C' - C = sum of T'_n (S'_n - S_n - (a'_n - a_n) B_n).
 * @param isLossAsked - the level that a cell would have without its brick is looked at too
 */
export function estimateSeen(
  { field, sums, hidden, isAway, planes = [], light, steep, finestAt = () => 0, voxels = 1 }: DetailScene,
  isLossAsked: boolean,
): RayEstimate {
  const { levels } = field;
  const levelWithout = levelWithoutBrick(field, isLossAsked);
  const [values, visible] = [new Float64Array(maxSteps), new Float64Array(maxSteps)];
  const [shown, spreads] = [new Float64Array(4 * maxSteps), new Float64Array(sumCount * maxSteps)];
  const [cellOf, blockOf] = [new Int32Array(maxSteps), new Int32Array(maxSteps)];
  const [levelAt, dueAt] = [new Uint8Array(maxSteps), new Uint8Array(maxSteps)];
  const togetherAt = new Float64Array(maxSteps);
  /** How values change with a voxel, where that matters for light, else -1; and the cosine between that direction and the ray's. */
  const [changeAt, facingAt] = [new Float64Array(maxSteps), new Float64Array(maxSteps)];
  const [means, spread, plain] = [new Float64Array(sumCount), new Float64Array(sumCount), new Float64Array(sumCount)];
  /** Places of the steps; and how values change there, where `isSteep` says that it is known. */
  const [places, changes] = [new Float64Array(3 * maxSteps), new Float64Array(3 * maxSteps)];
  const isSteep = new Uint8Array(maxSteps);
  let current: DetailRay;
  /** The step at which the ray ends on a plane, and what values look like on it. */
  let [planeStep, ofPlane] = [-1, sums];
  const correlationOf = (level: number): number => hidden.correlation?.(level) ?? correlated * 2 ** level;
  const threeOf = (of: Float64Array, n: number): Vector3 => [of[3 * n], of[3 * n + 1], of[3 * n + 2]];
  const changeOf = (n: number): Vector3 => {
    if (isSteep[n] === 0) changes.set(changeAlong(field, threeOf(places, n), steep!.voxel), 3 * n);
    isSteep[n] = 1;
    return threeOf(changes, n);
  };
  /** Adds what values show that change by any of these. @param see - what they show by sums, before styles */
  const addSteep = (
    n: number,
    changes: readonly AddedChange[],
    see: (sums: SpanSums, into: Float64Array) => void,
    into: Float64Array,
  ): void => {
    const { sumsOf, styleOf, ratio } = steep!;
    const place = threeOf(places, n);
    const addAll = (one: SpanSums, alike: readonly AddedChange[]): void => {
      see(one, plain);
      if (!(plain[3] > 0)) return;
      const step = stepMeans(plain, ratio);
      for (const { change, weight } of alike)
        addStyled(step, styleOf?.(current, place, change) ?? null, { ratio, weight }, into);
    };
    if (!sumsOf) return addAll(sums, changes);
    const sumsBy = changes.map(({ change }) => sumsOf(change));
    for (const one of new Set(sumsBy))
      addAll(
        one,
        changes.filter((_, i) => sumsBy[i] === one),
      );
  };
  /**
   * What the hidden values of a level would show at a step.
   * @returns over how many voxels it goes together; 0 where the level hides nothing
   */
  const seeHidden = (n: number, level: number, into: Float64Array): number => {
    const spread = spreadAt(hidden, blockOf[n], { value: values[n], due: dueAt[n], level });
    if (!spread) return 0;
    const { center } = spread;
    const previous = n > 0 && !Number.isNaN(values[n - 1]) ? values[n - 1] : center;
    if (n === planeStep) {
      // A single place: its difference is that of a whole voxel.
      meanOfHidden(ofPlane, spread, center, into);
      return voxels;
    }
    const { linear, isPeaked } = meanOfHidden(sums, spread, previous, into);
    if (steep) {
      // What nobody sees: its cost would be that of all else.
      if (visible[n] * into[3] < leastSteep) return 0;
      const [change, more] = [changeOf(n), hiddenChange(hidden, blockOf[n], dueAt[n], level)];
      const see = (by: SpanSums, into: Float64Array): unknown => meanOfHidden(by, spread, previous, into);
      into.fill(0);
      const all = anyChange.map((any) => ({ change: add(change, scale(any.change, more)), weight: any.weight }));
      addSteep(n, all, see, into);
    }
    const least = isPeaked ? passed : 1;
    return least + linear * Math.max(0, correlationOf(level) - least);
  };
  const meet = planeFinder(field, planes, isAway);
  return (ray, listener) => {
    const { point, direction, entry, exit, dt } = ray;
    current = ray;
    const plane = meet?.(ray) ?? null;
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
      const [atX, atY, atZ] = isOnPlane ? plane!.coarsest : [x, y, z];
      const cell = field.cellAt(atX, atY, atZ);
      cellOf[used] = cell;
      blockOf[used] = hidden.blockAt(atX, atY, atZ);
      values[used] = value;
      visible[used] = through;
      places.set([x, y, z], 3 * used);
      isSteep[used] = 0;
      means.fill(0);
      if (isOnPlane) ofPlane.addMeans(value, value, 1, means);
      else if (!Number.isNaN(value)) {
        const from = Number.isNaN(last) ? value : last;
        sums.addMeans(from, value, 1, means);
        if (steep && means[3] > leastSteep) {
          const see = (by: SpanSums, into: Float64Array): void => by.addMeans(from, value, 1, into.fill(0));
          means.fill(0);
          addSteep(used, [{ change: changeOf(used), weight: 1 }], see, means);
        }
      }
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
    const seen = { cells, present, finest, without, found: Float64Array.from(found) };
    return { energy: addGains(seen, levels, listener), cover, finest: Math.min(levels, ...finest) };
  };
}
