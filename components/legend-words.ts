import type { TransferFunction } from '../src/optics/transfer-function.ts';
import { nameColor } from '../src/editor/color-names.ts';
import { formatNumber, formatValue } from '../src/editor/ticks.ts';
import { colorAt } from '../src/editor/transfer-function-edits.ts';

/** ContextPool along the scale at which its colours are named. */
const samples = 48;

/** The values that a legend spans: those of the stops, which may be one alone; then those of the data too. */
export function legendDomain(stops: TransferFunction, range: readonly [number, number]): [number, number] {
  const first = stops[0].value;
  const last = stops[stops.length - 1].value;
  if (last > first) return [first, last];
  const [low, high] = [Math.min(first, range[0]), Math.max(last, range[1])];
  return high > low ? [low, high] : [low - 0.5, low + 0.5];
}

/** A legend for those who do not see it: each colour in a word, and from where it begins. */
export function describeScale(
  { stops, domain, label, unit }: { stops: TransferFunction; domain: readonly [number, number]; label: string; unit: string },
): string {
  const [low, high] = domain;
  const parts: string[] = [];
  let last = '';
  for (let i = 0; i < samples; i++) {
    const value = low + ((high - low) * (i + 0.5)) / samples;
    const name = nameColor(colorAt(stops, value));
    if (name !== last) parts.push(i === 0 ? name : `${name} from ${formatNumber(value, 2)}`);
    last = name;
  }
  return `${label || 'Colours'}, ${formatNumber(low)} to ${formatValue(high, unit)}: ${parts.join(', ')}.`;
}
