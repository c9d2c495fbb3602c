import type { Color } from '../optics/transfer-function.ts';

/** Where each name of a hue ends, degrees. */
const hues: readonly (readonly [end: number, name: string])[] = [
  [12, 'red'], [42, 'orange'], [68, 'yellow'], [160, 'green'], [198, 'turquoise'], [258, 'blue'], [290, 'violet'], [345, 'pink'], [360, 'red'],
];

/** A colour in a word or two, for those who are told of it instead of seeing it. */
export function nameColor([red, green, blue]: Color): string {
  const most = Math.max(red, green, blue);
  const least = Math.min(red, green, blue);
  const chroma = most - least;
  const lightness = (most + least) / 2;
  if (lightness > 0.95) return 'white';
  if (lightness < 0.06) return 'black';
  if (chroma < 0.1) return lightness > 0.66 ? 'light grey' : lightness < 0.33 ? 'dark grey' : 'grey';
  const hue = hueOf([red, green, blue], most, chroma);
  const name = hues.find(([end]) => hue < end)?.[1] ?? 'red';
  if (name === 'orange' && lightness < 0.42) return lightness < 0.2 ? 'dark brown' : 'brown';
  if (lightness > 0.78) return `light ${name}`;
  return lightness < 0.25 ? `dark ${name}` : name;
}

/** Degrees from red, 0 to 360. */
function hueOf([red, green, blue]: Color, most: number, chroma: number): number {
  const sixth = most === red ? (green - blue) / chroma + 6 : most === green ? (blue - red) / chroma + 2 : (red - green) / chroma + 4;
  return (sixth * 60) % 360;
}
