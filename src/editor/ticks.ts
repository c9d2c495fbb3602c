/**
 * A round length, 1, 2 or 5 times a power of ten: the smallest one that is at least a given one.
 * @param min - above zero
 */
export function roundStep(min: number): number {
  const power = Math.floor(Math.log10(min));
  if (!Number.isFinite(power)) return min;
  // Read as decimals: of the smallest numbers two times the nearest one to 1e-321 is not the nearest one to 2e-321.
  const steps = [1, 2, 5, 10].map((factor) => Number(`${factor}e${power}`));
  return steps.find((step) => step >= min * (1 - 1e-9)) ?? steps[3];
}

/**
 * Round numbers within a range, evenly spaced.
 * @param maxCount - maximum number of them, at least 2
 * @returns ascending; none if the range is empty
 */
export function listTicks([low, high]: readonly [number, number], maxCount: number): number[] {
  if (!(high > low)) return [];
  const step = roundStep(high / maxCount - low / maxCount); // The difference of the ends may overflow.
  // Tolerance for the rounding of doubles.
  const slack = 1e-9 + 2e-16 * Math.max(Math.abs(low / step), Math.abs(high / step));
  const first = Math.ceil(low / step - slack);
  const last = Math.floor(high / step + slack);
  return Array.from({ length: Math.min(maxCount + 1, last - first + 1) }, (_, i) =>
    Math.min(high, Math.max(low, roundTo((first + i) * step, step))),
  );
}

/** The nearest multiple of a step, without the rounding errors of binary fractions. */
export function roundTo(value: number, step: number): number {
  const rounded = multiply(Math.round(value / step), step);
  const digits = Math.ceil(Math.log10(Math.abs(rounded / step))) + 3;
  return Number(rounded.toPrecision(Math.min(17, Math.max(12, digits || 0)))) + 0; // + 0: there is no minus zero on a scale
}

/** So many steps, as decimals where doubles have few digits left. */
function multiply(count: number, step: number): number {
  const [digits, power] = String(step).split('e');
  return step < 2 ** -1022 ? Number(`${count * Number(digits)}e${power}`) : count * step;
}

/** How much of a label at a place of a scale, 0..1, lies before it: half, but at the ends what keeps it within the scale. */
export function labelShift(share: number): number {
  return share < 0.04 ? 0 : share > 0.96 ? 1 : 0.5;
}
