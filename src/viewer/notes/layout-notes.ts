// Where the texts of notes stand over a picture: in columns at its sides, so that none covers another. Pixels are CSS pixels from the left
// and top edge of the picture.
import type { Pixel } from '../camera/drag-place.ts';

/** A note over a picture. */
export interface PlacedNote {
  /** Where the picture shows its place; null where it does not. */
  readonly anchor: Pixel | null;
  /** Width of its text. */
  readonly width: number;
}

/** What does not change from note to note. */
export interface NoteRoom {
  readonly width: number;
  readonly height: number;
  /** Height of a text, and width and height of a number. */
  readonly line: number;
  /** Height at the bottom that texts leave free, for controls; 0 where it is absent. */
  readonly bottom?: number;
}

/** One column of texts: the numbers of its notes, from top to bottom. */
export interface NoteColumn {
  /** Its left edge. */
  readonly left: number;
  readonly width: number;
  readonly isRight: boolean;
  readonly notes: readonly number[];
}

/** Which note stands in which column, above and below which others. */
export interface NoteOrder {
  /** Whether there is room for numbers only. */
  readonly isShort: boolean;
  readonly columns: readonly NoteColumn[];
}

/** Distance from text to text, and from a text to the edge of the picture. */
export const [gap, margin] = [4, 8];

/** Columns are no farther from each other than this, as a share of the height of the picture: leaders would be long in a wide one. */
const maxSpan = 1.7;

/** A note changes the side when its place is farther from the middle than this share of the width. */
const sideSlack = 0.06;

/** Neighbours change places when their places differ by more than this. */
const orderSlack = 6;

/** How far a text moves from picture to picture while the camera moves, in addition to how far its place moves. */
export const maxStep = 2;

/** How many texts stand in one column. */
function countRows({ height, line, bottom = 0 }: NoteRoom): number {
  return Math.max(0, Math.floor((height - bottom - 2 * margin + gap) / (line + gap)));
}

/** Widest text for which two columns have room, and left edge of the left column. */
export function columnsOf({ width, height }: NoteRoom): { readonly maxWidth: number; readonly left: number } {
  const span = Math.min(width, maxSpan * height);
  return { maxWidth: Math.max(0, span * 0.46 - margin), left: (width - span) / 2 + margin };
}

/**
 * Choose column and order. Notes stay on their side, and in their order, unless their places have changed clearly.
 * @param before - the last order
 */
export function arrangeNotes(notes: readonly PlacedNote[], room: NoteRoom, before: NoteOrder | null = null): NoteOrder {
  const rows = countRows(room);
  const { maxWidth, left } = columnsOf(room);
  const all = notes.flatMap(({ anchor }, i) => (anchor ? [i] : []));
  const isShort = all.length > 2 * rows || maxWidth < 3 * room.line;
  const sizeOf = (i: number): number => (isShort ? room.line : Math.min(notes[i].width, maxWidth));
  const perSide = isShort ? Math.max(0, Math.floor((room.width / 2 - margin) / (room.line + gap))) : 1;
  const shown = all.slice(0, 2 * perSide * rows);
  const sides = divide(shown, notes, room, { before, max: perSide * rows });
  const columns = sides.flatMap((side, isRight) => {
    const count = Math.ceil(side.length / Math.max(1, rows));
    const ordered = order(side, notes, before);
    return Array.from({ length: count }, (_, column): NoteColumn => {
      const members = ordered.filter((_, i) => i % count === column);
      const width = Math.max(...members.map(sizeOf));
      const from = (isShort ? margin : left) + column * (room.line + gap);
      return { left: isRight ? room.width - from - width : from, width, isRight: Boolean(isRight), notes: members };
    });
  });
  return { isShort, columns };
}

