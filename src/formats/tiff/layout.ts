import type { Vector3 } from '../../volume/matrix.ts';

/** Value = slope * number + intercept. */
export interface ValueScale {
  readonly slope: number;
  readonly intercept: number;
  readonly unit: string;
}

/** Which pages of a file are its slices, and where they lie. */
export interface TiffLayout {
  /** 'OME-TIFF' */
  readonly format: string;
  readonly slices: number;
  readonly times: number;
  /** The page of a slice: its index, or null where the file does not have it. */
  pageOf(slice: number, time: number): number | null;
  /** Distances of pixels and of slices, mm; null where the file does not say them. */
  readonly spacing: Vector3 | null;
  /** Seconds from one time to the next; null where the file does not say it. */
  readonly timeStep: number | null;
  /** Whether slices without a page are 0, and no error. */
  readonly mayLack?: boolean;
  /** What of the file is not shown, in words. */
  readonly left: readonly string[];
  readonly window?: readonly [number, number];
  /** Absent where numbers are values. */
  readonly scale?: ValueScale;
}

/** 'channels 2 to 4 of the file' */
export function nameRest(one: string, count: number): string | null {
  if (count <= 1) return null;
  return count > 2 ? `${one}s 2 to ${count} of the file` : `${one} 2 of the file`;
}

/** Where only the distance of slices is missing, it is said. */
export const guessedDistance =
  'the distance of the slices, which the file does not say: it is taken as that of the pixels';
