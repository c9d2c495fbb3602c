// Where the texts of notes stand over a picture: in columns at its sides, so that none covers another, nor a pin. Pixels are CSS pixels from
// the left and top edge of the picture.
import type { Pixel } from '../camera/drag-place.ts';
import { avoidPins, countFree } from './avoid-pins.ts';
import type { Interval } from './avoid-pins.ts';

/** A note over a picture. */
export interface PlacedNote {
  /** Where the picture shows its place; null where it does not. */
  readonly anchor: Pixel | null;
  /** Width of its text. */
  readonly width: number;
  /** Whether its place has no pin: texts may stand there. */
  readonly hasNoPin?: boolean;
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
  /** Whether texts cover pins: there is no room to keep them apart. */
  readonly isCrowded: boolean;
  readonly columns: readonly NoteColumn[];
}

/** Distance from text to text, and from a text to the edge of the picture. */
export const [gap, margin] = [4, 8];

/** Texts stay this far away from the middle of a pin. */
export const pinReach = 7;

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
 * Choose column and order. Notes stay on their side, and in their order, unless their places have changed clearly. There are numbers in place
 * of names where names have no room, or would cover pins.
 * @param before - the last order
 */
export function arrangeNotes(notes: readonly PlacedNote[], room: NoteRoom, before: NoteOrder | null = null): NoteOrder {
  const all = notes.flatMap(({ anchor }, i) => (anchor ? [i] : []));
  const pins = findPins(notes);
  const judge = (columns: readonly NoteColumn[], isShort: boolean): NoteOrder & { readonly covered: number } => {
    const order = { columns, isShort };
    const covered = columns.reduce((sum, column) => sum + aim(column, order, notes, { room, pins }).covered, 0);
    return { ...order, covered, isCrowded: covered > 0 };
  };
  const fits = all.length <= 2 * countRows(room) && columnsOf(room).maxWidth >= 3 * room.line;
  const names = fits ? judge(columnsOfNames(all, notes, room, before), false) : null;
  if (names?.covered === 0) return names;
  const numbers = judge(columnsOfNumbers(all, notes, { room, pins }, before), true);
  return names && names.covered <= numbers.covered ? names : numbers;
}

function columnsOfNames(
  all: readonly number[],
  notes: readonly PlacedNote[],
  room: NoteRoom,
  before: NoteOrder | null,
): NoteColumn[] {
  const { maxWidth, left } = columnsOf(room);
  const rows = countRows(room);
  return divide(all, notes, room, { before, max: [rows, rows] }).flatMap((side, right) => {
    if (side.length === 0) return [];
    const width = Math.max(...side.map((i) => Math.min(notes[i].width, maxWidth)));
    const isRight = right === 1;
    return [{ left: isRight ? room.width - left - width : left, width, isRight, notes: order(side, notes, before) }];
  });
}

/** As many columns as the notes need where no number covers a pin; if there is no such room, as if there were no pins. */
function columnsOfNumbers(
  all: readonly number[],
  notes: readonly PlacedNote[],
  { room, pins }: Pinned,
  before: NoteOrder | null,
): NoteColumn[] {
  const { line } = room;
  const rows = countRows(room);
  const perSide = Math.max(0, Math.floor((room.width / 2 - margin) / (line + gap)));
  const leftOf = (column: number, isRight: boolean): number =>
    isRight ? room.width - margin - column * (line + gap) - line : margin + column * (line + gap);
  const [from, to] = boundsOf(1, room);
  const free = [false, true].map((isRight) =>
    Array.from({ length: perSide }, (_, column) => {
      const left = leftOf(column, isRight);
      return Math.min(rows, countFree(blockedBy(pins, left, left + line, line), { from, to, apart: line + gap }));
    }),
  );
  const full = [0, 1].map(() => Array.from({ length: perSide }, () => rows));
  const sum = (counts: readonly number[]): number => counts.reduce((a, b) => a + b, 0);
  const counts = sum(free.flat()) >= all.length ? free : full;
  const shown = all.slice(0, sum(counts.flat()));
  return divide(shown, notes, room, { before, max: [sum(counts[0]), sum(counts[1])] }).flatMap((side, right) => {
    const isRight = right === 1;
    return deal(order(side, notes, before), counts[right])
      .map((members, column) => ({
        left: leftOf(column, isRight),
        width: line,
        isRight,
        notes: members,
      }))
      .filter(({ notes: { length } }) => length > 0);
  });
}

