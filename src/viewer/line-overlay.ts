import { viewMatrix } from '../optics/camera.ts';
import type { Camera } from '../optics/camera.ts';
import { add, scale, subtract, transformPoint } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import type { SeenPicture } from './drag-place.ts';
import { projectPlace } from './project-place.ts';

const svg = 'http://www.w3.org/2000/svg';

/** Lines are cut so far before the eye, as a share of its distance from what it looks at. */
const nearest = 1e-3;

/** What stands beside a place: a length, say. */
export interface OverlayText {
  readonly at: Vector3;
  readonly text: string;
}

/** Faint lines and a text over a picture, where the scene's own may be hidden by what is before them. They take no clicks. */
export class LineOverlay {
  readonly #drawing: SVGElement;
  readonly #halo: SVGElement;
  readonly #line: SVGElement;
  readonly #text: SVGElement;

  constructor(picture: Element) {
    const make = (name: string, attributes: Readonly<Record<string, string>>): SVGElement => {
      const element = picture.ownerDocument.createElementNS(svg, name);
      for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
      return element;
    };
    this.#drawing = make('svg', { 'aria-hidden': 'true', part: 'measure' });
    this.#drawing.style.cssText = 'position: absolute; inset: 0; inline-size: 100%; block-size: 100%; overflow: hidden; pointer-events: none';
    this.#halo = make('path', { fill: 'none', stroke: '#000', 'stroke-width': '3.5', 'stroke-opacity': '0.3' });
    this.#line = make('path', { fill: 'none', 'stroke-width': '1.5', 'stroke-opacity': '0.75', 'stroke-dasharray': '5 4' });
    this.#text = make('text', { 'text-anchor': 'middle', 'paint-order': 'stroke', 'stroke-width': '4', 'stroke-linejoin': 'round', stroke: '#10141c', fill: '#fff' });
    this.#text.style.cssText = 'font: 600 13px system-ui, sans-serif; font-variant-numeric: tabular-nums; direction: ltr';
    this.#drawing.append(this.#halo, this.#line, this.#text);
    picture.after(this.#drawing);
  }

  /**
   * Draw lines where a picture shows them.
   * @param picture - null for none
   * @param color - CSS
   */
  show(picture: SeenPicture | null, lines: readonly (readonly Vector3[])[], color: string, text: OverlayText | null): void {
    const path = picture ? lines.map((line) => writeLine(picture, line)).join('') : '';
    for (const one of [this.#halo, this.#line]) one.setAttribute('d', path);
    this.#line.setAttribute('stroke', color);
    const at = picture && text && projectPlace(picture.camera, text.at, picture);
    this.#text.textContent = at ? text.text : '';
    if (!at) return;
    this.#text.setAttribute('x', at[0].toFixed(2));
    this.#text.setAttribute('y', (at[1] - 10).toFixed(2));
  }

  remove(): void {
    this.#drawing.remove();
  }
}

/** The path of a line, without what is behind the eye. */
function writeLine(picture: SeenPicture, line: readonly Vector3[]): string {
  let path = '';
  let last = '';
  for (let i = 1; i < line.length; i++) {
    const [from, to] = clip(picture.camera, line[i - 1], line[i]) ?? [];
    if (!from || !to) continue;
    const [start, end] = [from, to].map((place) => projectPlace(picture.camera, place, picture)?.map((pixels) => pixels.toFixed(1)).join(' ') ?? '');
    path += start === last ? `L${end}` : `M${start}L${end}`;
    last = end;
  }
  return path;
}

/** The part of a line that is before the eye. */
function clip(camera: Camera, from: Vector3, to: Vector3): readonly [Vector3, Vector3] | null {
  const view = viewMatrix(camera);
  const least = nearest * Math.hypot(...subtract(camera.eye, camera.target));
  const [a, b] = [from, to].map((place) => -transformPoint(view, place)[2] - least);
  if (a <= 0 && b <= 0) return null;
  const between = add(from, scale(subtract(to, from), a / (a - b)));
  return [a > 0 ? from : between, b > 0 ? to : between];
}
