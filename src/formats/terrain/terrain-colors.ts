/** Heights above the sea, metres, and colours: quiet ones, so that the weather stands out. The sea is blue-grey. */
const stops: readonly (readonly [height: number, color: readonly [number, number, number]])[] = [
  [0, [0.2, 0.29, 0.38]],
  [1, [0.33, 0.43, 0.31]],
  [300, [0.45, 0.51, 0.35]],
  [1000, [0.6, 0.54, 0.4]],
  [2000, [0.62, 0.54, 0.47]],
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
  return [0, 1, 2].map((i) => lowColor[i] + share * (highColor[i] - lowColor[i])) as unknown as [
    number,
    number,
    number,
  ];
}
