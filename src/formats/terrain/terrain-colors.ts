/** Heights above the sea, metres, and colours: quiet ones, so that the weather stands out. The sea is blue-grey. */
const stops: readonly (readonly [height: number, color: readonly [number, number, number]])[] = [
  [-1, [0.3, 0.36, 0.42]],
  [1, [0.35, 0.41, 0.35]],
  [300, [0.45, 0.48, 0.39]],
  [1000, [0.57, 0.53, 0.44]],
  [2000, [0.62, 0.57, 0.52]],
  [3000, [0.78, 0.76, 0.74]],
  [4500, [0.95, 0.95, 0.96]],
];

/** Red, green and blue, 0..1. @param height - metres above the sea */
export function terrainColor(height: number): readonly [number, number, number] {
  const above = stops.findIndex(([from]) => from > height);
  if (above < 0) return stops[stops.length - 1][1];
  if (above === 0) return stops[0][1];
  const [[low, lowColor], [high, highColor]] = [stops[above - 1], stops[above]];
  const share = (height - low) / (high - low);
  return [0, 1, 2].map((i) => lowColor[i] + share * (highColor[i] - lowColor[i])) as unknown as [number, number, number];
}
