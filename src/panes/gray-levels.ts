import type { ValueWindow, Volume } from '../volume/volume.ts';

/** How values become grey. */
export interface GrayLevels {
  /** Data values of black and white. */
  readonly window: readonly [number, number];
  /** DICOM's two functions. `linear` is meant for whole numbers, and its range is narrower by one value. */
  readonly windowFunction: WindowFunction;
}

export const windowFunctions = ['linear-exact', 'linear'] as const;
export type WindowFunction = (typeof windowFunctions)[number];

/**
 * The grey of a value as a straight line, `(value - black) / (white - black)`, 0 to 1 and clamped at both ends. A
 * window of `low` to `high` has the centre c = (low + high) / 2 and the width w = high - low. LINEAR_EXACT is (x - c) /
 * w + 0.5. LINEAR is (x - (c - 0.5)) / (w - 1) + 0.5, and a threshold where w is 1 or less.
 * Source: DICOM PS3.3 C.11.2.1.2.1 and C.11.2.1.3.2
 */
export function grayRange({
  window: [low, high],
  windowFunction,
}: GrayLevels): readonly [black: number, white: number] {
  if (windowFunction === 'linear-exact') return [low, high];
  const [center, width] = [(low + high) / 2, high - low];
  const half = Math.max(0, width - 1) / 2;
  return [center - 0.5 - half, center - 0.5 + half];
}

/** Of a window of the file the ends are black and white themselves: what its own function leaves out is out already. */
export function grayLevels(
  window: GrayLevels['window'],
  windowFunction: WindowFunction,
  volume: Pick<Volume, 'windows'>,
): GrayLevels {
  return { window, windowFunction: windowOfFile(window, volume) ? 'linear-exact' : windowFunction };
}

/** The window of the file that has these ends; undefined where none has. */
export function windowOfFile(
  [low, high]: GrayLevels['window'],
  { windows }: Pick<Volume, 'windows'>,
): ValueWindow | undefined {
  return windows?.find(({ from, to }) => from === low && to === high);
}

/** The window of a centre and a width. */
export function windowAround(center: number, width: number): readonly [number, number] {
  return [center - width / 2, center + width / 2];
}
