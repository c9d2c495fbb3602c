/** Number of steps on a ray. A rest that is shorter than a thousandth of a step makes the last step longer. */
export function countSteps(total: number, step: number): number {
  return Math.max(1, Math.ceil(total / step - 1e-3));
}
