// Labels: the GPU's picture against the twin's, and that skipping changes no byte.
import { expect } from '@esm-bundle/chai';
import { plainLabelStops, stopsByPlace } from '../../../src/optics/transfer/label-stops.ts';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { ProjectionKind } from '../../../src/optics/rays/ray-style.ts';
import { allSubsteps } from '../../../src/optics/cells/substeps.ts';
import { boundingSphere } from '../../../src/volume/grid.ts';
import type { LabelMap, ShownLabels } from '../../../src/volume/labels.ts';
import { buildMacrocells } from '../../../src/volume/macrocells.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import type { VolumeViewError } from '../../../src/core/errors.ts';
import { LabelLayer } from '../../../src/renderer/layers/label-layer.ts';
import { casesIn, takesAll } from '../../helpers/cases.ts';
import { changePlan } from '../../helpers/change-plan.ts';
import { compareWithTwin } from '../../helpers/compare-with-twin.ts';
import { blocks, labelMap, mixedGroups, mixedAppearances, plainAppearance } from '../../helpers/labels.ts';
import { comparePictures, drawPicture, plainOptics, shareScene, shells } from '../../helpers/picture.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { viewFromAbove } from '../../helpers/views.ts';

const dimensions: Vector3 = [24, 20, 16];
const view = viewFromAbove(syntheticVolume({ dimensions, kind: 'uint16' }));

/** With a corner that has no data, and a hole in the middle. */
function holed(): Volume {
  const volume = syntheticVolume({ dimensions, kind: 'float32' });
  volume.samples.forEach((_, at) => {
    if (at % 24 < 6 || Math.abs((at % 24) - 15) + Math.abs((Math.floor(at / 24) % 20) - 9) < 4)
      volume.samples[at] = NaN;
  });
  return { ...volume, hasNoData: true, macrocells: buildMacrocells(volume.samples, dimensions) };
}

/** A label file as a volume of its own. */
function named({ numbers }: LabelMap): Volume {
  const samples = Uint8Array.from(numbers, (number) => 36 * number);
  return {
    ...view.volume,
    samples,
    slope: 1 / 255,
    isDiscrete: true,
    macrocells: buildMacrocells(samples, dimensions),
  };
}

for (const version of [2, 1] as const) {
  describe(`labels in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });

    for (const [count, name] of casesIn(
      version,
      [
        [9, '8 bits'],
        [1000, '16 bits'],
      ] as const,
      ([count]) => count === 1000,
    )) {
      it(`${name}: the picture is the twin's, and another one than without`, async () => {
        await scene().setLabels(null);
        const before = drawPicture(scene(), view);
        const labels = mixedAppearances(blocks(dimensions, count));
        await scene().setLabels(labels);
        const got = compareWithTwin(scene(), { ...view, labels }, `WebGL ${version} ${name}`);
        expect(comparePictures(got, before).worst).to.be.above(20);
        const small = { ...view, volume: syntheticVolume({ dimensions: [8, 8, 8] }) };
        const labelled = drawPicture(scene(), small);
        await scene().setLabels(null);
        expect(comparePictures(drawPicture(scene(), small), labelled).worst, 'a volume of other dimensions').to.equal(
          0,
        );
        expect(comparePictures(drawPicture(scene(), view), before).worst, 'afterwards').to.equal(0);
      });
    }

    if (takesAll || version === 2)
      it("next to places without data: the picture is the twin's", async () => {
        const labels = mixedAppearances(blocks(dimensions, 9));
        await scene().setLabels(labels);
        compareWithTwin(scene(), { ...viewFromAbove(holed()), labels }, `WebGL ${version} no data`);
      });

    it("in groups with transfer functions of their own: the picture is the twin's", async () => {
      const labels = mixedGroups(blocks(dimensions, 9));
      const alone = mixedAppearances(labels.map);
      await scene().setLabels(alone);
      const plain = drawPicture(scene(), view);
      await scene().setLabels(labels);
      const got = compareWithTwin(scene(), { ...view, labels }, `WebGL ${version} groups`);
      expect(comparePictures(got, plain).worst).to.be.above(20);
      // What neither the view's table holds, nor bins: near the first stop is a second one.
      const [first, second, third] = shells;
      const transferFunction = [
        first,
        { ...second, value: first.value },
        { ...second, value: first.value + 1e-6 },
        third,
      ];
      const optics = { ...plainOptics, transferFunction, lightFactor: 1.6, opacityFactor: 0.7 };
      compareWithTwin(scene(), { ...viewFromAbove(holed()), labels, optics }, `WebGL ${version} groups, no data`);
      await scene().setLabels(alone);
      expect(comparePictures(drawPicture(scene(), view), plain).worst, 'without them').to.equal(0);
    });

    if (takesAll || version === 2)
      it('hide what is projected', async () => {
        const labels = mixedAppearances(blocks(dimensions, 9));
        for (const projection of ['max', 'average'] as ProjectionKind[]) {
          await scene().setLabels(null);
          await scene().setAppearance({ style: { projection } });
          const before = drawPicture(scene(), view);
          await scene().setLabels(labels);
          const got = compareWithTwin(scene(), { ...view, labels, projection }, `WebGL ${version} ${projection}`);
          expect(comparePictures(got, before).worst).to.be.above(20);
        }
        await scene().setAppearance({ style: null });
      });

    if (takesAll || version === 2)
      it("as a volume of their own: the picture is the twin's", async () => {
        await scene().setLabels(null);
        const volume = named(blocks(dimensions, 7));
        await scene().prepare(volume);
        compareWithTwin(scene(), viewFromAbove(volume), `WebGL ${version} discrete`);
      });

    it("as a volume of thousands of labels: the picture is the twin's, hidden ones are not seen, and each has its colour", async () => {
      await scene().setLabels(null);
      // More columns than fit one row of any texture, with ids that float32 does not tell apart.
      const ids = Array.from({ length: 7000 }, (_, place) => (place === 0 ? 0 : 2 ** 40 + 3 * place));
      const samples = Uint16Array.from({ length: 24 * 20 * 16 }, (_, at) =>
        at % 24 < 3 ? 0 : 1 + ((31 * (at >> 1)) % 6999),
      );
      const volume: Volume = {
        ...view.volume,
        ids,
        samples,
        slope: 1,
        intercept: 0,
        range: [0, 2 ** 41],
        isDiscrete: true,
        macrocells: buildMacrocells(samples, dimensions),
      };
      const stops = plainLabelStops(ids).map((stop) => ({
        ...stop,
        opacity: Math.round((stop.value - 2 ** 40) / 3) % 3 === 0 ? 0 : stop.opacity,
      }));
      const optics = { ...plainOptics, transferFunction: stopsByPlace(stops, ids) };
      await scene().prepare(volume, optics);
      const got = compareWithTwin(
        scene(),
        { ...viewFromAbove(volume), optics },
        `WebGL ${version} thousands of labels`,
      );
      expect(Math.max(...got)).to.be.above(100);
    });
  });
}

