import {
  converter,
  modeA98,
  modeHsl,
  modeHwb,
  modeLab,
  modeLch,
  modeLrgb,
  modeOklab,
  modeOklch,
  modeP3,
  modeProphoto,
  modeRec2020,
  modeRgb,
  modeXyz50,
  modeXyz65,
  parse,
  useMode,
} from '#culori';
import type { Color } from './transfer-function.ts';

// Only the colour spaces of CSS Color 4; culori's others stay out of the bundle.
for (const mode of [
  modeRgb,
  modeHsl,
  modeHwb,
  modeLab,
  modeLch,
  modeLrgb,
  modeOklab,
  modeOklch,
  modeP3,
  modeA98,
  modeProphoto,
  modeRec2020,
  modeXyz50,
  modeXyz65,
]) {
  useMode(mode as typeof modeRgb);
}
const toRgb = converter('rgb');

/**
 * Reads a CSS colour: a name, hex, rgb(), hsl(), hwb(), lab(), lch(), oklab(), oklch() or color().
 * @returns sRGB, clipped to 0..1, and alpha; null if the text is no colour
 */
export function parseCssColor(text: string): { color: Color; alpha: number } | null {
  const parsed = parse(text.trim());
  const rgb = parsed && toRgb(parsed);
  if (!rgb) return null;
  const clip = (channel: number | undefined) => Math.min(1, Math.max(0, channel ?? 0));
  return { color: [clip(rgb.r), clip(rgb.g), clip(rgb.b)], alpha: clip(rgb.alpha ?? 1) };
}
