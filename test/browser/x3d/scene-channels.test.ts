// Several channels as colours: the GPU's picture against the twin's, with labels and with a layer over it.
import { expect } from '@esm-bundle/chai';
import { compareWithTwin } from '../../helpers/compare-with-twin.ts';
import { channelVolume, colorVolume } from '../../helpers/channels.ts';
import { askew, overlayOf, waves } from '../../helpers/overlays.ts';
import { comparePictures, drawPicture, plainOptics, shareScene } from '../../helpers/picture.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { viewFromAbove } from '../../helpers/views.ts';

const volume = channelVolume([24, 20, 16]);
const optics = {
  ...plainOptics,
  referenceLength: 6,
  transferFunction: [
    { value: 0, color: [1, 1, 1], opacity: 0 },
    { value: 3, color: [1, 1, 1], opacity: 0.6 },
  ] as const,
};
const view = viewFromAbove(volume, { optics });

for (const version of [2, 1] as const)
  describe(`channels as colours in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    before(() => scene().prepare(volume));

    it('look as their twin says, and not gray', () => {
      const got = compareWithTwin(scene(), view, `channels, WebGL ${version}`);
      const { channels: _, ...plain } = volume;
      expect(comparePictures(got, drawPicture(scene(), { ...view, volume: plain })).worst).to.be.above(60);
    });

    it('keep their place where the transfer function has colours, and jumps', () => {
      const transferFunction = [
        { value: 0.3, color: [1, 0.5, 0.2], opacity: 0 },
        { value: 0.8, color: [1, 0.5, 0.2], opacity: 0.3 },
        { value: 0.8, color: [0.4, 1, 1], opacity: 0.9 },
      ] as const;
      compareWithTwin(scene(), { ...view, optics: { ...optics, transferFunction } }, 'channels with a jump');
    });

    it('of a file look as their twin says, and not gray', async () => {
      const colored = colorVolume([24, 20, 16]);
      await scene().prepare(colored);
      const transferFunction = [
        { value: 0, color: [1, 1, 1], opacity: 0 },
        { value: 255, color: [1, 1, 1], opacity: 0.6 },
      ] as const;
      const inColors = { ...viewFromAbove(colored, { optics }), optics: { ...optics, transferFunction } };
      const got = compareWithTwin(scene(), inColors, `colours, WebGL ${version}`);
      const { channels: _, ...plain } = colored;
      expect(comparePictures(got, drawPicture(scene(), { ...inColors, volume: plain })).worst).to.be.above(60);
      await scene().prepare(volume);
    });

    it('are under a layer as any volume is', async () => {
      const own = [14, 12, 18] as const;
      const layer = syntheticVolume({
        dimensions: own,
        kind: 'uint8',
        indexToWorld: askew(volume, own),
        field: (x, y, z) => 0.5 + 0.5 * waves(x, y, z),
        slope: 2,
        intercept: -1,
      });
      const overlay = overlayOf(volume, layer);
      await scene().setOverlay(overlay);
      compareWithTwin(scene(), { ...view, overlay }, 'channels under a layer');
      await scene().setOverlay(null);
    });
  });
