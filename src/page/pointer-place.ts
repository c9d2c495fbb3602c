// From a pointer in the page to a place in an element. Whatever listens to pointers asks here: a page may show the element scaled, zoomed, turned or in perspective,
// by itself or by anything around it, and pixels of the page are not the element's own then.

/** Where a pointer is: an event's. */
export interface PagePoint {
  readonly clientX: number;
  readonly clientY: number;
}

/** A place in an element: its own CSS pixels from the left and the top edge, within its border. */
export type ElementPlace = readonly [x: number, y: number];

/** Shares of width and height at the four corners, in order around the element. */
const corners = [[0, 0], [1, 0], [1, 1], [0, 1]] as const;

/** What marks the corners of an element that has been asked for. */
const markers = new WeakMap<HTMLElement, HTMLElement>();

/**
 * Where in an element a pointer is, whatever transforms, zooms and perspectives of CSS the page has. Along with `clientWidth` and `clientHeight`: a pointer at
 * the lower right corner is there.
 *
 * The browser itself is asked where it shows the corners, as four invisible points in the element: `getBoundingClientRect` of what is turned is the box around it, and
 * no property tells how all that is around the element is transformed.
 * @param element - one that its absolute children are placed in; of one with a shadow root they are in that
 * @returns the element's middle where it is seen edge-on, so that it has no place for a pointer
 */
export function placeInElement(element: HTMLElement, { clientX, clientY }: PagePoint): ElementPlace {
  const marks = [...cornersOf(element).children].map((mark) => mark.getBoundingClientRect());
  const [across, down] = shareInQuad(marks.map(({ left, top }) => [left, top] as const), [clientX, clientY]) ?? [0.5, 0.5];
  return [across * element.clientWidth, down * element.clientHeight];
}

/** Where in an element the middle of something is that stands in it, as `placeInElement` has it. Its `offsetWidth` and `offsetHeight` are the element's own pixels already. */
export function middleInElement(element: HTMLElement, part: Element): ElementPlace {
  const { left, top, width, height } = part.getBoundingClientRect();
  return placeInElement(element, { clientX: left + width / 2, clientY: top + height / 2 });
}

/**
 * Where a point is in a square that has been mapped to four corners by a projective map.
 * Source: P. Heckbert, Fundamentals of Texture Mapping and Image Warping, 1989, section 2.2.3
 * @param quad - where (0, 0), (1, 0), (1, 1) and (0, 1) are
 * @returns shares of the square's sides; null where it has no area
 */
export function shareInQuad([[x0, y0], [x1, y1], [x2, y2], [x3, y3]]: readonly (readonly [x: number, y: number])[], [x, y]: readonly [x: number, y: number]): readonly [number, number] | null {
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
