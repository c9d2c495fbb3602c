// A second field: how two media are one, where it lies, what is told of bad ones, and what skips empty space knows of it.
import { expect } from '@esm-bundle/chai';
import { colorSliceStops, sliceStops } from '../../../../src/volume/slice-stops.ts';
import type { VolumeViewError } from '../../../../src/core/errors.ts';
import { emission } from '../../../../src/optics/transfer/emission.ts';
import { cartesianOverlay, overlayShade } from '../../../../src/optics/attachments/overlay.ts';
import { listOverlayCells, shownByOverlay } from '../../../../src/optics/cells/overlay-cells.ts';
import type { OverlaidSample, ShownOverlay } from '../../../../src/optics/attachments/overlay.ts';
import { attenuate } from '../../../../src/optics/rays/segment.ts';
import type { Premultiplied } from '../../../../src/optics/transfer/transfer-function.ts';
import { joinPaneLabels } from '../../../../src/panes/join-pane-labels.ts';
import { paneOverlay } from '../../../../src/panes/pane-overlay.ts';
import { resolveOverlayAppearance } from '../../../../src/viewer/appearance/overlay-appearance.ts';
import { placeOverlay } from '../../../../src/viewer/attachments/place-overlay.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { askew, overlayOf, waves } from '../../../helpers/overlays.ts';
import { radarVolume } from '../../../helpers/synthetic-radar.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const volume = syntheticVolume({ dimensions: [24, 20, 16] });
const signed = (over: Volume = volume): Volume =>
  syntheticVolume({ dimensions: [14, 12, 18], kind: 'float32', indexToWorld: askew(over, [14, 12, 18]), field: waves });

/** What a segment of two values of the layer becomes. */
function shade(
  overlay: ShownOverlay,
  [front, back]: readonly [number, number],
  seen: Premultiplied,
  span = 1,
): Premultiplied {
  const end = (value: number): OverlaidSample => ({ value: 0, valid: true, overlay: value });
  return overlayShade(overlay, { isFolded: () => false }, { lightFactor: 1, opticalScale: 1 })(
    { front: end(front), back: end(back), begin: 0, span },
    seen,
    { point: [0, 0, 0], direction: [1, 0, 0], lengthPerT: 1 },
  );
}

const near = (got: readonly number[], expected: readonly number[], off = 1e-12): void =>
  got.forEach((x, c) => expect(x, `channel ${c}`).to.be.closeTo(expected[c], off));

describe('two media in one place', () => {
  const one = [
    { value: 0, color: [0.9, 0.4, 0.1], opacity: 0.3 },
    { value: 1, color: [0.2, 0.5, 1], opacity: 0.7 },
  ] as const;

  it('add their extinctions and their light, in any order, in halves as in one', () => {
    const overlay = overlayOf(volume, signed(), { transferFunction: one });
    const first = attenuate([0.2, 0.1, 0.4, 0.5], 0.8);
    const [, , , density] = emission(one, 1);
    const both = shade(overlay, [1, 1], first, 0.8);
    const light = emission(one, 1).map((x, c) => 0.8 * (x + [0.2, 0.1, 0.4, 0.5][c]));
    const depth = 0.8 * (density + 0.5);
    near(both, [0, 1, 2].map((c) => (light[c] / depth) * -Math.expm1(-depth)).concat(-Math.expm1(-depth)));
    // Cut in two, the ray shows the same.
    const half = shade(overlay, [1, 1], attenuate([0.2, 0.1, 0.4, 0.5], 0.4), 0.4);
    near(
      half.map((x) => x + (1 - half[3]) * x),
      both,
    );
    near(shade(overlay, [NaN, NaN], first), first, 0);
    near(
      shade(overlay, [1, NaN], first, 1.6),
      both.map((_, c) => shade(overlay, [1, 1], first, 0.8)[c]),
    );
  });

  it('of colour alone keep the opacity: all of a constant colour is as if the volume had it, and none leaves its own', () => {
    const red = overlayOf(volume, signed(), {
      blend: 'color',
      transferFunction: [
        { value: 0, color: [1, 0, 0], opacity: 0 },
        { value: 1, color: [1, 0, 0], opacity: 0.4 },
      ],
    });
    const seen: Premultiplied = [0.1, 0.2, 0.3, 0.5];
    near(shade(red, [1, 1], seen), [0.5, 0, 0, 0.5]);
    near(shade(red, [0, 0], seen), seen);
    // Half of its largest opacity is half of its colour, to a quarter of 1/255.
    near(shade(red, [0.5, 0.5], seen), [0.3, 0.1, 0.15, 0.5], 1e-3);
    near(shade(red, [NaN, NaN], seen), seen);
    near(shade({ ...red, missing: [0, 1, 0] }, [NaN, NaN], seen), [0, 0.5, 0, 0.5]);
  });
});

