/**
 * A span of values around one value, if all values are the same: half a unit to both sides, or more if numbers are so large that
 * half a unit would be lost to rounding.
 */
export function spanAround(value: number): [low: number, high: number] {
  const half = Math.max(0.5, Math.abs(value) * 2 ** -20);
  return [Math.max(-Number.MAX_VALUE, value - half), Math.min(Number.MAX_VALUE, value + half)];
}
