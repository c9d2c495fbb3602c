// A second field: the GPU's picture against the twin's, and that skipping changes no byte.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { ShownOverlay } from '../../../src/optics/attachments/overlay.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../src/volume/macrocells.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { casesIn } from '../../helpers/cases.ts';
import { compareWithTwin } from '../../helpers/compare-with-twin.ts';
import { askew, overlayOf, signed, waves } from '../../helpers/overlays.ts';
import { comparePictures, drawPicture, plainOptics, shareScene } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { evenAzimuths, radarVolume } from '../../helpers/synthetic-radar.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';
import { viewFromAbove } from '../../helpers/views.ts';

const dimensions: Vector3 = [24, 20, 16];
const volume = syntheticVolume({ dimensions, kind: 'uint16' });
const view = viewFromAbove(volume);

/** On a coarser grid that lies askew; with a hole where it is of floats. */
function layer(kind: 'uint8' | 'uint16' | 'float32', holed = false): Volume {
  const own: Vector3 = [14, 12, 18];
  const made = syntheticVolume({
    dimensions: own,
    kind,
    indexToWorld: askew(volume, own),
    field: kind === 'float32' ? waves : (x, y, z) => 0.5 + 0.5 * waves(x, y, z),
    ...(kind === 'float32' ? {} : { slope: 2, intercept: -1 }),
  });
  if (!holed) return made;
  made.samples.forEach((_, at) => {
    if (at % 14 < 4) made.samples[at] = NaN;
  });
  return { ...made, hasNoData: true, macrocells: buildMacrocells(made.samples, own) };
}

const layers: readonly (readonly [string, ShownOverlay])[] = [
  ['mix, 8 bits', overlayOf(volume, layer('uint8'))],
  ['mix, 16 bits', overlayOf(volume, layer('uint16'), { opacityFactor: 0.5 })],
  ['color, floats', overlayOf(volume, layer('float32'), { blend: 'color' })],
  [
    'color, floats with a hole',
    overlayOf(volume, layer('float32', true), { blend: 'color', missing: [0.4, 0.5, 0.4] }),
  ],
  ['mix, floats with a hole', overlayOf(volume, layer('float32', true))],
];

for (const version of [2, 1] as const) {
  describe(`a second field in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });

    for (const [name, overlay] of casesIn(version, layers, ([name]) =>
      ['mix, 16 bits', 'color, floats with a hole'].includes(name),
    )) {
      it(`${name}: the picture is the twin's, and another one than without`, async () => {
        await scene().setOverlay(null);
        const before = drawPicture(scene(), view);
        await scene().setOverlay(overlay);
        const got = compareWithTwin(scene(), { ...view, overlay }, `WebGL ${version} ${name}`);
        expect(comparePictures(got, before).worst).to.be.above(20);
      });
    }

    it('of floats with a hole looks the same where the device filters no floats', async () => {
      const device = scene().layers[0].device as { floatLinear: boolean };
      const pictures: Uint8ClampedArray[] = [];
      for (const floatLinear of [true, false]) {
        const had = device.floatLinear;
        expect(had, 'this device does').to.equal(true);
        device.floatLinear = floatLinear;
        await scene().setOverlay(overlayOf(volume, layer('float32', true)));
        device.floatLinear = had;
        pictures.push(drawPicture(scene(), view));
      }
      expect(comparePictures(pictures[0], pictures[1]).worst).to.be.at.most(1);
    });
  });
}

