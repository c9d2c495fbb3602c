/** Device pixels. */
export interface PictureSize {
  readonly width: number;
  readonly height: number;
}

/** @param maxSide - device pixels along a side that the device draws */
export function pictureSize({ clientWidth, clientHeight }: Element, maxSide: number): PictureSize {
  const ratio = devicePixelRatio || 1;
  const longest = Math.max(clientWidth, clientHeight) * ratio;
  const fit = ratio * Math.min(1, maxSide / Math.max(1, longest));
  return { width: Math.max(1, Math.round(clientWidth * fit)), height: Math.max(1, Math.round(clientHeight * fit)) };
}

/**
 * The size of a picture that a script asks for; what is absent follows from the element's shape.
 * @throws {RangeError} where the device does not draw so many pixels
 */
export function askedSize(host: Element, { width, height }: Partial<PictureSize>, maxSide: number): PictureSize {
  if (width === undefined && height === undefined) return pictureSize(host, maxSide);
  const ratio = host.clientWidth / Math.max(1, host.clientHeight);
  const [w, h] = [width ?? height! * ratio, height ?? width! / ratio].map(Math.round);
  if (!(w >= 1 && h >= 1 && w <= maxSide && h <= maxSide)) {
    throw new RangeError(`toBlob got ${w} x ${h} pixels; expected 1 to ${maxSide} on each side`);
  }
  return { width: w, height: h };
}
