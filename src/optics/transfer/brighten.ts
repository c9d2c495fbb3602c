import { evaluate } from './transfer-function.ts';
import type { Color, Premultiplied, Stop, TransferFunction } from './transfer-function.ts';

/** A new stop has at least this share of the distance to each of its neighbours. */
const atStop = 1e-9;

/**
 * Multiplies the colours of a transfer function by the light factor. Each channel saturates at white by
 * itself. Premultiplied colours are linear between stops, and so is opacity, their upper bound. Where a colour
 * reaches this bound, a stop is added. So the result is exact between stops, too.
 * @param lightFactor - at least 0; 1 changes nothing
 */
export function brighten(transferFunction: TransferFunction, lightFactor: number): TransferFunction {
  if (lightFactor === 1) return transferFunction;
  return transferFunction.flatMap((stop, i) => {
    const lit: Stop = { ...stop, color: light(stop.color, lightFactor) };
    const next = transferFunction[i + 1];
    return next && next.value > stop.value ? [lit, ...saturations(transferFunction, [stop, next], lightFactor)] : [lit];
  });
}

function light(color: Color, lightFactor: number): Color {
  return color.map((channel) => Math.min(1, channel * lightFactor)) as unknown as Color;
}

/** Stops between two neighbours, where a channel starts or stops being saturated. */
function saturations(
  transferFunction: TransferFunction,
  [from, to]: readonly [Stop, Stop],
  lightFactor: number,
): Stop[] {
  const shares: number[] = [];
  for (let c = 0; c < 3; c++) {
    // How far the brightened channel is above its bound, at both ends.
    const [a, b] = [from, to].map(({ color, opacity }) => (color[c] * lightFactor - 1) * opacity);
    if (Math.sign(a) * Math.sign(b) < 0) shares.push(Math.min(1 - atStop, Math.max(atStop, a / (a - b))));
  }
  shares.sort((a, b) => a - b);
  return shares.map((share) => {
    const value = from.value + share * (to.value - from.value);
    const [red, green, blue, opacity]: Premultiplied = evaluate(transferFunction, value);
    return { value, color: light([red / opacity, green / opacity, blue / opacity], lightFactor), opacity };
  });
}
