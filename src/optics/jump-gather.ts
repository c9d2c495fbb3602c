import { dataEnds } from './cast-ray.ts';
import type { GatherStage, Sample, Segment } from './ray-stages.ts';
import { composite } from './segment.ts';
import { between, findTurn } from './surface-crossings.ts';
import type { Premultiplied } from './transfer-function.ts';

/**
 * Emission and absorption that finds what is opaque at once wherever a ray touches it: where three samples say that values may turn beyond one of those of
 * `findOpaqueJumps`, the turn is looked for. Samples have to know their `point`. Twin: shaders/chunks/jumps.glsl
 * @param values - ascending
 */
export function jumpGather(values: readonly number[]): GatherStage {
  return ({ classify, field: { kinksBetween }, sampleAt, seeSegment, tell }) => {
    const gathered: Premultiplied = [0, 0, 0, 0];
    let before: Segment | null = null;
    const gather = (piece: Segment): void => {
      const color = seeSegment(piece);
      tell?.(piece, color[3]);
      composite(gathered, color);
    };
    const listPieces = (segment: Segment): Segment[] => {
      const { front, back, begin, span } = segment;
      if (!(span > 0) || !front.valid || !back.valid) return [segment];
      // Behind what is cut out nothing is known of what was before.
      if (!before || !(before.span > 0) || !before.front.valid || before.begin + before.span < begin - 1e-6 * span) return [segment];
      const { front: sample, span: spanBefore } = before;
      const turn = findTurn(values, segment, { sample, span: spanBefore, isShown: true }, { sampleAt, kinksBetween });
      if (!turn) return [segment];
      const { at, top } = turn;
      if (at > 0) return [{ front, back: top, begin, span: at }, { front: top, back, begin: begin + at, span: span - at }];
      // In the segment before, of which what is not beyond has been gathered.
      const passed = values.filter((value) => front.value >= value !== top.value >= value).at(-1) ?? front.value;
      const beyond = (from: Sample): number => Math.min(1, Math.max(0, (top.value - passed) / (top.value - from.value)));
      const [rise, fall] = [beyond(sample), beyond(front)];
      const lengths = [rise * (spanBefore + at), -fall * at];
      return [
        { front: sampleAt(between(top, sample, rise)), back: top, begin: begin + at - lengths[0], span: lengths[0] },
        { front: top, back: sampleAt(between(top, front, fall)), begin: begin + at, span: lengths[1] },
        segment,
      ];
    };
    return {
      add: (segment) => {
        listPieces(segment).forEach(gather);
        before = segment;
      },
      chooseSubsteps: (front, back) => classify.countSubsteps(dataEnds(front, back), 1 - gathered[3], [front, back]),
      finish: () => gathered,
    };
  };
}
