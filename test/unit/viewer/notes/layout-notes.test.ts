import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import type { Pixel } from '../../../../src/viewer/camera/drag-place.ts';
import { projectPlace } from '../../../../src/viewer/camera/project-place.ts';
import { arrangeNotes, gap, margin, maxStep, placeNotes } from '../../../../src/viewer/notes/layout-notes.ts';
import type { NoteOrder, NoteRoom, PlacedNote } from '../../../../src/viewer/notes/layout-notes.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { findProblems, textBoxes } from '../../../helpers/note-boxes.ts';
import type { TextBox } from '../../../helpers/note-boxes.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const rooms: readonly NoteRoom[] = [
  { width: 640, height: 480, line: 24 },
  { width: 390, height: 292, line: 28 },
  { width: 1600, height: 500, line: 24 },
];

/** Random places in a ball, with texts of random widths. */
function scatter(
  count: number,
  seed: number,
): { readonly places: readonly Vector3[]; readonly widths: readonly number[] } {
  const random = randomNumbers(seed);
  const places = Array.from(
    { length: count },
    (): Vector3 => [random() - 0.5, random() - 0.5, random() - 0.5].map((x) => 140 * x) as unknown as Vector3,
  );
  return { places, widths: places.map(() => 40 + 120 * random()) };
}

function look({ width, height }: NoteRoom, places: readonly Vector3[], theta: number, phi: number): (Pixel | null)[] {
  const camera = orbitCamera({ theta, phi, radius: 420 }, [0, 0, 0], 0.6);
  return places.map((place) => projectPlace(camera, place, { width, height }));
}

const inside = (anchors: readonly (Pixel | null)[], { width, height }: NoteRoom): (Pixel | null)[] =>
  anchors.map((one) => (one && one[0] >= 0 && one[1] >= 0 && one[0] <= width && one[1] <= height ? one : null));

const noted = (anchors: readonly (Pixel | null)[], widths: readonly number[]): PlacedNote[] =>
  anchors.map((anchor, i) => ({ anchor, width: widths[i] }));

const boxesOf = (
  order: NoteOrder,
  tops: ReadonlyMap<number, number>,
  widths: readonly number[],
  room: NoteRoom,
): ReadonlyMap<number, TextBox> =>
  textBoxes(
    order,
    tops,
    widths.map((width) => ({ anchor: null, width })),
    room,
  );

