// Two moments of a radar in one texture, whose holes differ: the GPU's picture against the twin's, which reads them one by one.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import type { PolarVolume } from '../../../src/volume/volume.ts';
import { casesIn } from '../../helpers/cases.ts';
import { compareWithTwin } from '../../helpers/compare-with-twin.ts';
import { overlayOf } from '../../helpers/overlays.ts';
import { comparePictures, drawPicture, plainOptics, shareScene } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import type { SampleKind } from '../../helpers/synthetic.ts';
import { evenAzimuths, radarVolume } from '../../helpers/synthetic-radar.ts';

const sweeps = [2, 8, 16, 26, 40].map((elevation) => ({ elevation, azimuths: evenAzimuths(40), gates: 24 }));

/** Waves from 8 to 83 % of what a kind stores; none where the radar looks to the north-east, and here and there. */
function reflectivity(kind: SampleKind, phase = 0): PolarVolume {
  const [full, none] = { uint8: [250, 0], uint16: [64000, 0], float32: [1, NaN] }[kind];
  const stored = (azimuth: number, gate: number): number => {
    const value = full * (0.46 + 0.375 * Math.sin(azimuth / 40 + gate / 6 + phase));
    return azimuth < 60 || (gate % 7 === 3 && azimuth < 170) ? none : kind === 'float32' ? value : Math.round(value);
  };
  return radarVolume({
    beamWidth: 4,
    sweeps: sweeps.map((sweep) => ({ ...sweep, kind, slope: 120 / full, intercept: -32, stored })),
  });
}

/** It has none elsewhere. */
const velocity = radarVolume({
  beamWidth: 4,
  moments: [['VRADH', 'velocity']],
  sweeps: sweeps.map((sweep) => ({
    ...sweep,
    nyquist: 16,
    slope: 0.125,
    intercept: -16,
    stored: (azimuth: number, gate: number) =>
      (gate % 9 === 4 && azimuth > 200) || gate > 20 ? 0 : 1 + ((Math.round(2 * azimuth + 5 * gate) + 250) % 250),
  })),
});

const colors = [
  { value: -16, color: [0, 1, 0.6], opacity: 1 },
  { value: 0, color: [0.5, 0.5, 0.5], opacity: 1 },
  { value: 16, color: [1, 0.2, 0.1], opacity: 1 },
] as const;

function viewOf(volume: PolarVolume): View {
  const diagonal = longestDiagonal(volume.grid);
  const optics = {
    ...plainOptics,
    referenceLength: diagonal / 30,
    transferFunction: plainOptics.transferFunction.map((stop) => ({ ...stop, value: -32 + 80 * stop.value })),
  };
  return {
    volume,
    camera: orbitCamera({ theta: 0.4, phi: 1, radius: 1.3 * diagonal }, boundingSphere(volume.grid).center, 0.6),
    stepLength: diagonal / 80,
    optics,
  };
}

for (const version of [2, 1] as const) {
  describe(`two moments in one texture, WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });

    const show = async (over: PolarVolume): Promise<View> => {
      const overlay = overlayOf(over, velocity, {
        blend: 'color',
        missing: [0.55, 0.55, 0.55],
        transferFunction: colors,
      });
      await scene().prepare(over);
      await scene().setOverlay(overlay);
      return { ...viewOf(over), overlay };
    };

    for (const kind of casesIn(version, ['uint8', 'uint16', 'float32'] as const, (one) => one === 'uint16')) {
      it(`of ${kind}: colours are the twin's, opacity is that of the first one's own texture, and skipping changes no byte`, async () => {
        const over = reflectivity(kind);
        await scene().prepare(over);
        await scene().setOverlay(null);
        const alone = drawPicture(scene(), viewOf(over));
        const shown = await show(over);
        const got = compareWithTwin(scene(), shown, `WebGL ${version} ${kind}`);
        const alpha = (picture: Uint8ClampedArray): Uint8ClampedArray => picture.filter((_, i) => i % 4 === 3);
        expect(Math.max(...alpha(alone))).to.be.above(100);
        expect(comparePictures(alpha(got), alpha(alone)).worst, 'opacity').to.be.at.most(1);
        expect(comparePictures(got, alone).worst, 'colours').to.be.above(60);
        scene().layers[0].skipping = false;
        const all = drawPicture(scene(), shown);
        scene().layers[0].skipping = true;
        expect(comparePictures(drawPicture(scene(), shown), all).worst, 'skipping').to.equal(0);
      });
    }

    it('is made again for another scan under the same second moment', async () => {
      await show(reflectivity('uint8'));
      const shown = await show(reflectivity('uint8', 2));
      compareWithTwin(scene(), shown, `WebGL ${version} another scan`);
    });
  });
}
