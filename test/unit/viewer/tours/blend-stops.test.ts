import { expect } from '@esm-bundle/chai';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { blendStops } from '../../../../src/viewer/tours/blend-stops.ts';

describe('the colours between two steps', () => {
  const from = '20% #000000 0, 24% rgb(100 0 0) 50%, 100% white 0.5';
  const to = '20% #ff0000 1, 24% rgb(200 100 0) 0%, 100% white 50%';

  it('are mixed stop by stop, where the stops are at the same values', () => {
    const blend = blendStops(from, to)!;
    expect(blend(0.5)).to.equal('20% #800000 50%, 24% #963200 25%, 100% #ffffff 50%');
    const ends: [number, string][] = [
      [0, from],
      [1, to],
    ];
    for (const [share, text] of ends) {
      const [got, expected] = [blend(share), text].map((one) => parseTransferFunction(one, [-7, 1300]));
      got.forEach((stop, i) => {
        expect(stop.value).to.equal(expected[i].value);
        expect(stop.opacity).to.be.closeTo(expected[i].opacity, 1e-4);
        stop.color.forEach((channel, c) => expect(channel).to.be.closeTo(expected[i].color[c], 0.5 / 255 + 1e-9));
      });
    }
  });

  it('are not mixed where stops are elsewhere, or there are none', () => {
    expect(blendStops(from, to.replace('24%', '25%'))).to.equal(null);
    expect(blendStops(from, '20% #000 0, 24% #000 0')).to.equal(null);
    expect(blendStops('20 #000 0, 30 #fff 1', '20% #000 0, 30% #fff 1')).to.equal(null); // Other values, though the numbers are the same.
    expect(blendStops(null, to)).to.equal(null);
    expect(blendStops('bone', to)).to.equal(null);
    expect(blendStops(from, null)).to.equal(null);
    expect(blendStops(from, '<img src=x>')).to.equal(null);
  });
});