describe('the layout of notes', () => {
  for (const count of [1, 7, 20, 100, 400])
    it(`keeps ${count} notes apart and inside the picture, from 50 cameras`, () => {
      for (const room of rooms) {
        const random = randomNumbers(count + room.width);
        const { places, widths } = scatter(count, count);
        let order: NoteOrder | null = null;
        for (let camera = 0; camera < 50; camera++) {
          const anchors = inside(look(room, places, 6.28 * random(), 0.3 + 2.5 * random()), room);
          const notes = noted(anchors, widths);
          order = arrangeNotes(notes, room, order);
          const boxes = boxesOf(order, placeNotes(order, notes, room), widths, room);
          expect(findProblems(boxes, room)).to.deep.equal([]);
          const wanted = anchors.filter(Boolean).length;
          // All are shown, if there is room for their numbers.
          const rows = Math.floor((room.height - 2 * margin + gap) / (room.line + gap));
          const columns = 2 * Math.floor((room.width / 2 - margin) / (room.line + gap));
          expect(boxes.size).to.equal(Math.min(wanted, rows * columns));
        }
      }
    });

  it('is steady along a slow turn: no text moves farther than its place by more than 2 px, and none covers another', () => {
    const room = rooms[0];
    for (const count of [5, 18, 30]) {
      const { places, widths } = scatter(count, 77 + count);
      const first = look(room, places, 0.3, 1.2);
      const order = arrangeNotes(noted(inside(first, room), widths), room);
      let [tops, before] = [placeNotes(order, noted(first, widths), room), first];
      for (let frame = 1; frame <= 360; frame++) {
        const anchors = look(room, places, 0.3 + (frame * Math.PI) / 360, 1.2);
        const next = placeNotes(order, noted(anchors, widths), room, { tops, anchors: before });
        for (const [i, top] of next) {
          const moved = Math.hypot(anchors[i]![0] - before[i]![0], anchors[i]![1] - before[i]![1]);
          expect(Math.abs(top - tops.get(i)!)).to.be.at.most(moved + maxStep + 1e-9);
        }
        expect(findProblems(boxesOf(order, next, widths, room), room)).to.deep.equal([]);
        [tops, before] = [next, anchors];
      }
    }
  });

  it('follows a jump of the camera within some pictures', () => {
    const room = rooms[0];
    const { places, widths } = scatter(8, 5);
    const [first, then] = [look(room, places, 0, 1.2), look(room, places, 0.4, 1.5)];
    const order = arrangeNotes(noted(first, widths), room);
    let tops = placeNotes(order, noted(first, widths), room);
    const goal = placeNotes(order, noted(then, widths), room);
    for (let frame = 0, anchors = first; frame < 200; frame++, anchors = then)
      tops = placeNotes(order, noted(then, widths), room, { tops, anchors });
    for (const [i, top] of goal) expect(tops.get(i)).to.be.closeTo(top, 1e-6);
  });

  it('puts a text as high as its place where there is room, and keeps the order of places', () => {
    const room = rooms[0];
    const anchors: Pixel[] = [
      [100, 60],
      [140, 300],
      [120, 180],
      [500, 240],
    ];
    const widths = [60, 60, 60, 60];
    const order = arrangeNotes(noted(anchors, widths), room);
    const tops = placeNotes(order, noted(anchors, widths), room);
    expect(order.columns.map(({ notes, isRight }) => [isRight, notes])).to.deep.equal([
      [false, [0, 2, 1]],
      [true, [3]],
    ]);
    expect([0, 1, 2, 3].map((i) => tops.get(i)! + room.line / 2)).to.deep.equal([60, 300, 180, 240]);
  });

  it('changes order and side only where places have changed clearly', () => {
    const room = rooms[0];
    const widths = [60, 60, 60];
    const first = arrangeNotes(
      noted(
        [
          [300, 100],
          [100, 104],
          [500, 50],
        ],
        widths,
      ),
      room,
    );
    expect(first.columns.map(({ notes }) => notes)).to.deep.equal([[0, 1], [2]]);
    // A few pixels past each other, and past the middle.
    const near = arrangeNotes(
      noted(
        [
          [330, 104],
          [100, 100],
          [500, 50],
        ],
        widths,
      ),
      room,
      first,
    );
    expect(near.columns.map(({ notes }) => notes)).to.deep.equal([[0, 1], [2]]);
    const far = arrangeNotes(
      noted(
        [
          [300, 120],
          [100, 100],
          [100, 50],
        ],
        widths,
      ),
      room,
      first,
    );
    expect(far.columns.map(({ notes }) => notes)).to.deep.equal([[2, 1, 0]]);
  });

  it('looks at each of 100 notes a few times in a picture', () => {
    const room = rooms[0];
    const { places, widths } = scatter(100, 1);
    const anchors = inside(look(room, places, 1, 1.2), room);
    let reads = 0;
    const counted = widths.map((width, i) => ({
      width,
      get anchor() {
        reads++;
        return anchors[i];
      },
    }));
    const order = arrangeNotes(counted, room);
    reads = 0;
    const tops = placeNotes(order, counted, room);
    placeNotes(order, counted, room, { tops, anchors });
    expect(reads).to.be.within(100, 800);
  });

  it('shows no text in a picture that is too low, and needs no notes', () => {
    const order = arrangeNotes(noted([[5, 5]], [50]), { width: 200, height: 20, line: 24 });
    expect(order.columns).to.deep.equal([]);
    expect(placeNotes(arrangeNotes([], rooms[0]), [], rooms[0]).size).to.equal(0);
  });
});
