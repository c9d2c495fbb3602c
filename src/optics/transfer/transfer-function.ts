/** sRGB, each 0..1, straight (not multiplied by anything). */
export type Color = readonly [number, number, number];

/** Colour and opacity at one data value. */
export interface Stop {
  /** Data units. */
  readonly value: number;
  readonly color: Color;
  /** 0..1 per reference length. */
  readonly opacity: number;
}

/**
 * Stops in ascending order of value. Between two stops, colour and opacity are interpolated premultiplied, as in CSS
 * gradients. Outside, they stay at those of the first and the last stop. Two stops of one value make a jump.
 */
export type TransferFunction = readonly Stop[];

/** Values from authors must be smaller than this, so that their sums and products are finite. */
export const largestValue = 1e300;

/** The ends of a window lie no farther from 0 than this, however large the data are, for instance where 1.8e308 stands for "no data". */
export const largestWindow = 0.9 * largestValue;

/** Red, green, blue (premultiplied by alpha) and alpha, each 0..1. */
export type Premultiplied = [number, number, number, number];

/** How strongly the light of a sample counts: the two global factors of the paper. */
export interface OpticalFactors {
  /** Multiplies the extinction; 1 changes nothing. */
  readonly opacityFactor: number;
  /** Multiplies the colour, which saturates at white; 1 changes nothing. */
  readonly lightFactor: number;
}

/**
 * Colour and opacity per reference length at a data value.
 * At a jump the later stop counts, so the function is continuous from the right.
 */
export function evaluate(transferFunction: TransferFunction, value: number): Premultiplied {
  const last = transferFunction.length - 1;
  if (value < transferFunction[0].value) return premultiply(transferFunction[0]);
  if (value >= transferFunction[last].value) return premultiply(transferFunction[last]);
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (transferFunction[middle].value <= value) low = middle;
    else high = middle;
  }
  return evaluateBetween(transferFunction[low], transferFunction[high], value);
}

/** The same for a value between two stops that follow each other. */
function evaluateBetween(from: Stop, to: Stop, value: number): Premultiplied {
  const t = (value - from.value) / (to.value - from.value);
  const a = from.opacity;
  const b = to.opacity;
  return [
    mix(from.color[0] * a, to.color[0] * b, t),
    mix(from.color[1] * a, to.color[1] * b, t),
    mix(from.color[2] * a, to.color[2] * b, t),
    mix(a, b, t),
  ];
}

/** The largest opacity of all values; a tiny number above 0 if nothing is visible. */
export function largestOpacity(transferFunction: TransferFunction): number {
  return transferFunction.reduce((largest, { opacity }) => Math.max(largest, opacity), 1e-30);
}

function premultiply({ color, opacity }: Stop): Premultiplied {
  return [color[0] * opacity, color[1] * opacity, color[2] * opacity, opacity];
}

export function mix(a: number, b: number, t: number): number {
  return a + (b - a) * t;
}
