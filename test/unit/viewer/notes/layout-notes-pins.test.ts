// No text covers a pin, its own or another's, where there is room.
import { expect } from '@esm-bundle/chai';
import type { Pixel } from '../../../../src/viewer/camera/drag-place.ts';
import { avoidPins, countFree } from '../../../../src/viewer/notes/avoid-pins.ts';
import { arrangeNotes, maxStep, placeNotes, updateOrder } from '../../../../src/viewer/notes/layout-notes.ts';
import type { NoteOrder, NoteRoom, PlacedNote } from '../../../../src/viewer/notes/layout-notes.ts';
import { findCoveredPins, findProblems, textBoxes } from '../../../helpers/note-boxes.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

function scatter(random: () => number, count: number, { width, height }: NoteRoom): PlacedNote[] {
  return Array.from({ length: count }, () => ({
    anchor: [width * random(), height * random()] as Pixel,
    width: 40 + 200 * random() ** 2,
  }));
}

function lay(notes: readonly PlacedNote[], room: NoteRoom): { order: NoteOrder; covered: number; problems: number } {
  const order = arrangeNotes(notes, room);
  const boxes = textBoxes(order, placeNotes(order, notes, room), notes, room);
  return { order, covered: findCoveredPins(boxes, notes).length, problems: findProblems(boxes, room).length };
}

describe('texts of notes and pins', () => {
  it('keep apart for random pins, 240 to 1600 px, 1 to 100 notes, unless the layout says that there is no room', () => {
    const random = randomNumbers(2024);
    let [crowded, crowdedFew] = [0, 0];
    const tries = 1200;
    for (let n = 0; n < tries; n++) {
      const width = Math.round(240 + 1360 * random() ** 2);
      const room: NoteRoom = {
        width,
        height: Math.round(width * (0.5 + 0.5 * random())),
        line: random() < 0.5 ? 24 : 28,
        bottom: random() < 0.5 ? 48 : 0,
      };
      const notes = scatter(random, 1 + Math.floor(100 * random() ** 2), room);
      const { order, covered, problems } = lay(notes, room);
      const what = JSON.stringify({ n, room, notes });
      expect(problems, what).to.equal(0);
      if (!order.isCrowded) expect(covered, what).to.equal(0);
      if (order.isCrowded) crowded++;
      // A number and its pin need about this area: with four times as much there is room.
      const area = (room.line + 4) ** 2 + (room.line + 14) ** 2;
      if (order.isCrowded && 4 * notes.length * area < width * (room.height - (room.bottom ?? 0))) crowdedFew++;
    }
    expect(crowdedFew).to.equal(0);
    expect(crowded / tries).to.be.below(0.3);
  });

  it('a narrow view has names where they leave the pins free, above or below', () => {
    // Five places of a brain at 390 pixels, as a page of the demos shows them.
    const room: NoteRoom = { width: 358, height: 300, line: 28, bottom: 48 };
    const notes: PlacedNote[] = [
      { anchor: [165, 128], width: 128 },
      { anchor: [186, 168], width: 90 },
      { anchor: [205, 235], width: 70 },
      { anchor: [262, 220], width: 104 },
      { anchor: [294, 150], width: 116 },
    ];
    const { order, covered, problems } = lay(notes, room);
    expect({ isShort: order.isShort, isCrowded: order.isCrowded, covered, problems }).to.deep.equal({
      isShort: false,
      isCrowded: false,
      covered: 0,
      problems: 0,
    });
  });

  it('a view without room for names between the pins has numbers', () => {
    const room: NoteRoom = { width: 300, height: 200, line: 28 };
    const notes = Array.from({ length: 12 }, (_, i): PlacedNote => ({
      anchor: [20 + 50 * (i % 3) + (i % 2 ? 150 : 0), 30 + 12 * i],
      width: 130,
    }));
    const { order, covered } = lay(notes, room);
    expect([order.isShort, order.isCrowded, covered]).to.deep.equal([true, false, 0]);
  });

  it('pins that are not shown take no room', () => {
    const room: NoteRoom = { width: 640, height: 480, line: 24 };
    const own: PlacedNote = { anchor: [320, 240], width: 100 };
    const other: PlacedNote = { anchor: [40, 240], width: 100, hasNoPin: true };
    const top = (notes: readonly PlacedNote[], before: readonly PlacedNote[]): number =>
      placeNotes(arrangeNotes(before, room), notes, room).get(0)!;
    expect(top([own, other], [own])).to.equal(228);
    expect(top([own, { ...other, hasNoPin: false }], [{ ...own, anchor: [300, 240] }])).to.not.be.within(210, 247);
  });

  it('stay steady while pins pass below them, and do not hop from one side of a pin to the other', () => {
    const room: NoteRoom = { width: 400, height: 300, line: 24 };
    const random = randomNumbers(9);
    const notes = scatter(random, 8, room);
    const order = arrangeNotes(notes, room);
    let [tops, before] = [placeNotes(order, notes, room), notes];
    let turns = 0;
    let directions = new Map<number, number>();
    for (let frame = 1; frame <= 600; frame++) {
      const now = notes.map(({ anchor, width }, i): PlacedNote => {
        const [x, y] = anchor!;
        return { width, anchor: [x + 60 * Math.sin(frame / 90 + i), y + 20 * Math.sin(frame / 150 + 2 * i)] };
      });
      const next = placeNotes(order, now, room, { tops, anchors: before.map(({ anchor }) => anchor) });
      const moves = new Map<number, number>();
      for (const [i, top] of next) {
        const moved = Math.hypot(...[0, 1].map((axis) => now[i].anchor![axis] - before[i].anchor![axis]));
        expect(Math.abs(top - tops.get(i)!)).to.be.at.most(moved + maxStep + 1e-9);
        moves.set(i, Math.sign(top - tops.get(i)!));
        if ((directions.get(i) ?? 0) * moves.get(i)! < 0) turns++;
      }
      expect(findProblems(textBoxes(order, next, now, room), room)).to.deep.equal([]);
      [tops, before, directions] = [next, now, moves];
    }
    // Each place goes down and up four times in these frames.
    expect(turns).to.be.below(8 * 10);
  });
});

