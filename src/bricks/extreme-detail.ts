// What coarse bricks do to rays that show their largest value, or their smallest: how likely it is that another value is the largest one, and what that would look like.
import type { DetailListener, DetailScene, RayEstimate } from './detail-scene.ts';
import { walker } from './extreme-steps.ts';
import type { Found, Look, Spread, Step } from './extreme-steps.ts';
import { firstShown, weighFirst } from './first-extreme.ts';
import { meanOfHidden, spreadAt } from './hidden-means.ts';
import { planeFinder } from './painted-plane.ts';
import type { PlaneMeeting } from './painted-plane.ts';
import { sumCount } from './span-sums.ts';

/** The range in which the largest value may lie is divided into so many parts. */
const bins = 16;

/** Of a probability of 0, for sums. */
const never = -30;

/** What a cell has on a ray: by edge of the bins, the logarithm of the probability that no value in it is larger. */
interface CellChance {
  readonly steps: Step[];
  readonly now: Float64Array;
  readonly without: Float64Array;
}

/** Twin of `estimateSeen` for `ExtremeLook`. @param isLossAsked - the level that a cell would have without its brick is looked at too */
export function estimateExtremes(scene: DetailScene, isLossAsked: boolean): RayEstimate {
  const { field, planes = [], isAway } = scene;
  const { sign, colorOf, threshold } = scene.extreme!;
  const walk = walker(scene, isLossAsked);
  const meet = planeFinder(field, planes, isAway);
  let number = 0;
  return (ray, listener) => {
    const plane = meet?.(ray) ?? null;
    const steps = walk(plane ? { ...ray, exit: plane.t } : ray);
    if (steps.length === 0 && !plane) return null;
    const behind = plane ? seePlane(plane, scene) : null;
    const lookOf: Look = (value) => {
      const color = value === -Infinity ? [0, 0, 0, 0] : colorOf(sign * value);
      return behind ? color.map((x, c) => x + (1 - color[3]) * behind.shown[c]) : color;
    };
    const first = threshold === undefined ? null : firstShown(steps, threshold);
    const shown = first ? first.value : steps.reduce((most, { value }) => Math.max(most, value), -Infinity);
    const found = first
      ? weighFirst(steps, { threshold: threshold!, shown: first, number: number++ }, lookOf)
      : weigh(steps, shown, lookOf);
    const through = behind ? 1 - (shown === -Infinity ? 0 : colorOf(sign * shown)[3]) : 0;
    const ofPlane = behind ? through ** 2 * behind.energy : 0;
    report(found, scene, listener);
    if (behind && ofPlane > 0)
      for (let level = behind.due; level < behind.level; level++) listener.gain(behind.cell, level, ofPlane);
    if (!(found.cover > 0)) return null;
    const finest = steps.reduce((least, { due }) => Math.min(least, due), behind?.due ?? field.levels);
    return { energy: found.energy + ofPlane, cover: found.cover, finest };
  };
}

/** Logarithm of the probability that none of a step's values is above x. */
function chanceBelow(x: number, { center, low, high, max, width, peaks, draws, peakDraws }: Spread): number {
  if (x >= high) return 0;
  if (x < low) return never;
  const inBox = (half: number): number =>
    half > 0 ? Math.min(1, Math.max(0, (x - center + half) / (2 * half))) : Number(x >= center);
  const t = max > 0 ? Math.min(1, Math.abs(x - center) / max) : 1;
  const beyond = peaks * (t > 0 ? 1 - t + t * Math.log(t) : 1);
  const inside = inBox(width);
  if (!(inside > 0)) return never;
  return Math.max(never, draws * Math.log(inside) + (x >= center ? peakDraws * Math.log1p(-beyond) : 0));
}

