/** Evenly spaced times. */
export interface TimeSteps {
  readonly first: number;
  /** Above 0. */
  readonly step: number;
  /** 's', or that of the file where it does not count time. */
  readonly unit: string;
}

/**
 * The time of a scan as pages have it where it counts from some start: a number with its unit, '12.5 s'.
 * @param steps - null where the file does not say it
 */
export function timeAt(index: number, steps: TimeSteps | null): string | null {
  return steps && timeText(steps.first + index * steps.step, steps.unit);
}

/** A number with its unit; null if it is not finite. The digits that binary fractions add are left out. */
export function timeText(value: number, unit: string): string | null {
  return Number.isFinite(value) ? `${Number(value.toPrecision(9))} ${unit}` : null;
}

/** What a 32-bit float was before it was rounded to one. */
export const shortest = (float32: number): number => Number(float32.toPrecision(7));