describe("a layer's place", () => {
  const refused = (layer: Volume, over: Volume = volume): string => {
    try {
      placeOverlay(layer, over, 'map.nii');
    } catch (error) {
      expect((error as VolumeViewError).code).to.equal('format/unsupported');
      return (error as VolumeViewError).message;
    }
    return '';
  };
  const nifti = { ...volume, format: 'NIfTI-1' };
  const moved = (layer: Volume, change: (entry: number, i: number) => number): Volume => ({
    ...layer,
    format: 'NIfTI-1',
    grid: { ...layer.grid, indexToWorld: layer.grid.indexToWorld.map(change) },
  });

  it('is the one that its file says; nowhere in common, in another unit or not known is reported', () => {
    expect(
      refused(
        moved(signed(), (x) => x),
        nifti,
      ),
    ).to.equal('');
    expect(
      refused(
        moved(signed(), (x, i) => (i === 7 ? x + 500 : x)),
        nifti,
      ),
    ).to.match(/the layer map\.nii and the volume have no place in common; expected files of the same body/);
    expect(
      refused(
        moved(signed(), (x, i) => (i < 12 ? x / 1000 : x)),
        nifti,
      ),
    ).to.match(/is 0\.0\d+ across and the volume 3\d\.\d; expected files in the same unit of length/);
    expect(refused({ ...syntheticVolume({ dimensions: [8, 8, 8] }), format: 'PNG mosaic' }, nifti)).to.match(
      /grid of 8 x 8 x 8 voxels and the volume on one of 24 x 20 x 16/,
    );
    const same = { ...syntheticVolume({ dimensions: [24, 20, 16] }), format: 'PNG mosaic' };
    expect(
      placeOverlay(
        same,
        moved(volume, (x, i) => (i === 3 ? x + 9 : x)),
        'm',
      ).grid.indexToWorld[3],
    ).to.equal(volume.grid.indexToWorld[3] + 9);
  });

  it('on a radar is another moment of its gates, and of no other radar', () => {
    const [a, b] = [20, 30].map((gates) =>
      radarVolume({
        sweeps: [
          { elevation: 1, gates },
          { elevation: 3, gates },
        ],
      }),
    );
    expect(placeOverlay(a, { ...a }, 'm')).to.equal(a);
    expect(refused(b, a)).to.match(
      /DBZH has 2 sweeps of up to 30 gates, and DBZH has 2 sweeps of up to 20 gates; expected two moments of one scan on the same gates/,
    );
    expect(refused(a)).to.match(/is a radar scan; expected a volume of voxels/);
    expect(refused(volume, a)).to.match(/is over a radar scan/);
  });
});

describe("a layer's look", () => {
  const words = { transferFunction: null, valueWindow: null, blend: null, opacityFactor: null };

  it('follows its values: both signs around a clear zero, and a glow for one sign', async () => {
    const both = await resolveOverlayAppearance(words, { ...signed(), window: [-5, 5], transferFunction: 'diverging' });
    for (const value of [-1, 0, 1]) expect(emission(both.transferFunction, value)[3], String(value)).to.equal(0);
    const [cold, , , coldDepth] = emission(both.transferFunction, -4);
    const [warm, , blue, warmDepth] = emission(both.transferFunction, 4);
    expect(coldDepth).to.be.closeTo(warmDepth, 1e-9);
    expect(cold).to.be.below(warm);
    expect(blue).to.be.below(warm);
    const glow = await resolveOverlayAppearance(words, { ...volume, window: [0, 10] });
    expect([glow.blend, glow.opacityFactor, emission(glow.transferFunction, 1)[3]]).to.deep.equal(['mix', 1, 0]);
    for (const transferFunction of [sliceStops, colorSliceStops]) {
      const slice = await resolveOverlayAppearance(words, { ...volume, window: [0, 10], transferFunction });
      expect(slice).to.deep.equal(glow);
    }
  });

  it('refuses labels, and words that it does not know', async () => {
    const failed = async (appearance: Promise<unknown>): Promise<string> =>
      appearance.then(
        () => '',
        (error: VolumeViewError) => `${error.code} ${error.message}`,
      );
    expect(await failed(resolveOverlayAppearance(words, { ...volume, isDiscrete: true }))).to.match(
      /^format\/unsupported <volume-layer> got labels.*Use <volume-labels>/,
    );
    expect(await failed(resolveOverlayAppearance({ ...words, blend: 'add' }, volume))).to.match(
      /^attribute\/invalid blend.*mix/,
    );
    expect(await failed(resolveOverlayAppearance({ ...words, opacityFactor: '-1' }, volume))).to.match(
      /^attribute\/invalid opacity-factor/,
    );
  });
});