/** What is expected of a ray whose largest value is `shown`. */
function weigh(steps: readonly Step[], shown: number, lookOf: Look): Found {
  const looksNow = lookOf(shown);
  const difference = (value: number): number => lookOf(value).reduce((sum, x, c) => sum + (x - looksNow[c]) ** 2, 0);
  const isSeen = looksNow[3] > 0;
  // Below the floor the largest value can't be: some are known, and others can't be lower.
  const leastOf = ({ low, center, max }: Spread): number => Math.max(low, center - max);
  const mostOf = ({ high, center, max }: Spread): number => Math.min(high, center + max);
  let [floor, top] = [-Infinity, -Infinity];
  for (const { value, now, without } of steps) {
    floor = Math.max(floor, now ? leastOf(now) : value);
    if (now) top = Math.max(top, mostOf(now));
    if (without) top = Math.max(top, mostOf(without));
  }
  if (!(top > floor) || floor === -Infinity) return { energy: 0, cover: Number(isSeen), cells: [] };
  const edges = Array.from({ length: bins + 1 }, (_, k) => floor + (k / bins) * (top - floor));
  const chances = new Map<number, CellChance>();
  const all = new Float64Array(bins + 1);
  for (const step of steps) {
    let chance = chances.get(step.cell);
    if (!chance) {
      chance = { steps: [], now: new Float64Array(bins + 1), without: new Float64Array(bins + 1) };
      chances.set(step.cell, chance);
    }
    chance.steps.push(step);
    for (const [spread, into] of [
      [step.now, chance.now],
      [step.without, chance.without],
    ] as const)
      if (spread && mostOf(spread) > floor) edges.forEach((x, k) => (into[k] += chanceBelow(x, spread)));
  }
  for (const { now } of chances.values()) now.forEach((log, k) => (all[k] += log));
  const middles = Array.from({ length: bins }, (_, k) => (edges[k] + edges[k + 1]) / 2);
  const differences = middles.map(difference);
  const ofFloor = difference(floor);
  const chanceOf = (k: number, logs: ArrayLike<number> = all): number => Math.exp(logs[k + 1]) - Math.exp(logs[k]);
  const holder = steps.find(({ value }) => value === shown)?.cell;
  const energies = new Map<number, number>();
  const give = (cell: number | undefined, energy: number): void => {
    if (cell !== undefined && energy > 0) energies.set(cell, (energies.get(cell) ?? 0) + energy);
  };
  let energy = Math.exp(all[0]) * ofFloor;
  let cover = isSeen ? 1 : Math.exp(all[0]) * lookOf(floor)[3];
  give(holder, energy);
  for (let k = 0; k < bins; k++) {
    const share = chanceOf(k);
    if (!(share > 0)) continue;
    energy += share * differences[k];
    if (!isSeen) cover += share * lookOf(middles[k])[3];
    // The largest value is lower than it looks: that is due to the cell in which it seems to be.
    if (middles[k] <= shown) give(holder, share * differences[k]);
    else
      for (const [cell, { now }] of chances)
        give(cell, (share * differences[k] * (now[k + 1] - now[k])) / (all[k + 1] - all[k]));
  }
  /** The energy without the brick of a cell. @param others - the largest value elsewhere */
  const energyWithout = (cell: number, { now, without, steps: own }: CellChance, others: number): number => {
    if (own.every((step) => step.without === step.now)) return energy;
    const logs = all.map((log, k) => log - now[k] + without[k]);
    const lower = Math.max(others, shown - Math.max(0, ...own.map((step) => step.without?.width ?? 0)));
    const ofHolder = cell === holder ? difference(lower) : ofFloor;
    return differences.reduce((sum, e, k) => sum + e * chanceOf(k, logs), Math.exp(logs[0]) * ofHolder);
  };
  const cells = [...chances].map(([cell, chance]) => {
    const others = steps.reduce((most, step) => (step.cell === cell ? most : Math.max(most, step.value)), -Infinity);
    return {
      steps: chance.steps,
      energy: energies.get(cell) ?? 0,
      loss: Math.max(0, energyWithout(cell, chance, others) - energy),
    };
  });
  return { energy, cover, cells };
}

/** Says what finer levels of the cells bring, and what their bricks are worth. */
function report({ cells }: Found, { hidden }: DetailScene, listener: DetailListener): void {
  for (const { steps, energy, loss } of cells) {
    const [{ cell, level, block, due }] = steps;
    for (let finer = due; finer < level; finer++) {
      const left = finer > due ? (hidden.rms(block, finer) / hidden.rms(block, level)) ** 2 : 0;
      if (energy > 0) listener.gain(cell, finer, energy * Math.max(0, 1 - left));
    }
    if (loss > 0) listener.loss?.(cell, loss);
  }
}

/** What a plane behind the values shows, and what is hidden of it. */
function seePlane(
  { plane: { sums }, places: [place], coarsest, t }: PlaneMeeting & { readonly coarsest: readonly number[] },
  { field, hidden, finestAt = () => 0 }: DetailScene,
): {
  readonly shown: Float64Array;
  readonly energy: number;
  readonly cell: number;
  readonly level: number;
  readonly due: number;
} {
  const value = field.valueAt(...place);
  const [shown, means] = [new Float64Array(sumCount), new Float64Array(sumCount)];
  sums.addMeans(value, value, 1, shown);
  const [x, y, z] = coarsest;
  const cell = field.cellAt(x, y, z);
  const [level, due] = [field.levelOf(cell), finestAt(t)];
  const spread = spreadAt(hidden, hidden.blockAt(x, y, z), { value, due, level });
  let energy = 0;
  if (spread) {
    meanOfHidden(sums, spread, spread.center, means);
    for (let c = 0; c < 4; c++) energy += (means[c] - shown[c]) ** 2 + Math.max(0, means[4 + c] - means[c] ** 2);
  }
  return { shown, energy, cell, level, due };
}
