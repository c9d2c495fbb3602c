const svg = 'http://www.w3.org/2000/svg';

/** Four lines around a gap, in a box of 25 by 25. */
const lines = 'M0 12.5H8.5M16.5 12.5H25M12.5 0V8.5M12.5 16.5V25';

/** A cross over a picture, which shows the place that a readout speaks of. It takes no clicks, and no room. */
export class Marker {
  readonly #element = document.createElement('div');

  /** @param picture - the part of a view that holds its picture */
  constructor(picture: Element) {
    const element = this.#element;
    element.ariaHidden = 'true';
    element.setAttribute('part', 'marker');
    element.style.cssText = 'display: none; position: absolute; inline-size: 25px; block-size: 25px; translate: -50% -50%; pointer-events: none; color: var(--volume-view-marker-color, #fff)';
    const drawing = element.appendChild(document.createElementNS(svg, 'svg'));
    drawing.setAttribute('viewBox', '0 0 25 25');
    drawing.style.cssText = 'display: block; inline-size: 100%; block-size: 100%';
    // Bright on dark: it is seen on any picture.
    for (const [color, width] of [['#000', '4'], ['currentColor', '1.5']]) {
      const path = drawing.appendChild(document.createElementNS(svg, 'path'));
      path.setAttribute('d', lines);
      path.setAttribute('stroke', color);
      path.setAttribute('stroke-width', width);
    }
    picture.append(element);
  }

  /** @param place - CSS pixels from the left and top edge; null for nowhere */
  show(place: readonly [x: number, y: number] | null): void {
    const { style } = this.#element;
    style.display = place ? 'block' : 'none';
    if (!place) return;
    [style.left, style.top] = place.map((pixels) => `${pixels.toFixed(2)}px`);
  }

  remove(): void {
    this.#element.remove();
  }
}
