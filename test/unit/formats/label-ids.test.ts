// Whole numbers that float32 rounds: ids of atlases, and any other; and 3D Slicer's segmentations.
import { expect } from '@esm-bundle/chai';
import { findColumns } from '../../../src/optics/transfer/table-columns.ts';
import { cutColumns, locateShare } from '../../../src/optics/transfer/columns.ts';
import { labelStops, plainLabelStops, stopsByPlace } from '../../../src/optics/transfer/label-stops.ts';
import { mapShares } from '../../../src/optics/transfer/share-map.ts';
import { placeThreshold } from '../../../src/optics/transfer/threshold.ts';
import { emission } from '../../../src/optics/transfer/emission.ts';
import { evaluate } from '../../../src/optics/transfer/transfer-function.ts';
import { finishVolume } from '../../../src/formats/finish-volume.ts';
import { niftiTypes } from '../../../src/formats/base/number-types.ts';
import { storeSamples } from '../../../src/formats/base/store-samples.ts';
import { chooseWhole } from '../../../src/formats/base/whole-numbers.ts';
import { colorPainter } from '../../../src/panes/paint-slice.ts';
import { SlicedVolume } from '../../../src/panes/slice-field.ts';
import { labelsIn } from '../../../src/viewer/loading/label-files.ts';
import { nearestVoxel } from '../../../src/viewer/picking/pick-voxel.ts';
import { plainAppearance } from '../../../src/viewer/model/plain-appearance.ts';
import { resolveAppearance } from '../../../src/viewer/appearance/resolve-appearance.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../src/volume/grid.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';
import { valueOf } from '../../../src/volume/index-numbers.ts';
import { asLabels, withoutIds } from '../../../src/volume/label-volume.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { DeviceLimits } from '../../../src/volume/reduce.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { solidOf } from '../../../src/volume/solid.ts';
import { sumUpVoxels } from '../../../src/volume/voxels-inside.ts';
import { decodeBytes, expectError, fetchFixture, roomyLimits } from '../../helpers/decode.ts';

type Numbers =
  | Int32Array<ArrayBuffer>
  | Uint32Array<ArrayBuffer>
  | Float32Array<ArrayBuffer>
  | Float64Array<ArrayBuffer>
  | BigInt64Array<ArrayBuffer>
  | BigUint64Array<ArrayBuffer>
  | Uint16Array<ArrayBuffer>;
const codes: Record<string, number> = {
  Int32Array: 8,
  Uint32Array: 768,
  Float32Array: 16,
  Float64Array: 64,
  BigInt64Array: 1024,
  BigUint64Array: 1280,
  Uint16Array: 512,
};
const store = (numbers: Numbers) =>
  storeSamples(new Uint8Array(numbers.slice().buffer), niftiTypes.get(codes[numbers.constructor.name])!, true, {
    slope: 1,
    intercept: 0,
    chooseWhole,
  });

/** A file's numbers as a volume. */
function finish(
  numbers: Numbers,
  dimensions: Vector3,
  { limits = roomyLimits, ...more }: { limits?: DeviceLimits; isLabels?: boolean } = {},
): Promise<Volume> {
  const { samples, scale: slope, offset: intercept, indexed, rounded } = store(numbers);
  return finishVolume(
    {
      grid: cartesianGrid(dimensions, axialIndexToWorld(dimensions, [1, 1, 1])),
      samples,
      slope,
      intercept,
      indexed,
      rounded,
      unit: '',
      format: 'NIfTI-1',
      ...more,
    },
    limits,
  );
}

const valuesOf = (volume: Volume): number[] => Array.from(volume.samples, (stored) => valueOf(volume, stored));
const counted = (values: readonly number[]): [number, number][] => {
  const different = [...new Set(values)];
  different.sort((a, b) => a - b);
  return different.map((value) => [value, values.filter((one) => one === value).length]);
};

// pynrrd 1.1.3 and nibabel 5.4.2, numpy.unique of annotation.nrrd and annotation.nii.gz: these ids, and so many voxels.
const atlas: [number, number][] = [
  [0, 17280],
  [1, 1920],
  [997, 1920],
  [312782592, 1920],
  [312782593, 1920],
  [576073728, 1920],
  [576073732, 1920],
  [614454277, 1920],
];

