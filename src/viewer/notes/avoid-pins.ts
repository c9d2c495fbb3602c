// Tops of texts in a column, so that they keep their order and distance, and cover no pin where there is room.

/** From, to: pixels. */
export type Interval = readonly [number, number];

/** A column of texts. */
export interface TextColumn {
  /** Where each top would be if the text were alone. */
  readonly wanted: readonly number[];
  /** For each text, where its top makes it cover a pin: open intervals, one for each pin, from top to bottom. */
  readonly blocked: readonly (readonly Interval[])[];
  /** The highest top of the first text, and its lowest one that leaves room for the others. */
  readonly from: number;
  readonly to: number;
  /** Distance from top to top, at least. */
  readonly apart: number;
  /** The tops in the last picture, where they are known: a text does not go to the other side of a pin without need. */
  readonly last: readonly (number | undefined)[];
}

/** Places that are tried in a column, about one for each pixel. */
const maxPlaces = 1000;

/** Covering one pin costs more than any distance, pixels squared. */
const covering = 1e9;

/** Above and below a pin of its own, a text is equally near to it. It goes above: pixels. */
const lean = 3;

/** Less than this is rounding, pixels. */
const tiny = 1e-6;

const isBlocked = (intervals: readonly Interval[], top: number): boolean =>
  intervals.some(([a, b]) => top > a + tiny && top < b - tiny);

/**
 * @param spread - tops that ignore pins: they are kept where they cover none
 * @returns tops, from top to bottom, and how many texts cover a pin
 */
export function avoidPins(spread: number[], column: TextColumn): { readonly tops: number[]; readonly covered: number } {
  const { blocked } = column;
  const countCovered = (tops: readonly number[]): number => tops.filter((top, i) => isBlocked(blocked[i], top)).length;
  if (countCovered(spread) === 0) return { tops: spread, covered: 0 };
  const tops = slide(spread, choosePlaces(column), column);
  return { tops, covered: countCovered(tops) };
}

/**
 * How many texts have room above each other between pins, each with a pixel to spare, as tops are searched on a grid.
 * @param blocked - as in `TextColumn`
 * @param to - the lowest top of the last text
 */
export function countFree(
  blocked: readonly Interval[],
  { from, to, apart }: Pick<TextColumn, 'from' | 'to' | 'apart'>,
): number {
  let [count, next, top] = [0, 0, from];
  for (;;) {
    for (; next < blocked.length && blocked[next][0] - 1 < top; next++) top = Math.max(top, blocked[next][1]);
    if (top > to) return count;
    count++;
    top += apart;
  }
}

/** Tops on a grid of pixels that cover as few pins as possible, and among these are nearest to the wanted ones: dynamic programming. */
function choosePlaces({ wanted, blocked, from, to, apart, last }: TextColumn): number[] {
  // The n-th text is looked at `n * apart` higher, so that all have the same places, and none is above the one before it.
  const count = Math.max(1, Math.min(maxPlaces, Math.floor(to - from) + 1));
  const step = count > 1 ? (to - from) / (count - 1) : 0;
  let best = new Float64Array(count);
  const chosen: Uint16Array[] = [];
  wanted.forEach((top, n) => {
    const covers = countCovers(blocked[n], { from: from + n * apart, step, count });
    const costs = new Float64Array(count);
    const choice = new Uint16Array(count);
    let least = 0;
    for (let k = 0; k < count; k++) {
      const at = from + k * step + n * apart;
      if (best[k] < best[least]) least = k;
      choice[k] = least;
      costs[k] = best[least] + (at - top + lean) ** 2 + (at - (last[n] ?? at)) ** 2 + covering * covers[k];
    }
    best = costs;
    chosen.push(choice);
  });
  let k = best.indexOf(Math.min(...best));
  const places = chosen.map(() => 0);
  for (let n = places.length - 1; n >= 0; n--) {
    places[n] = from + k * step + n * apart;
    k = chosen[n][k];
  }
  return places;
}

/** How many pins a text covers at each place of a grid. */
function countCovers(
  blocked: readonly Interval[],
  { from, step, count }: { readonly from: number; readonly step: number; readonly count: number },
): Int32Array {
  const covers = new Int32Array(count + 1);
  const clamp = (place: number): number => Math.max(0, Math.min(count, place));
  for (const [a, b] of blocked) {
    // Without a step there is one place.
    const places = (at: number): number => (step > 0 ? (at - from) / step : at > from ? Infinity : -Infinity);
    covers[clamp(Math.floor(places(a + tiny)) + 1)]++;
    covers[clamp(Math.ceil(places(b - tiny)))]--;
  }
  for (let k = 1; k < count; k++) covers[k] += covers[k - 1];
  return covers;
}

/** Tops between the same pins as the chosen places, as near as possible to the tops that ignore pins. */
function slide(
  spread: readonly number[],
  places: readonly number[],
  { blocked, from, to, apart }: TextColumn,
): number[] {
  const bounds = places.map((place, n): Interval => {
    if (isBlocked(blocked[n], place)) return [place, place];
    const above = blocked[n].flatMap(([, b]) => (b <= place + tiny ? [b] : []));
    const below = blocked[n].flatMap(([a]) => (a >= place - tiny ? [a] : []));
    return [Math.max(from + n * apart, ...above), Math.min(to + n * apart, ...below)];
  });
  // Bounds that are in order leave tops in order. A text is not above the one before it, so bounds count for the texts after and before too.
  const highest: number[] = [];
  bounds.forEach(([a], n) => highest.push(Math.max(a, n > 0 ? highest[n - 1] + apart : a)));
  const lowest: number[] = [];
  for (let n = bounds.length - 1; n >= 0; n--)
    lowest[n] = Math.min(bounds[n][1], n + 1 < bounds.length ? lowest[n + 1] - apart : Infinity);
  return spread.map((top, n) => Math.min(lowest[n], Math.max(highest[n], top)));
}