for (const version of [2, 1] as const) {
  describe(`a radar's second moment in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });

    it('colours the first one as its twin says, across folds and next to gates that have none', async () => {
      const sweeps = [2, 8, 16, 26, 40].map((elevation) => ({ elevation, azimuths: evenAzimuths(40), gates: 24 }));
      const over = radarVolume({
        beamWidth: 4,
        sweeps: sweeps.map((sweep) => ({
          ...sweep,
          stored: (azimuth: number, gate: number) => 30 + Math.round(80 + 70 * Math.sin(azimuth / 40 + gate / 6)),
        })),
      });
      const velocity = radarVolume({
        beamWidth: 4,
        moments: [['VRADH', 'velocity']],
        sweeps: sweeps.map((sweep) => ({
          ...sweep,
          nyquist: 16,
          slope: 0.125,
          intercept: -16,
          stored: (azimuth: number, gate: number) =>
            gate % 9 === 4 && azimuth > 200 ? 0 : 1 + ((Math.round(2 * azimuth + 5 * gate) + 250) % 250),
        })),
      });
      const plain = scene();
      await plain.prepare(over);
      const diagonal = longestDiagonal(over.grid);
      const { center } = boundingSphere(over.grid);
      const optics = {
        ...plainOptics,
        referenceLength: diagonal / 30,
        transferFunction: plainOptics.transferFunction.map((stop) => ({ ...stop, value: -32 + 80 * stop.value })),
      };
      const shown: View = {
        volume: over,
        camera: orbitCamera({ theta: 0.4, phi: 1, radius: 1.3 * diagonal }, center, 0.6),
        stepLength: diagonal / 80,
        optics,
      };
      await plain.setOverlay(null);
      const before = drawPicture(plain, shown);
      const colors: ShownOverlay['transferFunction'] = [
        { value: -16, color: [0, 1, 0.6], opacity: 1 },
        { value: 0, color: [0.5, 0.5, 0.5], opacity: 1 },
        { value: 16, color: [1, 0.2, 0.1], opacity: 1 },
      ];
      const overlay = overlayOf(over, velocity, {
        blend: 'color',
        missing: [0.55, 0.55, 0.55],
        transferFunction: colors,
      });
      await plain.setOverlay(overlay);
      const got = compareWithTwin(plain, { ...shown, overlay }, `WebGL ${version} second moment`);
      expect(comparePictures(got, before).worst).to.be.above(60);
      const [opacity, opacityBefore] = [got, before].map((picture) => picture.filter((_, i) => i % 4 === 3));
      expect(comparePictures(opacity, opacityBefore).worst, "the opacity is the first one's").to.be.at.most(1);
    });
  });
}

describe('a second field', () => {
  const scene = shareScene({});

  it('is not shown over another volume, nor in a projection, nor when it is gone', async () => {
    await scene().setOverlay(null);
    const other = viewFromAbove(syntheticVolume({ dimensions: [8, 8, 8] }));
    const [before, plain] = [drawPicture(scene(), other), drawPicture(scene(), view)];
    await scene().setOverlay(layers[0][1]);
    expect(comparePictures(drawPicture(scene(), other), before).worst).to.equal(0);
    await scene().setOverlay(null);
    expect(comparePictures(drawPicture(scene(), view), plain).worst).to.equal(0);
  });

  it('of the volume itself at half the opacity factor comes to the volume once', async () => {
    await scene().setOverlay(null);
    const once = drawPicture(scene(), view);
    await scene().setOverlay(overlayOf(volume, volume, { transferFunction: plainOptics.transferFunction }));
    expect(
      comparePictures(drawPicture(scene(), { ...view, optics: { ...plainOptics, opacityFactor: 0.5 } }), once).worst,
    ).to.be.at.most(1);
  });

  it('shows where the volume shows nothing, and what is empty of both is skipped without a byte being another', async () => {
    const large = syntheticVolume({ dimensions: [48, 40, 40], kind: 'float32', field: (x) => (x < 0.3 ? NaN : 0.1) });
    const over = { ...large, hasNoData: true, macrocells: buildMacrocells(large.samples, [48, 40, 40]) };
    const own: Vector3 = [40, 40, 40];
    const spot = syntheticVolume({
      dimensions: own,
      kind: 'float32',
      indexToWorld: askew(over, own, 1.2),
      field: (x, y, z) => Math.exp(-60 * ((x - 0.3) ** 2 + (y - 0.5) ** 2 + (z - 0.6) ** 2)),
    });
    await scene().setOverlay(overlayOf(over, spot));
    for (const steps of [60, 15]) {
      const shown = { ...viewFromAbove(over), stepLength: longestDiagonal(over.grid) / steps };
      const [skipped, all] = [true, false].map((skipping) => {
        scene().layers[0].skipping = skipping;
        return drawPicture(scene(), shown);
      });
      expect(Math.max(...all)).to.be.above(60);
      expect(comparePictures(skipped, all).worst, `${steps} steps`).to.equal(0);
    }
    const seen = scene().whatIsSeen()!.cells;
    expect(seen.some((cell) => cell === 1)).to.equal(true);
    expect(seen.filter((cell) => cell === 1).length).to.be.below(0.6 * seen.length);
    await scene().setOverlay(overlayOf(over, spot, { transferFunction: signed.slice(0, 2) }));
    expect(
      scene()
        .whatIsSeen()!
        .cells.every((cell) => cell === 0),
    ).to.equal(true);
  });

  it('of single bright voxels, of any size and anywhere, is skipped around without a byte being another', async () => {
    const random = randomNumbers(78);
    const numbers = (min: number, max: number): Vector3 =>
      [0, 1, 2].map(() => Math.floor(min + random() * (max - min))) as unknown as Vector3;
    let shows = 0;
    for (let n = 0; n < 12; n++) {
      const over = syntheticVolume({ dimensions: numbers(8, 60), field: () => 0 });
      const own = numbers(4, 50);
      const kind = (['uint8', 'uint16', 'float32'] as const)[n % 3];
      const rest = n === 2 || n === 8 ? NaN : 0; // Floats with holes.
      const specks = syntheticVolume({
        dimensions: own,
        kind,
        indexToWorld: askew(over, own, 0.2 + 1.6 * random()),
        field: () => (random() < 0.003 ? 1 : random() < 0.9 ? rest : 0),
      });
      const transferFunction = [0, 0.3 + 0.5 * random(), 1].map(
        (value) => ({ value, color: [1, 1, 0], opacity: value === 1 ? 0.6 : 0 }) as const,
      );
      await scene().setOverlay(overlayOf(over, specks, { transferFunction }));
      const shown = {
        ...viewFromAbove(over),
        optics: { ...plainOptics, transferFunction: signed },
        stepLength: longestDiagonal(over.grid) / (n % 2 ? 40 : 200),
      };
      const [skipped, all] = [true, false].map((skipping) => {
        scene().layers[0].skipping = skipping;
        return drawPicture(scene(), shown);
      });
      expect(comparePictures(skipped, all).worst, `layer ${n}, ${kind}`).to.equal(0);
      if (Math.max(...all) > 20) shows++;
    }
    expect(shows, 'layers of which something is seen').to.be.above(8);
  });
});