describe('ids of an atlas that float32 does not distinguish', () => {
  for (const name of ['annotation.nrrd', 'annotation.nii.gz']) {
    it(`${name}: they are those of the file, each with a colour, and it is recognised`, async () => {
      const volume = await decodeBytes(await fetchFixture(`labels/${name}`), name);
      expect(volume.isDiscrete).to.equal(true);
      expect(counted(valuesOf(volume))).to.deep.equal(atlas);
      expect(volume.range).to.deep.equal([0, 614454277]);
      expect(volume.left).to.equal(undefined);
      const { transferFunction } = await resolveAppearance(plainAppearance, volume);
      const looks = atlas.map(([id]) => evaluate(transferFunction, id));
      expect(looks[0][3]).to.equal(0);
      expect(new Set(looks.slice(1).map(String)).size).to.equal(7);
      // As what draws it has it.
      expect(
        atlas.map((_, place) => evaluate(stopsByPlace(transferFunction, volume.ids!), place).map((x) => x.toFixed(9))),
      ).to.deep.equal(looks.map((appearance) => appearance.map((x) => x.toFixed(9))));
      const { found } = labelsIn(volume, name);
      expect(found.ids).to.deep.equal(atlas.map(([id]) => id));
    });
  }

  it('are reported by picks, panes and measures, and coloured in panes', async () => {
    const volume = await decodeBytes(await fetchFixture('labels/annotation.nrrd'), 'annotation.nrrd');
    const grid = volume.grid as CartesianGrid;
    const sliced = new SlicedVolume(volume, grid);
    for (const [n, [id]] of atlas.slice(1).entries()) {
      const index: Vector3 = [4 + 5 * n, 16, 12]; // numpy: v[2 + 5 n : 7 + 5 n, 4:28, 4:20] = id
      const [x, y, z, w] = [0, 1, 2, 3].map((column) => [0, 1, 2].map((row) => grid.indexToWorld[4 * row + column]));
      const place = [0, 1, 2].map(
        (axis) => x[axis] * index[0] + y[axis] * index[1] + z[axis] * index[2] + w[axis],
      ) as unknown as Vector3;
      expect(sliced.valueAt(place)).to.equal(id);
      expect(
        nearestVoxel(volume, index.map((i, axis) => (i + 0.5) / grid.dimensions[axis]) as unknown as Vector3)?.value,
      ).to.equal(id);
    }
    const { transferFunction } = await resolveAppearance(plainAppearance, volume);
    const pixels = new Uint8ClampedArray(4 * 8);
    colorPainter(transferFunction, volume, true)(
      Float64Array.from({ length: 8 }, (_, i) => i),
      pixels,
      [0, 8],
    );
    expect(new Set(Array.from({ length: 8 }, (_, i) => String(pixels.subarray(4 * i, 4 * i + 4)))).size).to.equal(8);
    const work = sumUpVoxels(
      { ...volume, grid },
      solidOf('box', [
        [-1e3, -1e3, -1e3],
        [1e3, 1e3, 1e3],
      ]),
    );
    let step = work.next();
    while (!step.done) step = work.next();
    expect([step.value.count, step.value.least, step.value.largest]).to.deep.equal([30720, 0, 614454277]);
  });

  const size: Vector3 = [12, 10, 8];
  const bands =
    <T>(ids: readonly T[]) =>
    (_: unknown, at: number): T =>
      ids[Math.floor(((at % 12) / 12) * ids.length)];
  const length = 960;

  it('of 64 bits and doubles too, up to the last one that a double holds; beyond it they are refused as labels, and reported where they are shown', async () => {
    const ids = [0, 5, 2 ** 53 - 2, 2 ** 53 - 1];
    for (const numbers of [
      BigInt64Array.from({ length }, (_, at) => BigInt(bands(ids)(_, at))),
      BigUint64Array.from({ length }, (_, at) => BigInt(bands(ids)(_, at))),
      Float64Array.from({ length }, bands(ids)),
    ]) {
      const volume = await finish(numbers, size);
      expect(volume.ids, numbers.constructor.name).to.deep.equal(ids);
      const { transferFunction } = await resolveAppearance(plainAppearance, volume);
      expect(new Set(ids.map((id) => evaluate(transferFunction, id).join())).size).to.equal(4);
    }
    for (const far of [
      [0n, 5n, 2n ** 60n, 2n ** 60n + 1n],
      [2n ** 60n, 2n ** 60n + 1n, 2n ** 60n + 3n],
    ]) {
      const beyond = await finish(
        BigUint64Array.from({ length }, (_, at) => bands(far)(_, at)),
        size,
        { isLabels: true },
      );
      expect(beyond.isDiscrete).to.equal(undefined);
      expect(beyond.left?.join()).to.match(/whole numbers are rounded, by up to .* none beyond 9,007,199,254,740,991/);
      const error = await expectError((async () => labelsIn(beyond, 'segments.nrrd'))());
      expect(error.message).to.match(
        /^segments\.nrrd has ids that can not be distinguished, up to about 1,152,921,504,606,84\d,\d{3}; expected at most 65,536 different ones, up to 9,007,199,254,740,991\. /,
      );
    }
  });

  it('negative ones leave what has no label clear', async () => {
    const volume = await finish(Int32Array.from({ length }, bands([-7, 0, 3, 2 ** 30 + 1])), size, { isLabels: true });
    expect(volume.ids).to.deep.equal([-7, 0, 3, 2 ** 30 + 1]);
    const { transferFunction } = await resolveAppearance(plainAppearance, volume);
    expect(volume.ids!.map((id) => evaluate(transferFunction, id)[3])).to.deep.equal([0.22, 0, 0.22, 0.22]);
  });

  it('are made smaller by majority, in 32-bit floats as well', async () => {
    for (const numbers of [
      Uint32Array.from({ length }, bands([0, 1, 2 ** 31 + 1, 2 ** 31 + 2])),
      Float32Array.from({ length }, bands([0, 1, 2, 3])),
    ]) {
      const volume = await finish(numbers, size, { isLabels: true, limits: { ...roomyLimits, maxVoxelsPerAxis: 8 } });
      expect(volume.reduced).to.deep.equal({ from: size, to: [6, 5, 8] });
      expect(counted(valuesOf(volume)).map(([value]) => value)).to.deep.equal([...new Set(numbers)]);
    }
  });

  it('become labels where a page says so of what was taken for a scan; and values again for a layer', async () => {
    const ids = [0, 3, 2 ** 28 + 1, 2 ** 28 + 2];
    // Each beside any other: no patches.
    const scan = await finish(
      Uint32Array.from({ length }, (_, at) => ids[(at * 7 + (at >> 3)) % 4]),
      size,
    );
    expect(scan.isDiscrete).to.equal(undefined);
    const labels = asLabels(scan);
    expect([labels.isDiscrete, labels.ids]).to.deep.equal([true, ids]);
    expect(labelsIn(scan, 'scan.nii').found.ids).to.deep.equal(ids);
    expect(nearestVoxel(scan, [0.5 / 12, 0.05, 0.0625])?.value).to.equal(0);
    expect(
      new Set(Array.from({ length: 12 }, (_, i) => nearestVoxel(scan, [(i + 0.5) / 12, 0.05, 0.0625])?.value)),
    ).to.deep.equal(new Set(ids));
    const values = withoutIds(labels);
    expect([values.ids, values.slope * values.samples[1] + values.intercept]).to.deep.equal([
      undefined,
      Math.fround(ids[7 % 4]),
    ]);
  });
});

