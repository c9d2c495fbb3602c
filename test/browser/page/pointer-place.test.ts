import { expect } from '@esm-bundle/chai';
import { middleInElement, placeInElement, shareInQuad } from '../../../src/page/pointer-place.ts';

/** Where a matrix of CSS shows places, in perspective too. */
const show = (css: string, places: readonly (readonly [number, number])[]): [number, number][] =>
  places.map(([x, y]) => new DOMMatrix(css).transformPoint(new DOMPoint(x, y))).map(({ x, y, w }) => [x / w, y / w]);

it('finds a point in a square that is seen turned, mirrored and in perspective', () => {
  for (const css of [
    'none',
    'translate(5px, -3px) scale(2, 0.5)',
    'rotate(77deg)',
    'matrix(0, 3, 2, 0, 1, 1)',
    'skewX(40deg)',
    'perspective(3px) rotateY(50deg) rotateX(-20deg)',
  ]) {
    const quad = show(css, [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ]);
    for (const place of [
      [0, 0],
      [1, 1],
      [0.25, 0.7],
      [-0.2, 1.3],
    ] as const) {
      const [[x, y]] = [show(css, [place])[0]].map((seen) => shareInQuad(quad, seen)!);
      expect(x, css).to.be.closeTo(place[0], 1e-9);
      expect(y, css).to.be.closeTo(place[1], 1e-9);
    }
  }
});

it('has no place in what is seen edge-on', () => {
  expect(
    shareInQuad(
      [
        [0, 0],
        [1, 1],
        [1, 1],
        [0, 0],
      ],
      [0.5, 0.5],
    ),
  ).to.equal(null);
});

it('gives pixels of the element itself, in a shadow root of one too, and leaves one mark in it', () => {
  const around = document.body.appendChild(document.createElement('div'));
  around.style.cssText =
    'position: fixed; left: 20px; top: 10px; transform-origin: 0 0; transform: rotate(90deg) scale(2)';
  const element = around.appendChild(document.createElement('div'));
  element.style.cssText = 'position: relative; width: 100px; height: 50px; border: 4px solid';
  const inner = element.attachShadow({ mode: 'open' }).appendChild(document.createElement('div'));
  inner.style.cssText = 'position: absolute; left: 10px; top: 20px; width: 20px; height: 10px';
  const [point] = show('translate(20px, 10px) rotate(90deg) scale(2) translate(4px, 4px)', [[30, 40]]);
  for (let again = 0; again < 2; again++) {
    const [x, y] = placeInElement(element, { clientX: point[0], clientY: point[1] });
    expect(x).to.be.closeTo(30, 1e-3);
    expect(y).to.be.closeTo(40, 1e-3);
  }
  const middle = middleInElement(element, inner);
  expect(middle[0]).to.be.closeTo(20, 1e-3);
  expect(middle[1]).to.be.closeTo(25, 1e-3);
  expect(element.shadowRoot!.children.length).to.equal(2);
  around.remove();
});
