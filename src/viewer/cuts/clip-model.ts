import { add, dot, scale, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { ClipAttributes } from './clip-attributes.ts';
import type { ClipShape } from '../model/clip-source.ts';

/** The box of a volume in the coordinates of its region, and the factor by which its heights are exaggerated. */
export interface ClipRoom {
  readonly low: Vector3;
  readonly high: Vector3;
  readonly stretch: number;
}

/** A handle by which a person drags a plane or a box; world coordinates, as in the scene. */
export interface ClipGrip {
  readonly at: Vector3;
  /** The only direction in which it moves; absent where it moves freely. */
  readonly along?: Vector3;
  /** For a box: the side that it moves; null for the whole box, and for a plane. */
  readonly side: { readonly axis: number; readonly isHigh: boolean } | null;
}

/**
 * What a plane or a box cuts, and how a person drags it: the attributes count until a person moves it. All input and output is in
 * the coordinates of `region`; only its handles are in world coordinates.
 */
export class ClipModel {
  #said: ClipAttributes = { kind: 'plane', normal: [0, 0, 1], at: null };
  #at: number | null = null;
  #box: readonly number[] | null = null;

  /** The attributes have changed; a place chosen by a person is dropped. */
  set said(said: ClipAttributes) {
    this.#said = said;
    this.#at = this.#box = null;
  }

  /** The present plane or box. @param room - null where no volume is known */
  shape(room: ClipRoom | null): ClipShape | null {
    const said = this.#said;
    if (said.kind === 'plane')
      return { ...said, at: this.#at ?? said.at ?? (room && dot(said.normal, middleOf(room))) };
    const box = this.#box ?? said.box ?? (room && usualBox(room, said.keep));
    return box && { ...said, box };
  }

  /** The handles of the plane or box. If it is outside the volume, its main handle is at the nearest end of the volume. */
  grips(room: ClipRoom): ClipGrip[] {
    const shape = this.shape(room)!;
    const toScene = ([x, y, z]: Vector3): Vector3 => [x, y, z * room.stretch];
    if (shape.kind === 'plane') {
      // A plane moves along its normal in the scene.
      const middle = middleOf(room);
      const at = add(
        middle,
        scale(shape.normal, withinReach(shape.at!, shape.normal, room) - dot(shape.normal, middle)),
      );
      return [{ at: toScene(at), along: toScene(shape.normal), side: null }];
    }
    const [low, high] = cornersOf(shape.box);
    const middle = scale(add(low, high), 0.5);
    const sides = [0, 1, 2].flatMap((axis) =>
      [low, high].map((corner, end): ClipGrip => ({
        at: toScene(replace(middle, axis, corner[axis])),
        along: replace([0, 0, 0], axis, 1),
        side: { axis, isHigh: end === 1 },
      })),
    );
    return [{ at: toScene(nearestIn(room, middle)), side: null }, ...sides];
  }

  /** A person moves one of its handles. @param to - world coordinates, as in the scene */
  move(index: number, [x, y, z]: Vector3, room: ClipRoom): void {
    const shape = this.shape(room)!;
    const to: Vector3 = [x, y, z / room.stretch];
    if (shape.kind === 'plane') {
      this.#at = withinReach(dot(shape.normal, to), shape.normal, room);
      return;
    }
    const { side } = this.grips(room)[index];
    const [low, high] = cornersOf(shape.box);
    this.#box = side
      ? moveSide([low, high], side, within(to[side.axis], room.low[side.axis], room.high[side.axis]))
      : moveBox([low, high], to, room);
  }
}

type Corners = readonly [low: Vector3, high: Vector3];

const middleOf = ({ low, high }: ClipRoom): Vector3 => scale(add(low, high), 0.5);

const within = (x: number, low: number, high: number): number => Math.min(high, Math.max(low, x));

/** Limit a place along a normal to the extent of the volume. */
function withinReach(at: number, normal: Vector3, room: ClipRoom): number {
  const reach = cornersIn(room).map((corner) => dot(normal, corner));
  return within(at, Math.min(...reach), Math.max(...reach));
}

const nearestIn = ({ low, high }: ClipRoom, place: Vector3): Vector3 =>
  place.map((x, axis) => within(x, low[axis], high[axis])) as unknown as Vector3;

const replace = (of: Vector3, axis: number, x: number): Vector3 =>
  of.map((own, one) => (one === axis ? x : own)) as unknown as Vector3;

function cornersIn({ low, high }: ClipRoom): Vector3[] {
  return Array.from(
    { length: 8 },
    (_, i) => [i & 1, (i >> 1) & 1, i >> 2].map((end, axis) => (end ? high : low)[axis]) as unknown as Vector3,
  );
}

function cornersOf(box: readonly number[]): Corners {
  const [low, high] = [Math.min, Math.max].map(
    (end) => [0, 1, 2].map((axis) => end(box[axis], box[axis + 3])) as unknown as Vector3,
  );
  return [low, high];
}

/**
 * The default box. To keep: the whole volume. To cut out: the eighth that is in front, at the left, for a person who looks at a
 * patient.
 */
function usualBox(room: ClipRoom, keep: 'inside' | 'outside'): number[] {
  return [...(keep === 'inside' ? room.low : middleOf(room)), ...room.high];
}

/** Move a side, but not past the opposite one. */
function moveSide([low, high]: Corners, { axis, isHigh }: { axis: number; isHigh: boolean }, to: number): number[] {
  return isHigh
    ? [...low, ...replace(high, axis, Math.max(low[axis], to))]
    : [...replace(low, axis, Math.min(high[axis], to)), ...high];
}

/** Move a box; it keeps its size, and its middle stays in the volume. */
function moveBox([low, high]: Corners, to: Vector3, room: ClipRoom): number[] {
  const middle = nearestIn(room, to);
  const half = scale(subtract(high, low), 0.5);
  return [...subtract(middle, half), ...add(middle, half)];
}
