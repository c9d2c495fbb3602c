const svg = 'http://www.w3.org/2000/svg';

/** Four lines around a gap, in a box of 25 by 25. */
const lines = 'M0 12.5H8.5M16.5 12.5H25M12.5 0V8.5M12.5 16.5V25';

/** Distance from the middle of the cross to the name, with its margin, CSS pixels. */
const besideCross = 16;

/**
 * A cross over a picture. It shows the place of the readout, and the name of the part at that place. It takes no clicks, and no room in the
 * layout. It is hidden from screen readers, as they read the readout.
 */
export class Marker {
  readonly #element = document.createElement('div');
  readonly #name = document.createElement('div');

  /** @param picture - the part of a view that contains its picture */
  constructor(picture: Element) {
    const element = this.#element;
    element.ariaHidden = 'true';
    element.setAttribute('part', 'marker');
    element.style.cssText =
      'display: none; position: absolute; inline-size: 25px; block-size: 25px; translate: -50% -50%; pointer-events: none; color: var(--volume-view-marker-color, #fff)';
    const drawing = element.appendChild(document.createElementNS(svg, 'svg'));
    drawing.setAttribute('viewBox', '0 0 25 25');
    drawing.style.cssText = 'display: block; inline-size: 100%; block-size: 100%';
    // Bright on dark: it is visible on any picture.
    for (const [color, width] of [
      ['#000', '4'],
      ['currentColor', '1.5'],
    ]) {
      const path = drawing.appendChild(document.createElementNS(svg, 'path'));
      path.setAttribute('d', lines);
      path.setAttribute('stroke', color);
      path.setAttribute('stroke-width', width);
    }
    const name = element.appendChild(this.#name);
    name.setAttribute('part', 'marker-name');
    name.dir = 'auto';
    name.style.cssText =
      'position: absolute; inline-size: max-content; box-sizing: border-box; padding: 0.1em 0.5em; border-radius: 4px; background: rgb(0 0 0 / 72%); color: #fff; font: 13px / 1.4 system-ui, sans-serif; overflow-wrap: anywhere';
    picture.append(element);
  }

  /** @param place - CSS pixels from the left and top edge; null to hide the cross */
  show(place: readonly [x: number, y: number] | null): void {
    const { style, parentElement } = this.#element;
    style.display = place ? 'block' : 'none';
    if (!place) return;
    [style.left, style.top] = place.map((pixels) => `${pixels.toFixed(2)}px`);
    // The name goes to the side, and above or below, where there is more room.
    const [width, height] = [parentElement!.clientWidth, parentElement!.clientHeight];
    const [isRight, isLow] = [place[0] > width / 2, place[1] > height / 2];
    const room = Math.max(0, (isRight ? place[0] : width - place[0]) - besideCross);
    Object.assign(this.#name.style, {
      maxInlineSize: `min(14em, ${room}px)`,
      left: isRight ? 'auto' : '100%',
      right: isRight ? '100%' : 'auto',
      top: isLow ? 'auto' : '100%',
      bottom: isLow ? '100%' : 'auto',
    });
  }

  /** @param name - of the part at the place; null for none */
  setName(name: string | null): void {
    this.#name.hidden = !name;
    this.#name.textContent = name;
  }

  remove(): void {
    this.#element.remove();
  }
}