/** The notes of the left side and those of the right one, each at most `max`. */
function divide(
  shown: readonly number[],
  notes: readonly PlacedNote[],
  { width }: NoteRoom,
  { before, max }: { readonly before: NoteOrder | null; readonly max: number },
): [number[], number[]] {
  const was = new Map(before?.columns.flatMap(({ notes: members, isRight }) => members.map((i) => [i, isRight])));
  const fromMiddle = (i: number): number => {
    const side = was.get(i);
    return notes[i].anchor![0] - width / 2 + (side === undefined ? 0 : (side ? 1 : -1) * sideSlack * width);
  };
  const sorted = [...shown];
  sorted.sort((a, b) => fromMiddle(a) - fromMiddle(b) || a - b);
  const left = sorted.filter((i) => fromMiddle(i) < 0).length;
  const count = Math.max(sorted.length - max, Math.min(max, left));
  return [sorted.slice(0, count), sorted.slice(count)];
}

/** From top to bottom, as before where the places are almost as high. */
function order(side: readonly number[], notes: readonly PlacedNote[], before: NoteOrder | null): number[] {
  const rank = new Map(before?.columns.flatMap(({ notes: members }) => members.map((i, at) => [i, at])));
  const height = (i: number): number => notes[i].anchor![1];
  const known = side.filter((i) => rank.has(i));
  known.sort((a, b) => rank.get(a)! - rank.get(b)! || height(a) - height(b));
  const sorted: number[] = [];
  for (const i of [...known, ...side.filter((one) => !rank.has(one))]) {
    const slack = rank.has(i) ? orderSlack : 0;
    let at = sorted.length;
    while (at > 0 && height(sorted[at - 1]) > height(i) + slack) at--;
    sorted.splice(at, 0, i);
  }
  return sorted;
}

/**
 * The top of each text, by the number of its note: as near to the height of its place as the others allow.
 * @param before - the tops in the last picture, and the places there: then no text moves farther than its place by more than `maxStep`
 */
export function placeNotes(
  { columns }: NoteOrder,
  notes: readonly PlacedNote[],
  room: NoteRoom,
  before: { readonly tops: ReadonlyMap<number, number>; readonly anchors: readonly (Pixel | null)[] } | null = null,
): Map<number, number> {
  const tops = new Map<number, number>();
  for (const { notes: members } of columns) {
    const wanted = members.map(
      (i) => (notes[i].anchor?.[1] ?? (before?.tops.get(i) ?? 0) + room.line / 2) - room.line / 2,
    );
    const targets = spread(wanted, room);
    const from = members.map((i) => before?.tops.get(i));
    // Both the last tops and the targets keep their distances, and so does everything between them.
    const share = members.reduce((least, i, at) => {
      const last = from[at];
      if (last === undefined || !before) return least;
      const [now, then] = [notes[i].anchor, before.anchors[i]];
      const moved = now && then ? Math.hypot(now[0] - then[0], now[1] - then[1]) : 0;
      return Math.min(least, (moved + maxStep) / Math.max(moved + maxStep, Math.abs(targets[at] - last)));
    }, 1);
    members.forEach((i, at) =>
      tops.set(i, from[at] === undefined ? targets[at] : from[at] + share * (targets[at] - from[at])),
    );
  }
  return tops;
}

/**
 * Tops that keep their order and distance, stay in the picture, and are nearest to the wanted ones in the sense of least squares.
 * Source: pool adjacent violators, Ayer et al. 1955; bounds may be applied afterwards, Barlow et al. 1972
 */
function spread(wanted: readonly number[], { height, line, bottom = 0 }: NoteRoom): number[] {
  const apart = line + gap;
  const blocks: { sum: number; count: number }[] = [];
  wanted.forEach((top, i) => {
    let block = { sum: top - i * apart, count: 1 };
    for (let last = blocks.at(-1); last && last.sum / last.count > block.sum / block.count; last = blocks.at(-1)) {
      block = { sum: block.sum + last.sum, count: block.count + last.count };
      blocks.pop();
    }
    blocks.push(block);
  });
  const max = Math.max(margin, height - bottom - margin - line - (wanted.length - 1) * apart);
  return blocks
    .flatMap(({ sum, count }) => Array.from({ length: count }, () => Math.min(max, Math.max(margin, sum / count))))
    .map((top, i) => top + i * apart);
}
