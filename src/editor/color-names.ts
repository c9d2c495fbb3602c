import type { Color } from '../optics/transfer/transfer-function.ts';
import type { ColorName, CompanionMessages } from '../messages/messages.ts';

/** Where each name of a hue ends, degrees. */
const hues: readonly (readonly [end: number, name: ColorName])[] = [
  [12, 'red'],
  [42, 'orange'],
  [68, 'yellow'],
  [160, 'green'],
  [198, 'turquoise'],
  [258, 'blue'],
  [290, 'violet'],
  [345, 'pink'],
  [360, 'red'],
];

/** A colour in a word or two, for readers who can't see it. */
export function nameColor([red, green, blue]: Color, { colors, lightColor, darkColor }: CompanionMessages): string {
  const max = Math.max(red, green, blue);
  const min = Math.min(red, green, blue);
  const chroma = max - min;
  const lightness = (max + min) / 2;
  if (lightness > 0.95) return colors.white;
  if (lightness < 0.06) return colors.black;
  if (chroma < 0.1)
    return lightness > 0.66 ? lightColor(colors.grey) : lightness < 0.33 ? darkColor(colors.grey) : colors.grey;
  const hue = hueOf([red, green, blue], max, chroma);
  const name = hues.find(([end]) => hue < end)?.[1] ?? 'red';
  if (name === 'orange' && lightness < 0.42) return lightness < 0.2 ? darkColor(colors.brown) : colors.brown;
  if (lightness > 0.78) return lightColor(colors[name]);
  return lightness < 0.25 ? darkColor(colors[name]) : colors[name];
}

/** Degrees from red, 0 to 360. */
function hueOf([red, green, blue]: Color, max: number, chroma: number): number {
  const sixth =
    max === red ? (green - blue) / chroma + 6 : max === green ? (blue - red) / chroma + 2 : (red - green) / chroma + 4;
  return (sixth * 60) % 360;
}
