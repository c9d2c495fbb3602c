// Counts how often each value occurs with each gradient.

/** Values and gradients at points of a volume. */
export interface PlaneSamples {
  /** Data units. */
  readonly values: Float32Array;
  /** Data units per world unit. */
  readonly gradients: Float32Array;
}

/** Share of the gradients that may lie above the chart: a few steep ones would squeeze all others. */
const stray = 0.003;

/** The largest gradient of the chart: the steepest one, without those few; 1 if nothing changes. */
export function chooseSteepest({ gradients }: PlaneSamples): number {
  const sorted = gradients.slice();
  sorted.sort();
  return 1.2 * (sorted[Math.floor((1 - stray) * (sorted.length - 1))] ?? 0) || 1;
}

/**
 * Counts how often values and gradients occur together.
 * @param size - bins across, by value, and upwards, by gradient
 * @returns shape [gradients, values], from the lowest gradient
 */
export function countJointly(
  { values, gradients }: PlaneSamples,
  { domain: [low, high], steepest }: { readonly domain: readonly [number, number]; readonly steepest: number },
  [columns, rows]: readonly [number, number],
): Uint32Array {
  const counts = new Uint32Array(columns * rows);
  for (let i = 0; i < values.length; i++) {
    const column = Math.floor(((values[i] - low) / (high - low)) * columns);
    const row = Math.floor((gradients[i] / steepest) * rows);
    if (column >= 0 && column < columns && row < rows) counts[row * columns + column]++;
  }
  return counts;
}