describe('whole numbers that become float32', () => {
  it('are shifted only where that rounds fewer of them', () => {
    // 5,000 to 10,000 in steps of 1, beside -2e9: less an offset of about 7,500 the latter would be told as -1,999,999,992 or so.
    const soft = Int32Array.from({ length: 4000 }, (_, i) => (i < 100 ? -2e9 : 5000 + ((i * 7) % 5000)));
    const reported = store(soft);
    expect(Array.from(reported.samples, (sample) => sample * reported.scale + reported.offset)).to.deep.equal([
      ...soft,
    ]);
    const far = Int32Array.from({ length: 4000 }, (_, i) => 1e9 + (i % 5));
    far[0] = 0;
    const shifted = store(far);
    expect(shifted.indexed?.ids ?? shifted.offset).not.to.equal(0);
    expect(Array.from(shifted.samples, (sample) => sample * shifted.scale + shifted.offset)).to.deep.equal([...far]);
  });

  it('what is rounded all the same is kept in a list, up to 65,536 different ones; of more, how many and by how much', async () => {
    const padded = Int32Array.from({ length: 4096 }, (_, i) => (i < 100 ? -2147483641 : (i % 90) - 20));
    const volume = await finish(padded, [16, 16, 16]);
    expect(volume.isDiscrete).to.equal(undefined);
    expect([volume.range, volume.left]).to.deep.equal([[-2147483641, 69], undefined]);
    expect(nearestVoxel(volume, [0.5 / 16, 0.5 / 16, 0.5 / 16])).to.deep.equal({
      index: [0, 0, 0],
      value: -2147483641,
    });
    const many = Int32Array.from({ length: 70_000 }, (_, i) => 1e9 + 31 * i);
    many[0] = 3;
    const { rounded, samples, scale, offset, indexed } = store(many);
    const errors = Array.from(samples, (sample, i) => Math.abs(sample * scale + offset - many[i]));
    expect(indexed).to.equal(undefined);
    expect(rounded).to.deep.equal({ count: errors.filter((error) => error > 0).length, by: Math.max(...errors) });
    expect((await finish(many, [70_000 / 100, 10, 10])).left?.[0]).to.match(
      /^[\d,]+ whole numbers are rounded, by up to \d+: /,
    );
  });
});

