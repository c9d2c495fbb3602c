import { spanAround } from '../optics/transfer/span-around.ts';
import type { TransferFunction } from '../optics/transfer/transfer-function.ts';
import type { Language } from '../messages/language.ts';
import { nameColor } from './color-names.ts';
import { colorAt } from './transfer-function-edits.ts';

/** Number of points along the scale at which its colours are named. */
const samples = 48;

/** The values that a legend spans: those of the stops, and if there is only one stop, those of the data too. */
export function legendDomain(stops: TransferFunction, range: readonly [number, number]): [number, number] {
  const first = stops[0].value;
  const last = stops[stops.length - 1].value;
  if (last > first) return [first, last];
  const [low, high] = [Math.min(first, range[0]), Math.max(last, range[1])];
  return high > low ? [low, high] : spanAround(low);
}

/** The content of a legend. */
export interface Scale {
  readonly stops: TransferFunction;
  readonly domain: readonly [number, number];
  /** Empty if the legend has no name. */
  readonly label: string;
  readonly unit: string;
}

/** A legend in words, for readers who can't see it: each colour's name, and the value at which it begins. */
export function describeScale({ stops, domain, label, unit }: Scale, language: Language): string {
  const { messages } = language;
  const [low, high] = domain;
  const digits = language.digitsToDistinguish(low, low + (high - low) / 8, 2);
  const parts: string[] = [];
  let last = '';
  for (let i = 0; i < samples; i++) {
    const value = low + ((high - low) * (i + 0.5)) / samples;
    const name = nameColor(colorAt(stops, value), messages);
    if (name !== last) parts.push(i === 0 ? name : messages.colorFrom(name, language.number(value, digits)));
    last = name;
  }
  return messages.scale(label || messages.legend, language.range(low, high, unit), parts);
}
