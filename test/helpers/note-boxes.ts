// Boxes of the texts of notes, and what is wrong with them.
import type { NoteOrder, NoteRoom, PlacedNote } from '../../src/viewer/notes/layout-notes.ts';

export interface TextBox {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Half the width of a pin, with its edge. */
const pinRadius = 6;

export function textBoxes(
  { columns, isShort }: NoteOrder,
  tops: ReadonlyMap<number, number>,
  notes: readonly PlacedNote[],
  room: NoteRoom,
): Map<number, TextBox> {
  const boxes = new Map<number, TextBox>();
  for (const { notes: members, left, width, isRight } of columns)
    for (const i of members) {
      const own = isShort ? room.line : Math.min(width, notes[i].width);
      const from = isRight ? left + width - own : left;
      boxes.set(i, { left: from, right: from + own, top: tops.get(i)!, bottom: tops.get(i)! + room.line });
    }
  return boxes;
}

/** Texts that cover another one, or are not inside the picture. */
export function findProblems(boxes: ReadonlyMap<number, TextBox>, { width, height }: NoteRoom): TextBox[] {
  const all = [...boxes.values()];
  const slack = 1e-6;
  return all.filter(
    (a, i) =>
      Math.min(a.left, a.top) < -slack ||
      a.right > width + slack ||
      a.bottom > height + slack ||
      all
        .slice(0, i)
        .some(
          (b) =>
            a.left < b.right - slack &&
            b.left < a.right - slack &&
            a.top < b.bottom - slack &&
            b.top < a.bottom - slack,
        ),
  );
}

/** Notes whose texts cover a pin, their own or another's. */
export function findCoveredPins(boxes: ReadonlyMap<number, TextBox>, notes: readonly PlacedNote[]): number[] {
  return [...boxes].flatMap(([i, { left, right, top, bottom }]) =>
    notes.some(
      ({ anchor, hasNoPin }) =>
        anchor &&
        !hasNoPin &&
        anchor[0] > left - pinRadius &&
        anchor[0] < right + pinRadius &&
        anchor[1] > top - pinRadius &&
        anchor[1] < bottom + pinRadius,
    )
      ? [i]
      : [],
  );
}
