// Pages in colours with a number that says how opaque a pixel is: colours are shown, and that they are all opaque is said.
import { expect } from '@esm-bundle/chai';
import { rgbOf } from '../../../helpers/channels.ts';
import { lumaOf } from '../../../../src/formats/base/channels.ts';
import { decodeBytes, valuesOf } from '../../../helpers/decode.ts';
import { firstStrip, grayPage, tiffBytes } from '../../../helpers/tiff-bytes.ts';

const colors = [
  [250, 10, 20],
  [30, 200, 40],
  [5, 60, 180],
  [90, 80, 70],
];
const opacities = [255, 0, 128, 255];
const brightness = colors.map(([red, green, blue]) => lumaOf(red, green, blue));
const lost = 'where the image is transparent: its pixels are shown as if they were not';

describe('TIFF pages in colours that are transparent', () => {
  it('in planes have their colours, and it is said', async () => {
    const planes = [0, 1, 2].map((c) => colors.map((color) => color[c]));
    const strip = Uint8Array.from([...planes, opacities].flat());
    const starts = [0, 1, 2, 3].map((i) => firstStrip + 4 * i);
    const page = grayPage(2, 2, strip, {
      258: [3, 8, 8, 8, 8],
      262: [3, 2],
      277: [3, 4],
      284: [3, 2],
      338: [3, 2],
      273: [4, ...starts],
      279: [4, 4, 4, 4, 4],
    });
    const volume = await decodeBytes(tiffBytes([page]), 'planes.tif');
    expect(valuesOf(volume)).to.deep.equal(brightness);
    expect(rgbOf(volume)).to.deep.equal(colors.flat());
    expect(volume.left).to.deep.equal([lost]);
  });

  it('by a table have its colours, and it is said', async () => {
    // Pillow 13.0.0 reads this page as of mode PA, with these colours.
    const map = [0, 1, 2].flatMap((c) => Array.from({ length: 256 }, (_, i) => 257 * (colors[i]?.[c] ?? 0)));
    const strip = Uint8Array.from([0, 1, 2, 3].flatMap((entry, i) => [entry, opacities[i]]));
    const page = grayPage(2, 2, strip, { 258: [3, 8, 8], 262: [3, 3], 277: [3, 2], 338: [3, 2], 320: [3, ...map] });
    const volume = await decodeBytes(tiffBytes([page]), 'table.tif');
    expect(valuesOf(volume)).to.deep.equal(brightness);
    expect(rgbOf(volume)).to.deep.equal(colors.flat());
    expect(volume.left).to.deep.equal([lost]);
  });
});
