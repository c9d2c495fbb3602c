import { parseTransferFunction, splitOutsideBrackets } from '../../optics/transfer/parse-transfer-function.ts';
import type { Stop } from '../../optics/transfer/transfer-function.ts';
import { writeColor } from '../../optics/transfer/write-transfer-function.ts';

/** The values of stops, as their text has them. */
interface WrittenStops {
  readonly values: readonly string[];
  readonly stops: readonly Stop[];
}

/**
 * What is between two transfer functions with stops at the same values: colours and opacities are mixed stop by stop.
 * @param from - text of the attribute, as `to`; null where it is absent
 * @returns the text at a share of the way, 0 to 1; null where the stops are at other values, or a text has no stops
 */
export function blendStops(from: string | null, to: string | null): ((share: number) => string) | null {
  const [a, b] = [readStops(from), readStops(to)];
  if (!a || !b || a.values.length !== b.values.length || a.values.some((value, i) => value !== b.values[i]))
    return null;
  return (share) =>
    a.values
      .map((value, i) => {
        const mix = (one: number, other: number): number => one + (other - one) * share;
        const [start, end] = [a.stops[i], b.stops[i]];
        const [red, green, blue] = start.color.map((channel, c) => mix(channel, end.color[c]));
        const opacity = Number((mix(start.opacity, end.opacity) * 100).toPrecision(4));
        return `${value} ${writeColor([red, green, blue])} ${opacity}%`;
      })
      .join(', ');
}

function readStops(text: string | null): WrittenStops | null {
  if (text === null) return null;
  try {
    // The window only gives percentages an order: the texts of the values are compared, not their numbers.
    const stops = parseTransferFunction(text, [0, 100]);
    return { stops, values: splitOutsideBrackets(text, ',').map((part) => part.trim().split(/\s/)[0]) };
  } catch {
    return null; // The name of a preset; or a text that the view reports.
  }
}
