import type { NamedLabel } from '../../volume/labels.ts';

/**
 * XYZ of white. The standard means the white of profiles of colours (D50), but the programs that write segmentations
 * take that of screens (D65): dcmqi (3D Slicer), dcmjs (OHIF) and highdicom. So their red is red here.
 */
const white = [0.95047, 1, 1.08883];

/** From XYZ to red, green and blue of sRGB. Source: IEC 61966-2-1 */
const toLinear = [
  [3.2404542, -1.5371385, -0.4985314],
  [-0.969266, 1.8760108, 0.041556],
  [0.0556434, -0.2040259, 1.0572252],
];

/**
 * A colour of a file as sRGB, 0 to 1; null if it is none. A colour that a screen can not show becomes one that it can,
 * channel by channel.
 * @param numbers - L, a and b, each from 0 to 65,535. Source: PS3.3, C.10.7.1.1; CIE 15:2004, 8.2.1
 */
export function labToRgb(numbers: readonly number[]): NamedLabel['color'] {
  if (!numbers.every(Number.isFinite)) return null;
  const [lightness, a, b] = numbers.map((n, i) => (i === 0 ? (100 * n) / 65535 : (255 * n) / 65535 - 128));
  const y = (lightness + 16) / 116;
  const xyz = [y + a / 500, y, y - b / 200].map(
    (f, i) => white[i] * (f > 6 / 29 ? f ** 3 : 3 * (6 / 29) ** 2 * (f - 4 / 29)),
  );
  return toLinear.map((row) => {
    const sum = row.reduce((total, weight, i) => total + weight * xyz[i], 0);
    const linear = Math.max(0, Math.min(1, sum));
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
  }) as unknown as NamedLabel['color'];
}