describe('notes that come and go while the camera moves', () => {
  it('move no other text farther than its place by more than 2 px, cover none, and come when there is room', () => {
    const room: NoteRoom = { width: 640, height: 360, line: 24 };
    for (const seed of [1, 2, 3]) {
      const random = randomNumbers(seed);
      const all = scatter(random, 14, room);
      let shown = all.map(() => random() < 0.5);
      let before = all.map((note, i): PlacedNote => ({ ...note, anchor: shown[i] ? note.anchor : null }));
      let order = arrangeNotes(before, room);
      let tops = placeNotes(order, before, room);
      let came = 0;
      for (let frame = 1; frame <= 900; frame++) {
        const now = all.map(({ anchor, width }, i): PlacedNote => {
          const [x, y] = anchor!;
          return {
            width,
            anchor: [x + 40 * Math.sin(frame / 80 + i), y + 20 * Math.sin(frame / 110 + 2 * i)],
            hasNoPin: !shown[i],
          };
        });
        if (frame % 20 === 0) {
          const one = Math.floor(all.length * random());
          shown = shown.map((is, i) => (i === one ? !is : is));
          order = updateOrder(order, now, room, (i) => shown[i]);
          tops = new Map([...tops].filter(([i]) => shown[i]));
        }
        const next = placeNotes(order, now, room, { tops, anchors: before.map(({ anchor }) => anchor) });
        for (const [i, top] of next) {
          const last = tops.get(i);
          if (last === undefined) came++;
          else {
            const moved = Math.hypot(
              ...[0, 1].map((axis) => now[i].anchor![axis] - (before[i].anchor ?? now[i].anchor!)[axis]),
            );
            expect(Math.abs(top - last)).to.be.at.most(moved + maxStep + 1e-9);
          }
        }
        for (const i of tops.keys()) expect(next.has(i)).to.equal(true);
        const placed = {
          ...order,
          columns: order.columns.map((one) => ({ ...one, notes: one.notes.filter((i) => next.has(i)) })),
        };
        expect(findProblems(textBoxes(placed, next, now, room), room)).to.deep.equal([]);
        [tops, before] = [next, now];
      }
      expect(came).to.be.above(10);
    }
  });
});

describe('a column of texts between pins', () => {
  it('is the best of all columns on whole pixels, found by trying them', () => {
    const random = randomNumbers(3);
    for (let n = 0; n < 60; n++) {
      const [from, to, apart] = [8, 40, 14];
      const wanted = [0, 1].map(() => Math.round(8 + 44 * random()) + 0.25);
      wanted.sort((a, b) => a - b);
      const blocked = wanted.map(() => {
        const pins = Array.from({ length: 3 }, () => Math.round(60 * random()));
        pins.sort((one, other) => one - other);
        return pins.map((y) => [y - 9, y + 5] as const);
      });
      const isFree = (i: number, top: number): boolean => blocked[i].every(([a, b]) => top <= a || top >= b);
      let best = Infinity;
      for (let first = from; first <= to; first++)
        for (let second = first + apart; second <= to + apart; second++) {
          const pair = [first, second];
          const covered = pair.filter((top, i) => !isFree(i, top)).length;
          best = Math.min(best, covered);
        }
      const spread = [Math.min(to, wanted[0]), Math.min(to + apart, Math.max(wanted[1], wanted[0] + apart))];
      const { tops, covered } = avoidPins(spread, { wanted, blocked, from, to, apart, last: [undefined, undefined] });
      expect(covered).to.equal(best);
      expect(tops[1] - tops[0]).to.be.at.least(apart - 1e-9);
      expect(tops[0]).to.be.at.least(from);
      expect(tops[1]).to.be.at.most(to + apart);
    }
  });

  it('holds as many texts as its free room', () => {
    expect(countFree([], { from: 8, to: 8 + 3 * 28, apart: 28 })).to.equal(4);
    expect(countFree([[0, 30]], { from: 8, to: 8 + 3 * 28, apart: 28 })).to.equal(3);
    expect(countFree([[0, 300]], { from: 8, to: 92, apart: 28 })).to.equal(0);
    expect(countFree([], { from: 8, to: 7, apart: 28 })).to.equal(0);
  });
});
