// Converts the position of a pointer in the page to a place in an element. All code that listens to pointers uses this: a page may scale,
// zoom or turn the element or show it in perspective, directly or through an element around it. Then pixels of the page are not pixels of
// the element.

/** The position of a pointer: that of an event. */
export interface PagePoint {
  readonly clientX: number;
  readonly clientY: number;
}

/** A place in an element: its own CSS pixels from the left and the top edge, within its border. */
export type ElementPlace = readonly [x: number, y: number];

/** The four corners as shares of width and height, in order around the element. */
const corners = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
] as const;

/** The box with the markers of the corners, for each element that has been measured. */
const markers = new WeakMap<HTMLElement, HTMLElement>();

/**
 * The place of a pointer in an element, for all CSS transforms, zooms and perspectives of the page. It fits `clientWidth` and
 * `clientHeight`: a pointer at the lower right corner has these values.
 *
 * We put four invisible points at the corners of the element and ask the browser where it shows them: `getBoundingClientRect` of a turned
 * element is only the box around it, and no property gives the sum of all transforms around the element.
 * @param element - one whose absolutely positioned children are placed relative to it; in an element with a shadow root, the points are in
 * that root
 * @returns the middle of the element where it is seen edge-on, as a pointer has no place in it then
 */
export function placeInElement(element: HTMLElement, { clientX, clientY }: PagePoint): ElementPlace {
  const marks = [...cornersOf(element).children].map((mark) => mark.getBoundingClientRect());
  const [across, down] = shareInQuad(
    marks.map(({ left, top }) => [left, top] as const),
    [clientX, clientY],
  ) ?? [0.5, 0.5];
  return [across * element.clientWidth, down * element.clientHeight];
}

/**
 * The place of the middle of `part` in the element that contains it, as in `placeInElement`. `offsetWidth` and `offsetHeight` of the part
 * are already pixels of the element.
 */
export function middleInElement(element: HTMLElement, part: Element): ElementPlace {
  return placeInElement(element, middleInPage(part));
}

/** Where a page shows the middle of a small element. */
export function middleInPage(part: Element): PagePoint {
  const { left, top, width, height } = part.getBoundingClientRect();
  return { clientX: left + width / 2, clientY: top + height / 2 };
}

/**
 * The place of a point in a square that a projective map has mapped to four corners.
 * Source: P. Heckbert, Fundamentals of Texture Mapping and Image Warping, 1989, section 2.2.3
 * @param quad - the images of (0, 0), (1, 0), (1, 1) and (0, 1)
 * @returns shares of the square's sides; null where it has no area
 */
export function shareInQuad(
  [[x0, y0], [x1, y1], [x2, y2], [x3, y3]]: readonly (readonly [x: number, y: number])[],
  [x, y]: readonly [x: number, y: number],
): readonly [number, number] | null {
  const [dx1, dx2, sx] = [x1 - x2, x3 - x2, x0 - x1 + x2 - x3];
  const [dy1, dy2, sy] = [y1 - y2, y3 - y2, y0 - y1 + y2 - y3];
  const area = dx1 * dy2 - dx2 * dy1;
  const g = (sx * dy2 - dx2 * sy) / area;
  const h = (dx1 * sy - sx * dy1) / area;
  const [a, b] = [x1 - x0 + g * (x1 - x), x3 - x0 + h * (x3 - x)];
  const [d, e] = [y1 - y0 + g * (y1 - y), y3 - y0 + h * (y3 - y)];
  const determinant = a * e - b * d;
  const share = [((x - x0) * e - b * (y - y0)) / determinant, (a * (y - y0) - (x - x0) * d) / determinant] as const;
  return share.every(Number.isFinite) ? share : null;
}

function cornersOf(element: HTMLElement): HTMLElement {
  let corner = markers.get(element);
  if (corner?.isConnected) return corner;
  corner = element.ownerDocument.createElement('div');
  corner.ariaHidden = 'true';
  corner.style.cssText = 'position: absolute; inset: 0; visibility: hidden; pointer-events: none';
  for (const [across, down] of corners) {
    const mark = corner.appendChild(element.ownerDocument.createElement('i'));
    mark.style.cssText = `position: absolute; left: ${100 * across}%; top: ${100 * down}%; width: 0; height: 0`;
  }
  (element.shadowRoot ?? element).append(corner);
  markers.set(element, corner);
  return corner;
}
