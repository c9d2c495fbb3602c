import { expect } from '@esm-bundle/chai';
import { drawPlot } from '../../bench/plot.mjs';

const kinds = [
  { shape: 'square', name: 'fixed', labels: 'above' },
  { shape: 'circle', name: 'chosen', labels: 'below' },
  { shape: 'triangle', name: 'moving', labels: 'below' },
] as const;

const panels = [
  {
    title: 'First & <last>',
    lines: [
      [
        { x: 10, y: 100, label: 'a' },
        { x: 100, y: 1, label: 'b' },
        { x: 1000, y: 0.01, label: 'c' },
      ],
      [
        { x: 50, y: 3, label: '8' },
        { x: 50, y: 3.01, label: '4' },
        { x: 400, y: 0.2, label: '1' },
      ],
      [],
    ],
  },
  { title: 'Second', lines: [[{ x: 100, y: 1, label: 'd' }], [], []] },
];

function draw(shown: typeof panels = panels): Element {
  const text = drawPlot({
    title: 'Time "and" error',
    description: 'a < b',
    xName: 'ms',
    yName: '1/255',
    kinds,
    panels: shown,
  });
  const { documentElement } = new DOMParser().parseFromString(text, 'image/svg+xml');
  expect(documentElement.querySelector('parsererror')?.textContent).to.equal(undefined);
  return documentElement;
}

const number = (element: Element, name: string): number => Number(element.getAttribute(name));
const listLabels = (within: Element): (string | null)[] =>
  [...within.querySelectorAll('.label')].map((label) => label.textContent);

describe('the plot of a bench program', () => {
  it('is an SVG picture with words for those who do not see it', () => {
    const svg = draw();
    expect(svg.getAttribute('role')).to.equal('img');
    const words = svg
      .getAttribute('aria-labelledby')!
      .split(' ')
      .map((id) => svg.querySelector(`#${id}`)!.textContent);
    expect(words).to.deep.equal(['Time "and" error', 'a < b']);
    expect([...svg.querySelectorAll('.title')].map((title) => title.textContent)).to.deep.equal([
      'First & <last>',
      'Second',
    ]);
    for (const { name } of kinds)
      expect(
        [...svg.querySelectorAll('text')].some((text) => text.textContent === name),
        name,
      ).to.equal(true);
  });

  it('puts marks at their logarithms, smaller errors further down, all panels alike, within the frame', () => {
    const svg = draw();
    const lines = [...svg.querySelectorAll('polyline')].map((line) =>
      line
        .getAttribute('points')!
        .split(' ')
        .map((point) => point.split(',').map(Number)),
    );
    const [[a, b, c], , , [d]] = lines;
    expect(b[0] - a[0]).to.be.closeTo(c[0] - b[0], 0.2);
    expect(b[1] - a[1]).to.be.closeTo(c[1] - b[1], 0.2);
    expect(b[0] - a[0]).to.be.above(50);
    expect(b[1] - a[1]).to.be.above(50);
    expect(d, 'the same numbers in another panel').to.deep.equal(b);
    const hundred = [...svg.querySelectorAll('.tick')].find(
      (tick) => tick.textContent === '100' && tick.getAttribute('text-anchor') === 'middle',
    )!;
    expect(number(hundred, 'x')).to.be.closeTo(b[0], 0.1);
    const frame = svg.querySelector('.frame')!;
    for (const [x, y] of [a, b, c]) {
      expect(x).to.be.within(number(frame, 'x'), number(frame, 'x') + number(frame, 'width'));
      expect(y).to.be.within(number(frame, 'y'), number(frame, 'y') + number(frame, 'height'));
    }
    expect(svg.querySelectorAll('circle.mark').length, 'with the one in the legend').to.equal(4);
  });

  it('writes one label where marks lie on each other', () => {
    expect(listLabels(draw())).to.deep.equal(['a', 'b', 'c', '8, 4', '1', 'd']);
  });

  it('shows a single mark, and refuses what has no logarithm', () => {
    expect(listLabels(draw([panels[1]]))).to.deep.equal(['d']);
    const zero = [{ title: '', lines: [[{ x: 0, y: 1, label: '' }], [], []] }];
    expect(() => draw(zero)).to.throw(RangeError, 'above zero');
    expect(() => draw([])).to.throw(RangeError);
  });
});