/** Deal notes to as few columns as hold them, so that each column has some of every height. @param counts - how many a column holds */
function deal(notes: readonly number[], counts: readonly number[]): number[][] {
  let [used, held] = [0, 0];
  while (held < notes.length && used < counts.length) held += counts[used++];
  const columns = counts.slice(0, used).map((): number[] => []);
  notes.forEach((note, i) => {
    // The column that is farthest behind its share.
    const behind = columns.map(({ length }, at) =>
      length < counts[at] ? ((i + 1) * counts[at]) / held - length : -Infinity,
    );
    columns[behind.indexOf(Math.max(...behind))].push(note);
  });
  return columns;
}

/**
 * The order while the camera moves, when other notes are shown than before: those that stay keep column and order, those that are new
 * stand where there is room.
 * @param shown - whether a note is shown now
 */
export function updateOrder(
  before: NoteOrder,
  notes: readonly PlacedNote[],
  room: NoteRoom,
  shown: (note: number) => boolean,
): NoteOrder {
  const columns = before.columns.map((column) => ({ ...column, notes: column.notes.filter(shown) }));
  const known = new Set(columns.flatMap(({ notes: members }) => members));
  const rows = countRows(room);
  const { maxWidth, left: edge } = columnsOf(room);
  notes.forEach(({ anchor, width }, i) => {
    if (!anchor || known.has(i) || !shown(i)) return;
    const isRight = anchor[0] > room.width / 2;
    const own = before.isShort ? room.line : Math.min(width, maxWidth);
    const free = columns.filter((one) => one.isRight === isRight && one.notes.length < rows);
    let column = free.reduce<(typeof columns)[number] | undefined>(
      (best, one) => (best && best.notes.length <= one.notes.length ? best : one),
      undefined,
    );
    if (!column && rows > 0 && !columns.some((one) => one.isRight === isRight)) {
      const from = before.isShort ? margin : edge;
      column = { left: isRight ? room.width - from - own : from, width: own, isRight, notes: [] };
      columns.push(column);
    }
    if (!column) return;
    const at = column.notes.findIndex((one) => (notes[one].anchor?.[1] ?? 0) > anchor[1]);
    const members = [...column.notes];
    members.splice(at < 0 ? members.length : at, 0, i);
    const wide = Math.max(column.width, own);
    const wider = {
      ...column,
      width: wide,
      left: isRight ? column.left + column.width - wide : column.left,
      notes: members,
    };
    columns[columns.indexOf(column)] = wider;
  });
  return { ...before, columns };
}

