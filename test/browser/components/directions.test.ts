// In a page that is written from right to left, scales still rise to the right, and stay where their colours are.
import { expect } from '@esm-bundle/chai';
import '../../../components/volume-legend/define.ts';
import '../../../components/volume-transfer-function/define.ts';
import type { VolumeLegend } from '../../../components/volume-legend/volume-legend.ts';

/** As much of a <volume-view> as its companions look at. */
class FakeView extends HTMLElement {
  appearance = { transferFunction: null, opacityFactor: null, lightFactor: null };
  volume = { histogram: { low: 0, high: 100, counts: new Uint32Array(10).fill(5) }, range: [0, 100], unit: 'g' };
  optics = {
    transferFunction: [
      { value: 0, color: [0, 0, 1], opacity: 0 },
      { value: 100, color: [1, 0, 0], opacity: 1 },
    ],
    window: [0, 100],
    opacityFactor: 1,
    lightFactor: 1,
  };
}
customElements.define('volume-view', FakeView);

async function show(dir: string): Promise<Element[]> {
  document.body.innerHTML = `<div dir="${dir}" style="inline-size: 400px"><volume-view></volume-view><volume-legend></volume-legend><volume-transfer-function></volume-transfer-function></div>`;
  const elements = [...document.querySelectorAll('volume-legend, volume-transfer-function')];
  await Promise.all(elements.map((element) => (element as VolumeLegend).updateComplete));
  return elements;
}

/** Where something lies in something else, as a share of its width. */
function shareOf(part: Element, whole: Element): number {
  const [a, b] = [part.getBoundingClientRect(), whole.getBoundingClientRect()];
  return ((a.left + a.right) / 2 - b.left) / b.width;
}

for (const dir of ['ltr', 'rtl']) {
  it(`${dir}: numbers and handles stand where their values are`, async () => {
    const [legend, editor] = (await show(dir)).map((element) => element.shadowRoot!);
    const [bar] = legend.querySelectorAll('.bar');
    const tick = [...legend.querySelectorAll('.ticks span')].find(({ textContent }) => textContent === '20')!;
    expect(shareOf(tick, bar)).to.be.closeTo(0.2, 0.01);
    const plot = editor.querySelector('.plot')!;
    const [first, last] = editor.querySelectorAll('.handle');
    expect(shareOf(first, plot)).to.be.below(0.1);
    expect(shareOf(last, plot)).to.be.above(0.9);
  });
}
