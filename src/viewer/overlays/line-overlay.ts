import { viewMatrix } from '../../optics/rays/camera.ts';
import type { Camera } from '../../optics/rays/camera.ts';
import { middleInElement } from '../../page/pointer-place.ts';
import { add, scale, subtract, transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Pixel, SeenPicture } from '../camera/drag-place.ts';
import { projectPlace } from '../camera/project-place.ts';

const svg = 'http://www.w3.org/2000/svg';

/** Lines are cut at this distance in front of the eye, as a share of the distance from the eye to the camera's target. */
const nearest = 1e-3;

/** A text next to a place: a length, for instance. */
export interface OverlayText {
  readonly at: Vector3;
  readonly text: string;
  /** Whether the text stands above all lines, instead of at the place itself. */
  readonly isAbove: boolean;
}

/** Distance from a text to its place, and the minimum distances from its middle to the edges of the picture, CSS pixels. */
const [gap, margin] = [10, { x: 50, top: 16, bottom: 6 }];

/** Faint lines and a text over a picture, for the case that something hides the lines in the scene. They take no clicks. */
export class LineOverlay {
  readonly #drawing: SVGElement;
  readonly #halo: SVGElement;
  readonly #line: SVGElement;
  readonly #text: SVGTextElement;

  /** @param picture - the part of a view that holds its picture */
  constructor(
    picture: Element,
    { part, opacity, isDashed }: { readonly part: string; readonly opacity: number; readonly isDashed: boolean },
  ) {
    const make = <Name extends keyof SVGElementTagNameMap>(
      name: Name,
      attributes: Readonly<Record<string, string>>,
    ): SVGElementTagNameMap[Name] => {
      const element = picture.ownerDocument.createElementNS(svg, name);
      for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
      return element;
    };
    this.#drawing = make('svg', { 'aria-hidden': 'true', part });
    this.#drawing.style.cssText =
      'position: absolute; inset: 0; inline-size: 100%; block-size: 100%; overflow: hidden; pointer-events: none';
    this.#halo = make('path', { fill: 'none', stroke: '#000', 'stroke-width': '3.5', 'stroke-opacity': '0.3' });
    this.#line = make('path', {
      fill: 'none',
      'stroke-width': '1.5',
      'stroke-opacity': String(opacity),
      ...(isDashed && { 'stroke-dasharray': '5 4' }),
    });
    this.#text = make('text', {
      'text-anchor': 'middle',
      'paint-order': 'stroke',
      'stroke-width': '4',
      'stroke-linejoin': 'round',
      stroke: '#10141c',
      fill: '#fff',
    });
    this.#text.style.cssText =
      'font: 600 13px system-ui, sans-serif; font-variant-numeric: tabular-nums; direction: ltr';
    this.#drawing.append(this.#halo, this.#line, this.#text);
    picture.after(this.#drawing);
  }

  /**
   * Draw lines where a picture shows them.
   * @param picture - null for none
   * @param color - CSS
   */
  show(
    picture: SeenPicture | null,
    lines: readonly (readonly Vector3[])[],
    color: string,
    text: OverlayText | null,
  ): void {
    const parts = picture ? lines.flatMap((line) => project(picture, line)) : [];
    const path = parts
      .map((part) => `M${part.map((pixel) => pixel.map((length) => length.toFixed(1)).join(' ')).join('L')}`)
      .join('');
    for (const one of [this.#halo, this.#line]) one.setAttribute('d', path);
    this.#line.setAttribute('stroke', color);
    const at = picture && text && projectPlace(picture.camera, text.at, picture);
    this.#text.textContent = at ? text.text : '';
    if (!at) return;
    const y = text.isAbove ? Math.min(at[1], ...parts.flat().map(([, top]) => top)) : at[1];
    this.#text.setAttribute('x', clamp(at[0], margin.x, picture.width - margin.x).toFixed(1));
    this.#text.setAttribute('y', clamp(y - gap, margin.top, picture.height - margin.bottom).toFixed(1));
    this.#makeRoom();
  }

  /** Hide, for this frame, the labels of range rings that the text would cover: a person asked for the text. */
  #makeRoom(): void {
    const labels = [...(this.#drawing.parentNode?.querySelectorAll<HTMLElement>('.labels > span:not([hidden])') ?? [])];
    if (labels.length === 0) return;
    const view = (this.#drawing.getRootNode() as ShadowRoot).host as HTMLElement;
    const { x, y, width, height } = this.#text.getBBox();
    const [middle, size] = [
      [x + width / 2, y + height / 2],
      [width, height],
    ];
    for (const label of labels) {
      const own = [label.offsetWidth, label.offsetHeight];
      const at = middleInElement(view, label);
      if (at.every((place, axis) => Math.abs(place - middle[axis]) < (own[axis] + size[axis]) / 2)) label.hidden = true;
    }
  }

  remove(): void {
    this.#drawing.remove();
  }
}

/** The parts of a line that are in front of the eye, in pixels. */
function project(picture: SeenPicture, line: readonly Vector3[]): Pixel[][] {
  const parts: Pixel[][] = [];
  for (let i = 1, isOpen = false; i < line.length; i++) {
    const clipped = clip(picture.camera, line[i - 1], line[i]);
    const ends = clipped?.map((place) => projectPlace(picture.camera, place, picture));
    if (!ends?.[0] || !ends[1]) {
      isOpen = false;
      continue;
    }
    if (isOpen) parts[parts.length - 1].push(ends[1]);
    else parts.push([ends[0], ends[1]]);
    isOpen = clipped?.[1] === line[i];
  }
  return parts;
}

function clamp(value: number, min: number, max: number): number {
  return Math.max(min, Math.min(max, value));
}

/** The part of a line that is in front of the eye. */
function clip(camera: Camera, from: Vector3, to: Vector3): readonly [Vector3, Vector3] | null {
  const view = viewMatrix(camera);
  const min = nearest * Math.hypot(...subtract(camera.eye, camera.target));
  const [a, b] = [from, to].map((place) => -transformPoint(view, place)[2] - min);
  if (a <= 0 && b <= 0) return null;
  const between = add(from, scale(subtract(to, from), a / (a - b)));
  return [a > 0 ? from : between, b > 0 ? to : between];
}
