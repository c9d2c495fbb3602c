/** Device pixels. */
export interface PictureSize {
  readonly width: number;
  readonly height: number;
}

/** @param maxSide - the longest side that the device can draw, in device pixels */
export function pictureSize({ clientWidth, clientHeight }: Element, maxSide: number): PictureSize {
  const ratio = devicePixelRatio || 1;
  const longest = Math.max(clientWidth, clientHeight) * ratio;
  const fit = ratio * Math.min(1, maxSide / Math.max(1, longest));
  return { width: Math.max(1, Math.round(clientWidth * fit)), height: Math.max(1, Math.round(clientHeight * fit)) };
}
