// The cross of a readout, and the name beside it.
import { expect } from '@esm-bundle/chai';
import { Marker } from '../../../../components/volume-readout/volume-readout-marker.ts';

it('a label is named next to the cross, inside the picture wherever the cross is, and without a name there is none', () => {
  const picture = document.body.appendChild(document.createElement('div'));
  picture.style.cssText = 'position: relative; width: 280px; height: 200px';
  const marker = new Marker(picture);
  const name = picture.querySelector<HTMLElement>('[part=marker-name]')!;
  expect(picture.querySelector('[part=marker]')!.ariaHidden).to.equal('true');
  const box = picture.getBoundingClientRect();
  for (const place of [
    [20, 20],
    [139, 99],
    [141, 101],
    [260, 190],
    [260, 10],
    [10, 190],
  ] as const) {
    marker.show(place);
    marker.setName('Primary somatosensory cortex, middle (area 1)');
    const { left, right, top, bottom } = name.getBoundingClientRect();
    expect(name.textContent).to.equal('Primary somatosensory cortex, middle (area 1)');
    expect(
      [left >= box.left, right <= box.right, top >= box.top, bottom <= box.bottom, right - left > 60],
      String(place),
    ).to.deep.equal([true, true, true, true, true]);
  }
  marker.setName('<b>no markup</b>');
  expect(name.children.length).to.equal(0);
  marker.setName(null);
  expect(name.getBoundingClientRect().width).to.equal(0);
  marker.remove();
  picture.remove();
});