/** The notes of the left side and those of the right one, at most `max` of them. */
function divide(
  shown: readonly number[],
  notes: readonly PlacedNote[],
  { width }: NoteRoom,
  { before, max }: { readonly before: NoteOrder | null; readonly max: readonly [number, number] },
): [number[], number[]] {
  const was = new Map(before?.columns.flatMap(({ notes: members, isRight }) => members.map((i) => [i, isRight])));
  const fromMiddle = (i: number): number => {
    const side = was.get(i);
    return notes[i].anchor![0] - width / 2 + (side === undefined ? 0 : (side ? 1 : -1) * sideSlack * width);
  };
  const sorted = [...shown];
  sorted.sort((a, b) => fromMiddle(a) - fromMiddle(b) || a - b);
  const left = sorted.filter((i) => fromMiddle(i) < 0).length;
  const count = Math.max(sorted.length - max[1], Math.min(max[0], left));
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

/** A room with its pins. */
interface Pinned {
  readonly room: NoteRoom;
  readonly pins: readonly Pixel[];
}

/** The pins of a picture, from top to bottom. */
function findPins(notes: readonly PlacedNote[]): readonly Pixel[] {
  const pins = notes.flatMap(({ anchor, hasNoPin }) => (anchor && !hasNoPin ? [anchor] : []));
  pins.sort((a, b) => a[1] - b[1]);
  return pins;
}

/** Where tops of a text from `left` to `right` cover pins, from top to bottom. */
function blockedBy(pins: readonly Pixel[], left: number, right: number, line: number): Interval[] {
  return pins.flatMap(([x, y]): Interval[] =>
    x > left - pinReach && x < right + pinReach ? [[y - pinReach - line, y + pinReach]] : [],
  );
}

/** Top of the first of some texts: where it is highest, and where it is lowest. */
function boundsOf(count: number, { height, line, bottom = 0 }: NoteRoom): Interval {
  return [margin, Math.max(margin, height - bottom - margin - line - (count - 1) * (line + gap))];
}

/**
 * The tops of a column's texts: as near to the height of its place as the others and the pins allow.
 * @param last - the tops in the last picture
 */
function aim(
  { left, width, isRight, notes: members }: NoteColumn,
  { isShort }: Pick<NoteOrder, 'isShort'>,
  notes: readonly PlacedNote[],
  { room, pins, last }: Pinned & { readonly last?: ReadonlyMap<number, number> },
): { readonly tops: number[]; readonly covered: number } {
  const { line } = room;
  const apart = line + gap;
  const wanted = members.map((i) => (notes[i].anchor?.[1] ?? (last?.get(i) ?? 0) + line / 2) - line / 2);
  const shared = isShort ? blockedBy(pins, left, left + width, line) : null;
  const blocked = members.map((i) => {
    if (shared) return shared;
    const own = Math.min(notes[i].width, width);
    const from = isRight ? left + width - own : left;
    return blockedBy(pins, from, from + own, line);
  });
  const [from, to] = boundsOf(members.length, room);
  return avoidPins(spread(wanted, room), { wanted, blocked, from, to, apart, last: members.map((i) => last?.get(i)) });
}

/**
 * The top of each text, by the number of its note: as near to the height of its place as the others and the pins allow.
 * @param before - the tops in the last picture, and the places there: then no text moves farther than its place by more than `maxStep`, and
 * may cover a pin that passes it. A text without a last top has none until the others have made room for it
 */
export function placeNotes(
  order: NoteOrder,
  notes: readonly PlacedNote[],
  room: NoteRoom,
  before: { readonly tops: ReadonlyMap<number, number>; readonly anchors: readonly (Pixel | null)[] } | null = null,
): Map<number, number> {
  const tops = new Map<number, number>();
  const pins = findPins(notes);
  for (const column of order.columns) {
    const { notes: members } = column;
    const { tops: targets } = aim(column, order, notes, { room, pins, last: before?.tops });
    const from = members.map((i) => before?.tops.get(i));
    // Both the last tops and the targets keep their distances, and so does everything between them.
    const share = members.reduce((least, i, at) => {
      const last = from[at];
      if (last === undefined || !before) return least;
      const [now, then] = [notes[i].anchor, before.anchors[i]];
      const moved = now && then ? Math.hypot(now[0] - then[0], now[1] - then[1]) : 0;
      return Math.min(least, (moved + maxStep) / Math.max(moved + maxStep, Math.abs(targets[at] - last)));
    }, 1);
    members.forEach((i, at) => {
      const last = from[at];
      if (last !== undefined) tops.set(i, last + share * (targets[at] - last));
      // A new text comes when the others have made room for it.
      else if (share === 1) tops.set(i, targets[at]);
    });
  }
  return tops;
}

/**
 * Tops that keep their order and distance, stay in the picture, and are nearest to the wanted ones in the sense of least squares.
 * Source: pool adjacent violators, Ayer et al. 1955; bounds may be applied afterwards, Barlow et al. 1972
 */
function spread(wanted: readonly number[], room: NoteRoom): number[] {
  const apart = room.line + gap;
  const blocks: { sum: number; count: number }[] = [];
  wanted.forEach((top, i) => {
    let block = { sum: top - i * apart, count: 1 };
    for (let last = blocks.at(-1); last && last.sum / last.count > block.sum / block.count; last = blocks.at(-1)) {
      block = { sum: block.sum + last.sum, count: block.count + last.count };
      blocks.pop();
    }
    blocks.push(block);
  });
  const [from, to] = boundsOf(wanted.length, room);
  return blocks
    .flatMap(({ sum, count }) => Array.from({ length: count }, () => Math.min(to, Math.max(from, sum / count))))
    .map((top, i) => top + i * apart);
}