describe('files with many labels', () => {
  it('have a colour for each, of 512, 1,449 and 65,535 of them', async () => {
    for (const count of [512, 1449, 65_535]) {
      const volume = await finish(
        Uint16Array.from({ length: 65_536 }, (_, i) => i % (count + 1)),
        [64, 32, 32],
        { isLabels: true },
      );
      expect(volume.ids?.length, String(count)).to.equal(count + 1);
      const { transferFunction } = await resolveAppearance(plainAppearance, volume);
      const byPlace = stopsByPlace(transferFunction, volume.ids!);
      expect(findColumns(byPlace)).to.equal(null);
      const values = { slope: 1, intercept: 0, storedScale: 65_535, range: [0, count] as const, whole: true };
      const map = mapShares(values, [byPlace[0].value, byPlace.at(-1)!.value]);
      const columns = cutColumns(byPlace, (value) => placeThreshold(values, map, value));
      expect(columns.edges.length).to.be.within(count, count + 4);
      for (const id of [0, 1, 2, Math.floor(count / 2), count - 1, count]) {
        const share = Math.fround(Math.fround(Math.fround(id / 65_535) - map.from) * map.scale);
        expect(
          locateShare(columns, share).emission.map((x) => x.toFixed(5)),
          `${id} of ${count}`,
        ).to.deep.equal(emission(byPlace, id).map((x) => x.toFixed(5)));
      }
    }
  });

  it('are recognised where they lie in patches, 2,000 of them; and noise in as many values is not', async () => {
    const side = 64;
    const at = (i: number): Vector3 => [i % side, Math.floor(i / side) % side, Math.floor(i / side / side)];
    const patches = Uint16Array.from({ length: side ** 3 }, (_, i) => {
      const [x, y, z] = at(i).map((n) => Math.floor(n / 5));
      return 1 + (((x + 13 * y + 169 * z) * 17) % 2003);
    });
    expect((await finish(patches, [side, side, side])).isDiscrete).to.equal(true);
    const noisy = Uint16Array.from({ length: side ** 3 }, (_, i) => 1000 + ((i * 7919) % 2003));
    expect((await finish(noisy, [side, side, side])).isDiscrete).to.equal(undefined);
    const smooth = Uint16Array.from(
      { length: side ** 3 },
      (_, i) => 500 + Math.round(20 * Math.hypot(...at(i).map((n) => n - 31))),
    );
    expect((await finish(smooth, [side, side, side])).isDiscrete).to.equal(undefined);
  });

  it('each keeps its look where one is hidden', () => {
    const ids = Array.from({ length: 5000 }, (_, i) => i + 1);
    const stops = labelStops(ids.map((id) => ({ id, color: [1, 0, 0], opacity: id === 2500 ? 0.2 : 0 })));
    expect([2499, 2500, 2501].map((id) => evaluate(stops, id)[3])).to.deep.equal([0, 0.2, 0]);
    expect(plainLabelStops([0, 4, 9]).length).to.equal(5);
  });
});