it('what a layer may have in a macrocell of the volume holds all that it has at any place in it', () => {
  const random = randomNumbers(3);
  for (const size of [0.3, 1.4]) {
    const own: Vector3 = size < 1 ? [30, 26, 34] : [9, 8, 7];
    const layer = syntheticVolume({
      dimensions: own,
      kind: 'float32',
      indexToWorld: askew(volume, own, size),
      field: waves,
    });
    const overlay = overlayOf(volume, layer);
    const cells = listOverlayCells(volume, layer);
    const field = cartesianOverlay(overlay);
    const shown = shownByOverlay(cells, overlay)!;
    const [nx, ny] = volume.macrocells.dimensions;
    let met = 0;
    for (let n = 0; n < 20_000; n++) {
      const place: Vector3 = [random(), random(), random()];
      const { value, valid } = field.sampleAt(place);
      const [i, j, k] = place.map((x, axis) => Math.floor((x * volume.grid.dimensions[axis]) / volume.macrocells.size));
      const cell = i + nx * (j + ny * k);
      if (!valid) continue;
      met++;
      expect(value).to.be.within(cells.low[cell] - 1e-6, cells.high[cell] + 1e-6);
      if (emission(overlay.transferFunction, value)[3] > 0) expect(shown[cell]).to.equal(1);
    }
    expect(met, 'places in the layer').to.be.above(300);
  }
  expect(shownByOverlay(listOverlayCells(volume, signed()), overlayOf(volume, signed(), { blend: 'color' }))).to.equal(
    null,
  );
});

describe('the values that a layer has in each macrocell', () => {
  it('are those of the voxels around it, and of no wider block', () => {
    const own: Vector3 = [40, 36, 32];
    // One voxel of a layer whose voxels are smaller and turned.
    const layer = syntheticVolume({
      dimensions: own,
      kind: 'float32',
      indexToWorld: askew(volume, own, 1),
      field: (x, y, z) => (Math.hypot(x - 0.49, y - 0.51, z - 0.5) < 0.02 ? 9 : 1),
    });
    expect(layer.samples.filter((value) => value === 9).length).to.be.within(1, 8);
    const field = cartesianOverlay(overlayOf(volume, layer));
    const cells = listOverlayCells(volume, layer);
    const [nx, ny] = volume.macrocells.dimensions;
    const found = new Set<number>();
    const random = randomNumbers(5);
    for (let n = 0; n < 60_000; n++) {
      const place: Vector3 = [random(), random(), random()];
      const [i, j, k] = place.map((x, axis) => Math.floor((x * volume.grid.dimensions[axis]) / volume.macrocells.size));
      if (field.sampleAt(place).value > 1) found.add(i + nx * (j + ny * k));
    }
    const reported = [...cells.high].flatMap((high, cell) => (high > 1 ? [cell] : []));
    expect(found.size, 'cells in which it is met').to.be.above(0);
    for (const cell of found) expect(reported).to.include(cell);
    // All cells that meet at a corner may touch its voxels.
    expect(reported.length).to.be.at.most(8);
  });

  it("are those of the volume's own macrocells for one on the same grid, also where there are too many voxels to read them again", () => {
    for (const edge of [24, 176]) {
      const same = syntheticVolume({ dimensions: [edge, edge, edge], kind: 'uint8', field: waves });
      const { low, high } = listOverlayCells(same, same);
      const toData = (stored: number): number => same.slope * stored + same.intercept;
      const [along] = same.macrocells.dimensions;
      for (const at of [0, 1, along - 1]) {
        const cell = at * (1 + along * (1 + along));
        expect(low[cell], `${edge} voxels, least`).to.equal(toData(same.macrocells.low[cell]));
        expect(high[cell], `${edge} voxels, largest`).to.equal(toData(same.macrocells.high[cell]));
      }
    }
  });
});

it('in a pane the largest opacity covers the grey, a clear value leaves it, and so does what is outside', () => {
  const layer = syntheticVolume({
    dimensions: [3, 1, 1],
    kind: 'float32',
    indexToWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
    field: (x) => (x < 0.4 ? -1 : x < 0.7 ? 0 : 1),
  });
  const overlay = paneOverlay({
    volume: layer,
    transferFunction: [
      { value: -1, color: [0, 0, 1], opacity: 0.2 },
      { value: 0, color: [0, 0, 1], opacity: 0 },
      { value: 1, color: [1, 0, 0], opacity: 0.4 },
    ],
  })!;
  const pixels = { width: 5, height: 1, first: [-2, 0, 0], across: [1, 0, 0], down: [0, 1, 0] } as const;
  const picture = new Uint8ClampedArray(20).fill(100).map((x, i) => (i % 4 === 3 ? 255 : x));
  picture[19] = 0; // The last pixel is outside of the volume.
  joinPaneLabels([null, overlay])!.paint(pixels, picture, [0, 1]);
  const pixel = (i: number): number[] => [...picture.slice(4 * i, 4 * i + 3)];
  expect(pixel(0)).to.deep.equal([100, 100, 100]);
  near(pixel(2), [50, 50, 177.5], 1);
  expect(pixel(3)).to.deep.equal([100, 100, 100]);
  expect(pixel(4)).to.deep.equal([100, 100, 100]);
});
