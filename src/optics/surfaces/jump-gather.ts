import { differsInStyle } from '../attachments/labels.ts';
import type { CubicValues } from '../rays/cubic.ts';
import { innerBounds, turnOfCubic } from '../rays/cubic.ts';
import type { CubicPiece, GatherStage, Path, Segment } from '../rays/ray-stages.ts';
import { composite } from '../rays/segment.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';

/**
 * If a part of a ray hides more than this share of the light, it is sampled more closely. With more samples per voxel, the
 * limit is smaller.
 */
export const maxHidden = 0.25;

/**
 * The same share where one end of the part has another label than the other, with another appearance: the share of the part that each of
 * them has is not known, so it may be wrong by half of what the part hides.
 */
export const maxHiddenAtLabels = maxHidden / 16;

/** A part of a ray is halved at most this many times. */
export const maxHalvings = 10;

/** The largest number of samples on one part: about two for each halving in front of each of several values. */
export const maxLooks = 256;

/** A smaller share of the light is not visible. Rays also end early by it. */
const nothing = 1e-3;

/**
 * Emission and absorption that finds opaque values wherever a ray touches them. Between two planes of voxels' centres, a tri-linear value
 * is a cubic of the length. Each such piece is cut into parts, as many as the wanted samples per voxel. The cubic of each part shows
 * whether it passes one of the values of `findOpaqueJumps`, even for a short length. If it does, or if the part hides much, the part is
 * cut where the cubic turns and where another label may show, and the rest is halved until nothing more can be distinguished.
 * Twin: shaders/chunks/gather/jumps.glsl
 * @param values - ascending
 * @param voxel - length of a voxel, in bounding diameters
 */
export function jumpGather(values: readonly number[], voxel: number): GatherStage {
  const countUpTo = (value: number): number => values.filter((one) => one <= value).length;
  return ({ classify, seeSegment, step, report }) => {
    const gathered: Premultiplied = [0, 0, 0, 0];
    const take = (segment: Segment, color: Premultiplied): void => {
      report?.(segment, color[3]);
      composite(gathered, color);
    };
    const wholeParts = countParts(voxel, step);
    const limitOf = ({ front, back }: Segment): number =>
      (differsInStyle(front, back) ? maxHiddenAtLabels : maxHidden) / wholeParts;
    const passes = ({ front, back }: Segment): boolean =>
      front.valid && back.valid && countUpTo(front.value) !== countUpTo(back.value);
    const addPart = (segment: Segment, path: Path): void => {
      const { sampleAt, turnsBetween } = path;
      const { front, back, begin, span } = segment;
      const color = seeSegment(segment);
      const inner = [sampleAt(begin + span / 3), sampleAt(begin + (2 * span) / 3)];
      const isWhole = [front, ...inner, back].every(({ valid }) => valid);
      const cubic: CubicValues = [front.value, inner[0].value, inner[1].value, back.value];
      const labels = turnsBetween?.(begin, begin + span) ?? [];
      const isHidden = (1 - gathered[3]) * color[3] > limitOf(segment);
      if (!isHidden && labels.length === 0 && !passes(segment) && !(isWhole && mayTurn(cubic, countUpTo))) {
        take(segment, color);
        return;
      }
      const turns = isWhole
        ? [turnOfCubic(cubic, 1), turnOfCubic(cubic, -1)]
            .filter((turn) => turn > 0 && turn < 3)
            .map((turn) => (turn / 3) * span)
        : [];
      lookCloser(segment, [...turns, ...labels.map((at) => at - begin)], path);
    };
    const lookCloser = (segment: Segment, turns: readonly number[], { sampleAt, jumpBetween }: Path): void => {
      const { begin, span } = segment;
      let [at, known, length] = [0, segment.front, span];
      for (let look = 0; at < span; look++) {
        const mark = turns.reduce((next, turn) => (turn > at && turn < next ? turn : next), span);
        // After the last sample, the rest is taken in one piece.
        const end = look >= maxLooks ? span : Math.min(mark, at + length);
        const piece = {
          front: known,
          back: end === span ? segment.back : sampleAt(begin + end),
          begin: begin + at,
          span: end - at,
        };
        const jump = voxel * (jumpBetween?.(begin + at, begin + end) ?? 0);
        const isShort = look >= maxLooks || end - at <= span / 2 ** maxHalvings;
        const color = seeSegment(piece);
        const visible = 1 - gathered[3];
        if (!isShort && visible > nothing && (jump > 0 || visible * color[3] > limitOf(piece) || passes(piece))) {
          length = (end - at) / 2;
          continue;
        }
        if (jump > piece.span && piece.front.valid && piece.back.valid) gatherJump({ ...piece, span: jump });
        else take(piece, color);
        [at, known, length] = [end, piece.back, 2 * (end - at)];
      }
    };
    /** Between two levels of bricks values jump. They are taken to change evenly on the way of a voxel, about as they do in the whole volume. */
    const gatherJump = ({ front, back, begin, span }: Segment): void => {
      let [at, known, share] = [0, front, 1];
      for (let look = 0; at < 1; look++) {
        const end = look >= maxLooks ? 1 : Math.min(1, at + share);
        const next = end < 1 ? { ...front, value: front.value + end * (back.value - front.value) } : back;
        const piece = { front: known, back: next, begin, span: (end - at) * span };
        const color = seeSegment(piece);
        const visible = 1 - gathered[3];
        const isShort = look >= maxLooks || end - at <= 0.5 ** maxHalvings;
        if (!isShort && visible > nothing && (visible * color[3] > limitOf(piece) || passes(piece))) {
          share = (end - at) / 2;
          continue;
        }
        take(piece, color);
        [at, known, share] = [end, next, 2 * (end - at)];
      }
    };
    return {
      add: (segment) => take(segment, seeSegment(segment)),
      addPiece: ({ from, to, front, back }: CubicPiece, path) => {
        const parts = wholeParts * Math.max(1, path.minSubstepsAt?.(from) ?? 1);
        let known = front;
        for (let n = 0; n < parts; n++) {
          const [begin, end] = [n, n + 1].map((part) => from + (part / parts) * (to - from));
          const next = n < parts - 1 ? path.sampleAt(end) : back;
          addPart({ front: known, back: next, begin, span: end - begin }, path);
          known = next;
        }
      },
      chooseSubsteps: (front, back) =>
        classify.countSubsteps([front.value, back.value], 1 - gathered[3], [front, back]),
      finish: () => gathered,
    };
  };
}

/**
 * Number of parts between two planes of voxels' centres: as many as steps per voxel, so twice as many steps give parts of half the length.
 */
function countParts(voxel: number, step: number): number {
  return Math.max(1, Math.ceil(voxel / step - 0.01));
}

/** Whether a cubic may pass a value between its ends. The Bernstein coefficients bound the cubic. */
function mayTurn(values: CubicValues, countUpTo: (value: number) => number): boolean {
  const [a, , , d] = values;
  const inner = innerBounds(values);
  return (
    countUpTo(Math.min(a, d, ...inner)) < countUpTo(Math.min(a, d)) ||
    countUpTo(Math.max(a, d, ...inner)) > countUpTo(Math.max(a, d))
  );
}