describe('labels that do not come to be shown', () => {
  const scene = shareScene({});

  it('leave no texture behind', async () => {
    const { gl, device } = scene().layers[0];
    const there = new Set<WebGLTexture>();
    const made = gl.createTexture.bind(gl);
    gl.createTexture = () => {
      const texture = made();
      there.add(texture);
      return texture;
    };
    gl.deleteTexture = (texture) => {
      there.delete(texture!);
      WebGL2RenderingContext.prototype.deleteTexture.call(gl, texture);
    };
    try {
      const labels = mixedAppearances(blocks(dimensions, 9));
      const tooLarge = await new LabelLayer(gl, { ...device, max3dTextureSize: 8 })
        .show(labels)
        .catch((error: VolumeViewError) => error.code);
      expect(tooLarge).to.equal('format/too-large');
      expect(there.size, 'too large').to.equal(0);
      const layer = new LabelLayer(gl, device);
      const shown = layer.show(labels);
      layer.dispose();
      await shown;
      expect(there.size, 'disposed meanwhile').to.equal(0);
    } finally {
      for (const name of ['createTexture', 'deleteTexture'] as const) Reflect.deleteProperty(gl, name);
    }
  });
});

describe('what is hidden', () => {
  const scene = shareScene({});

  it('is skipped, without a byte of the picture being another', async () => {
    const volume = syntheticVolume({ dimensions: [48, 40, 40] });
    const shown = viewFromAbove(volume);
    // Half of it, and a ball; the rest has blocks of its own.
    const map = labelMap(
      [48, 40, 40],
      (i, j, k) => (i < 20 ? 1 : Math.hypot(i - 34, j - 20, k - 20) < 12 ? 2 : 3 + ((j >> 3) & 1)),
      5,
    );
    const looks = (hidden: readonly number[]): ShownLabels => ({
      map,
      styles: map.ids.map((_, i) => ({ ...plainAppearance, opacityFactor: hidden.includes(i) ? 0 : 1 + i })),
    });
    // Skipping by value as well: only what is bright shows.
    const optics = {
      ...plainOptics,
      transferFunction: [
        { value: 0.5, color: [0, 0, 0], opacity: 0 },
        { value: 0.9, color: [1, 0.8, 0.5], opacity: 0.3 },
      ],
    } as const;
    const pictures = [[], [1], [1, 2], [3, 4], [1, 2, 3, 4]].map((hidden) => [hidden, looks(hidden)] as const);
    for (const stepLength of [shown.stepLength, (20 * shown.stepLength) / 6]) {
      for (const [hidden, labels] of pictures) {
        await scene().setLabels(labels);
        const draw = (skipping: boolean): Uint8ClampedArray => {
          scene().layers[0].skipping = skipping;
          return drawPicture(scene(), { ...shown, optics, stepLength });
        };
        const [with_, without] = [draw(true), draw(false)];
        expect(comparePictures(with_, without).worst, `hidden: ${hidden.join()}`).to.equal(0);
        expect(Math.max(...without), `hidden: ${hidden.join()}`).to[hidden.length === 4 ? 'equal' : 'above'](0);
      }
    }
  });

  it('and so is what no group shows, whichever functions they have', async () => {
    const volume = syntheticVolume({ dimensions: [48, 40, 40] });
    const shown = viewFromAbove(volume);
    const map = labelMap(
      [48, 40, 40],
      (i, j, k) => (i < 16 ? 1 : Math.hypot(i - 34, j - 20, k - 20) < 12 ? 2 : 3 * ((j >> 4) & 1)),
      4,
    );
    const clear = [
      { value: 0.5, color: [1, 1, 1], opacity: 0 },
      { value: 0.9, color: [1, 0.8, 0.5], opacity: 0.3 },
    ] as const;
    const dark = [
      { value: 0.1, color: [0, 0.5, 1], opacity: 0.2 },
      { value: 0.3, color: [0, 0.5, 1], opacity: 0 },
    ] as const;
    const opaque = [
      { value: 0.4, color: [1, 1, 1], opacity: 0 },
      { value: 0.4, color: [0, 1, 0], opacity: 1 },
    ] as const;
    const styles = (hidden: number): ShownLabels['styles'] =>
      [0, 1, 2, 1].map((group, i) => ({ ...plainAppearance, group, opacityFactor: i === hidden ? 0 : 1 }));
    for (const [stepLength, hidden] of [
      [shown.stepLength, 9],
      [4 * shown.stepLength, 2],
    ]) {
      await scene().setLabels({ map, styles: styles(hidden), functions: [dark, opaque] });
      const draw = (skipping: boolean): Uint8ClampedArray => {
        scene().layers[0].skipping = skipping;
        return drawPicture(scene(), { ...shown, optics: { ...plainOptics, transferFunction: clear }, stepLength });
      };
      const [with_, without] = [draw(true), draw(false)];
      expect(comparePictures(with_, without).worst, `hidden: ${hidden}`).to.equal(0);
      const greens = Array.from(without).filter((x, i) => i % 4 === 1 && x > 250).length;
      expect(greens, 'opaque, unless it is hidden')[hidden === 9 ? 'to' : 'not'].be.above(20);
    }
    const { cells } = scene().whatIsSeen()!;
    expect(cells.filter((one) => one === 0).length, 'cells that are empty').to.be.above(5);
  });

  it('is not skipped together with what is clear: between both a long step shows a little', async () => {
    // One cell is clear by its values and the next one by its labels.
    const volume = syntheticVolume({ dimensions: [48, 16, 16], field: (x) => (48 * x < 25 ? 0.1 : 0.9) });
    const shown = {
      ...viewFromAbove(volume),
      camera: orbitCamera({ theta: 1.4, phi: 1.5, radius: 90 }, boundingSphere(volume.grid).center, 0.6),
      stepLength: 5,
    };
    const optics = {
      ...plainOptics,
      transferFunction: [
        { value: 0.4, color: [1, 1, 1], opacity: 0 },
        { value: 0.9, color: [1, 1, 1], opacity: 0.3 },
      ],
    } as const;
    await scene().setLabels({
      map: labelMap([48, 16, 16], (i) => Number(i >= 23), 2),
      styles: [plainAppearance, { ...plainAppearance, opacityFactor: 0 }],
    });
    changePlan(scene(), { substeps: { ...allSubsteps, max: 1 } });
    scene().layers[0].skipping = false;
    const without = drawPicture(scene(), { ...shown, optics });
    scene().layers[0].skipping = true;
    expect(Math.max(...without)).to.be.above(20);
    expect(comparePictures(drawPicture(scene(), { ...shown, optics }), without).worst).to.equal(0);
    changePlan(scene(), { substeps: allSubsteps });
  });

  it('has cells that count as unseen', async () => {
    const volume = syntheticVolume({ dimensions: [16, 4, 4], field: () => 0.8 });
    const map = labelMap([16, 4, 4], (i) => Number(i < 10), 2);
    scene().setVolume(volume);
    const seen = async (factor: number): Promise<number[]> => {
      await scene().setLabels({ map, styles: [plainAppearance, { ...plainAppearance, opacityFactor: factor }] });
      return [...scene().whatIsSeen()!.cells];
    };
    // Voxel 10 is in the third cell, and no voxel beside the second.
    expect(await seen(0)).to.deep.equal([0, 0, 1, 1]);
    expect(await seen(0.5)).to.deep.equal([1, 1, 1, 1]);
  });
});
