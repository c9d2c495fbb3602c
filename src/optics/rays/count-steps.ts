/** Steps on a ray: a rest shorter than a thousandth of a step is no step, but makes the last one longer. */
export function countSteps(total: number, step: number): number {
  return Math.max(1, Math.ceil(total / step - 1e-3));
}
