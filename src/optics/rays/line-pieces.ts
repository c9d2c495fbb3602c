import { cubicAt, turnOfCubic } from './cubic.ts';
import type { CubicValues } from './cubic.ts';
import type { CubicPiece, Sample } from './ray-stages.ts';

/**
 * Samples a piece of a line wherever its largest value may be: at both ends, at both thirds, and at the top of the cubic through these four,
 * if that is above the largest so far. All are samples of the line, so no value is found that the line does not have.
 * @param sign - -1 for the smallest value
 * @param take - gets each sample and its place, @returns the largest value so far, times the sign
 * Twin: shaders/chunks/gather/extreme.glsl, gatherPiece
 */
export function searchPiece(
  { from, to, front, back }: CubicPiece,
  sign: 1 | -1,
  sampleAt: (at: number) => Sample,
  take: (found: Sample, at: number) => number,
): void {
  const third = (to - from) / 3;
  const [b, c] = [sampleAt(from + third), sampleAt(from + 2 * third)];
  take(front, from);
  take(b, from + third);
  take(c, from + 2 * third);
  const best = take(back, to);
  const values = valuesOf([front, b, c, back], sign);
  if (!values) return;
  const top = turnOfCubic(values, 1);
  if (top > 0 && top < 3 && cubicAt(values, top) > best) take(sampleAt(from + top * third), from + top * third);
}

/** Samples a piece at its ends and where it turns, in order: these are all its extremes. @param pass - gets each sample and its place */
export function passPiece(
  { from, to, front, back }: CubicPiece,
  sign: 1 | -1,
  sampleAt: (at: number) => Sample,
  pass: (found: Sample, at: number) => void,
): void {
  const third = (to - from) / 3;
  const values = valuesOf([front, sampleAt(from + third), sampleAt(from + 2 * third), back], sign);
  const turns = values
    ? [turnOfCubic(values, 1), turnOfCubic(values, -1)].filter((turn) => turn > 0 && turn < 3)
    : [1, 2];
  turns.sort((a, b) => a - b);
  pass(front, from);
  for (const turn of turns) pass(sampleAt(from + turn * third), from + turn * third);
  pass(back, to);
}

/** null if one of the samples has no data: then the values are no cubic. */
function valuesOf(samples: readonly Sample[], sign: 1 | -1): CubicValues | null {
  return samples.every(({ valid }) => valid)
    ? (samples.map(({ value }) => sign * value) as unknown as CubicValues)
    : null;
}

/**
 * The mean of a piece by Simpson's rule, which is exact for cubics.
 * @param weigh - gets each sample, and the length that it stands for
 */
export function weighPiece(
  { from, to, front, back }: CubicPiece,
  sampleAt: (at: number) => Sample,
  weigh: (found: Sample, span: number) => void,
): void {
  const sixth = (to - from) / 6;
  weigh(front, sixth);
  weigh(sampleAt(from + 3 * sixth), 4 * sixth);
  weigh(back, sixth);
}