describe('segmentations of 3D Slicer', () => {
  it('have the names and colours of their header, with one layer the ids of their voxels', async () => {
    const volume = await decodeBytes(await fetchFixture('labels/one-layer.seg.nrrd'), 'one-layer.seg.nrrd');
    // pynrrd 1.1.3: Segment0_Name, Segment0_Color, Segment0_LabelValue and so on.
    expect(volume.named).to.deep.equal([
      { id: 1, name: 'Liver', color: [0.86, 0.2, 0.1] },
      { id: 2, name: 'Left kidney', color: [0.1, 0.5, 0.9] },
    ]);
    expect(counted(valuesOf(volume)).slice(1)).to.deep.equal([
      [1, 960],
      [2, 864],
    ]);
    const [red, green, blue, opacity] = evaluate(
      (await resolveAppearance(plainAppearance, volume)).transferFunction,
      2,
    );
    expect([red, green, blue].map((channel) => Number((channel / opacity).toFixed(6)))).to.deep.equal([0.1, 0.5, 0.9]);
    expect([volume.isDiscrete, volume.left, volume.format]).to.deep.equal([true, undefined, 'NRRD']);
  });

  it('show all layers, the later above the earlier, and say what that hides', async () => {
    const volume = await decodeBytes(await fetchFixture('labels/two-layers.seg.nrrd'), 'two-layers.seg.nrrd');
    expect(volume.named?.map(({ id, name }) => [id, name])).to.deep.equal([
      [1, 'Liver'],
      [2, 'Left kidney'],
      [3, 'Tumour'],
    ]);
    // pynrrd and numpy 2.4.6: m = layer0; m[layer1 > 0] = 3; unique(m), and sum((layer0 == n) & (layer1 > 0)).
    expect(counted(valuesOf(volume))).to.deep.equal([
      [0, 10416],
      [1, 672],
      [2, 624],
      [3, 1728],
    ]);
    expect(volume.left).to.deep.equal([
      '288 of the 960 voxels of the segment "Liver" are hidden by "Tumour", which overlaps it',
      '240 of the 864 voxels of the segment "Left kidney" are hidden by "Tumour", which overlaps it',
    ]);
    expect(volume.format).to.equal('NRRD, 2 layers');
    expect(labelsIn(volume, 'two-layers.seg.nrrd').found.ids).to.deep.equal([0, 1, 2, 3]);
  });

  const text = (header: readonly string[], data: readonly number[]): Uint8Array<ArrayBuffer> =>
    new TextEncoder().encode(
      ['NRRD0004', 'type: uint8', 'encoding: ascii', ...header, '', data.join(' '), ''].join('\n'),
    );

  it('of old, with a layer for each segment and no values, or with the list last; and what no key names has its number', async () => {
    const axes = [
      'dimension: 4',
      'sizes: 4 3 1 2',
      'kinds: domain domain domain list',
      'space: left-posterior-superior',
      'space directions: (1,0,0) (0,1,0) (0,0,1) none',
    ];
    const first = [1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0];
    const second = [0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 4];
    const volume = await decodeBytes(
      text([...axes, 'Segment0_Name:=A', 'Segment1_Name:=B', 'Segment1_Color:=2 0 0'], [...first, ...second]),
      'old.seg.nrrd',
    );
    expect(volume.named).to.deep.equal([
      { id: 1, name: 'A', color: null },
      { id: 2, name: 'B', color: null },
      { id: 4, name: '', color: null },
    ]);
    expect(valuesOf(volume)).to.deep.equal([1, 2, 2, 0, 1, 1, 0, 0, 0, 0, 0, 4]);
    expect(volume.left).to.deep.equal(['1 of the 4 voxels of the segment "A" are hidden by "B", which overlaps it']);
    // Without keys it is a series, of which the page is told that one volume is shown.
    const series = await decodeBytes(text(axes, [...first, ...second]), 'series.nrrd');
    expect([series.left, series.named]).to.deep.equal([['volume 2 of the file'], undefined]);
  });
});
