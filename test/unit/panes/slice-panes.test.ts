import { expect } from '@esm-bundle/chai';
import { interpolate } from '../../../src/optics/rays/interpolate.ts';
import { fillRows } from '../../../src/panes/fill-slice.ts';
import type { Slab, SlicePixels } from '../../../src/panes/fill-slice.ts';
import { grayRange, windowAround } from '../../../src/panes/gray-levels.ts';
import { colorPainter, grayPainter } from '../../../src/panes/paint-slice.ts';
import {
  boxAround,
  fitFrame,
  pixelsOf,
  placeAt,
  pointAt,
  roundLength,
  zoomFrame,
} from '../../../src/panes/pane-frame.ts';
import { linearRow, rowOf } from '../../../src/panes/read-row.ts';
import { linearSampler, nearestSampler } from '../../../src/panes/sample-at.ts';
import { SlicedVolume } from '../../../src/panes/slice-field.ts';
import { planeOf, sideLetters, sliceTypes, toPlane, toWorld } from '../../../src/panes/slice-plane.ts';
import { cartesianGrid, corners } from '../../../src/volume/grid.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';
import { add, cross, dot, invertAffine, scale, transformPoint } from '../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../src/volume/matrix.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

const dimensions: Vector3 = [7, 9, 11];
/** Turned, sheared and with spacings of its own. */
const indexToWorld: Matrix4 = [0.9, 0.2, -0.1, 3, -0.3, 1.1, 0.4, -7, 0.05, -0.2, 2.1, 5, 0, 0, 0, 1];
const worldToIndex = invertAffine(indexToWorld)!;
const size = { width: 300, height: 200 };

function samplesOf(valueAt: (i: number, j: number, k: number) => number): Float32Array<ArrayBuffer> {
  const [nx, ny] = dimensions;
  return Float32Array.from({ length: nx * ny * dimensions[2] }, (_, at) =>
    valueAt(at % nx, Math.floor(at / nx) % ny, Math.floor(at / (nx * ny))),
  );
}

const linearField = (i: number, j: number, k: number): number => 5 + 2 * i - 3 * j + 4 * k;
const block = (samples: Float32Array<ArrayBuffer>, hasNoData = false) => ({ samples, dimensions, hasNoData });
const plane: Slab = { normal: [0, 0, 1], thickness: 0, projection: 'average', planes: 1 };
const directions: readonly Vector3[] = [
  [1, 0, 0],
  [0.3, -0.7, 0.65],
  [0, 0.05, 1],
  [-1, -1, -1],
  [1e-200, 1e-200, 0],
];

describe('planes of slices', () => {
  it('are right-angled, and lead a place into the plane and back', () => {
    for (const { right, up, normal } of [
      ...sliceTypes.map((type) => planeOf(type)),
      ...directions.map((direction) => planeOf('oblique', direction)),
    ]) {
      for (const vector of [right, up, normal]) expect(dot(vector, vector)).to.be.closeTo(1, 1e-12);
      for (const [a, b] of [
        [right, up],
        [up, normal],
        [normal, right],
      ])
        expect(dot(a, b)).to.be.closeTo(0, 1e-12);
      const place: Vector3 = [12.345, -67.89, 1012.3];
      const back = toWorld({ right, up, normal }, toPlane({ right, up, normal }, place));
      expect(Math.hypot(...add(back, scale(place, -1)))).to.be.below(1e-9);
    }
  });

  it('are seen as radiologists hang them', () => {
    const letters = (type: 'axial' | 'coronal' | 'sagittal'): string[] => {
      const { right, up } = planeOf(type);
      return [right, up].map(sideLetters);
    };
    expect(letters('axial')).to.deep.equal(['L', 'A']);
    expect(letters('coronal')).to.deep.equal(['L', 'S']);
    expect(letters('sagittal')).to.deep.equal(['P', 'S']);
    // An oblique one of the same normal as an axial one, seen along it, is hung like that.
    expect(planeOf('oblique', [0, 0, 3]).right).to.deep.equal(planeOf('axial').right);
    expect(sideLetters([-0.6, 0.75, 0.1])).to.equal('AL');
  });

  it('go round three of them and come back: the crosshair of one is that of the others', () => {
    const place: Vector3 = [3.21, -4.56, 17.89];
    let at = place;
    for (const type of ['axial', 'coronal', 'sagittal', 'axial'] as const) {
      const there = planeOf(type);
      const box = boxAround(there, corners(cartesianGrid(dimensions, indexToWorld)));
      const frame = zoomFrame(fitFrame(box, size), size, 3.3, [17, 160]);
      const { d, ...inPlane } = toPlane(there, at);
      at = toWorld(there, { ...placeAt(frame, size, pointAt(frame, size, inPlane)), d });
    }
    expect(Math.hypot(...add(at, scale(place, -1)))).to.be.below(1e-9);
  });
});

describe('samples of slices', () => {
  it('are those of interpolate, with and without data', () => {
    const holes = samplesOf((i, j, k) => ((i * 7 + j * 5 + k * 3) % 6 === 0 ? NaN : Math.sin(i + 2 * j - k) * 100));
    for (const samples of [samplesOf((i, j, k) => Math.sin(i * 3 + j - 5 * k) * 100), holes]) {
      const sampleAt = linearSampler(block(samples, samples === holes));
      for (let n = 0; n < 400; n++) {
        const [x, y, z] = dimensions.map((count, axis) => ((n * [0.618, 0.414, 0.732][axis]) % 1) * count - 0.5);
        const expected = interpolate(samples, dimensions, [(x + 0.5) / 7, (y + 0.5) / 9, (z + 0.5) / 11]);
        const found = sampleAt(x, y, z);
        if (Number.isNaN(expected)) expect(Number.isNaN(found)).to.equal(true);
        else expect(found).to.be.closeTo(expected, 1e-10);
      }
    }
  });

  it('end where the voxels end', () => {
    const samples = samplesOf(linearField);
    for (const sampleAt of [linearSampler(block(samples)), nearestSampler(block(samples))]) {
      expect(sampleAt(-0.5, 0, 0)).to.equal(5);
      expect(Number.isNaN(sampleAt(-0.5001, 0, 0))).to.equal(true);
      expect(Number.isNaN(sampleAt(0, 8.51, 0))).to.equal(true);
      expect(Number.isNaN(sampleAt(0, 0, NaN))).to.equal(true);
    }
    expect(nearestSampler(block(samples))(2.4, 3.6, 0)).to.equal(linearField(2, 4, 0));
  });

  it('of a linear volume are exact in any plane', () => {
    const sampleAt = linearSampler(block(samplesOf(linearField)));
    for (const direction of directions) {
      const oblique = planeOf('oblique', direction);
      const middle = toPlane(oblique, transformPoint(indexToWorld, [3, 4, 5]));
      const pixels = pixelsOf(
        oblique,
        { u: middle.u, v: middle.v, scale: 0.05 },
        { width: 40, height: 30 },
        { d: middle.d, columns: 40, rows: 30 },
      );
      const values = new Float64Array(1200);
      fillRows({ field: { sampleAt, worldToIndex }, pixels, slab: plane }, values, [0, 30]);
      for (const [column, row] of [
        [0, 0],
        [39, 0],
        [13, 22],
        [39, 29],
      ]) {
        const world = add(pixels.first, add(scale(pixels.across, column), scale(pixels.down, row)));
        const [i, j, k] = transformPoint(worldToIndex, world);
        expect(values[row * 40 + column]).to.be.closeTo(linearField(i, j, k), 1e-11);
      }
    }
  });

  it('of a row along an axis of the grid are those of its places, inside and outside', () => {
    const random = randomNumbers(5);
    const samples = samplesOf(() => Math.round(1000 * random()));
    const sampleAt = linearSampler(block(samples));
    const readRow = linearRow(block(samples), sampleAt);
    const [row, line] = [new Float64Array(40), new Float64Array(40)];
    let [inside, outside] = [0, 0];
    for (const step of [
      [0.4, 0, 0],
      [-0.4, 0, 0],
      [0, 0.27, 0],
      [0, -0.3, 0],
      [0, 0, 0.5],
      [0, 0, -1],
      [1e-16, 0.3, 0],
      [0.2, 0.1, 0],
    ] as const) {
      for (let n = 0; n < 40; n++) {
        const from = [0, 1, 2].map(() => 14 * random() - 2) as unknown as Vector3;
        rowOf(sampleAt)(from, step, row);
        readRow(from, step, line);
        for (const [i, value] of row.entries()) {
          if (Number.isNaN(value)) expect(Number.isNaN(line[i])).to.equal(true);
          else expect(line[i]).to.be.closeTo(value, 1e-9);
          if (Number.isNaN(value)) outside++;
          else inside++;
        }
      }
    }
    expect(inside).to.be.above(1500);
    expect(outside).to.be.above(1500);
    // And a constant stays one.
    const even = samplesOf(() => 0.75);
    linearRow(block(even), linearSampler(block(even)))([0.3, 2.7, 3.3], [0.1, 0, 0], line);
    expect([...new Set(line)]).to.deep.equal([0.75]);
  });

  it('of a slab: the mean of x squared is that of its middle and a twelfth of its thickness squared', () => {
    const field = {
      sampleAt: (x: number): number => x * x,
      worldToIndex: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
    };
    const one: SlicePixels = { width: 1, height: 1, first: [3, 0, 0], across: [0, 1, 0], down: [0, 0, 1] };
    const values = new Float64Array(1);
    const errorOf = (planes: number): number => {
      fillRows(
        { field, pixels: one, slab: { normal: [1, 0, 0], thickness: 2, projection: 'average', planes } },
        values,
        [0, 1],
      );
      return Math.abs(values[0] - (9 + 4 / 12));
    };
    expect(errorOf(64)).to.be.below(1e-4);
    expect(Math.log2(errorOf(8) / errorOf(16))).to.be.closeTo(2, 0.01);
  });

  it('of a slab: the largest and the least of its planes, without data left out', () => {
    const sampleAt = linearSampler(
      block(
        samplesOf((_i, _j, k) => (k === 5 ? NaN : k)),
        true,
      ),
    );
    const pixels: SlicePixels = { width: 1, height: 1, first: [3, 4, 5], across: [1, 0, 0], down: [0, -1, 0] };
    const valueOf = (projection: Slab['projection']): number => {
      const values = new Float64Array(1);
      const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
      fillRows(
        {
          field: { sampleAt, worldToIndex: identity },
          pixels,
          slab: { normal: [0, 0, 1], thickness: 4, projection, planes: 4 },
        },
        values,
        [0, 1],
      );
      return values[0];
    };
    expect(valueOf('max')).to.be.closeTo(6.5, 1e-12);
    expect(valueOf('min')).to.be.closeTo(3.5, 1e-12);
    expect(valueOf('average')).to.be.closeTo(5, 1e-12);
  });

  it('of a slab that is far thicker than the volume are all of its values, wherever its middle is', () => {
    const volume = syntheticVolume({ dimensions: [2, 2, 64], kind: 'float32', field: (_x, _y, z) => z });
    const sliced = new SlicedVolume(volume, volume.grid as CartesianGrid);
    const [low, high] = [sliced.boxAlong(planeOf('axial')).low.d, sliced.boxAlong(planeOf('axial')).high.d];
    const normal: Vector3 = [0, 0, 1];
    for (const at of [low, (low + high) / 2, high + 3]) {
      const given = { normal, thickness: 1e5 * (high - low), projection: 'max' } as const;
      const thickness = sliced.thicknessAt(at, given);
      const slab: Slab = { ...given, thickness };
      const [x, y] = sliced.center;
      const pixels: SlicePixels = { width: 1, height: 1, first: [x, y, at], across: [1, 0, 0], down: [0, -1, 0] };
      const values = new Float64Array(1);
      const all: number[] = [];
      for (const projection of ['max', 'min', 'average'] as const) {
        fillRows({ field: sliced.field(false), pixels, slab: { ...slab, projection } }, values, [0, 1]);
        all.push(values[0]);
      }
      // From the middle of the first voxel to that of the last one, all of them: 0.5 / 64 to 63.5 / 64.
      for (const [i, expected] of [63.5 / 64, 0.5 / 64, 0.5].entries())
        expect(all[i], `${at}`).to.be.closeTo(expected, 1e-6);
    }
    expect(sliced.thicknessAt(0, { normal, thickness: 0.5, projection: 'max' }), 'a thin one').to.equal(0.5);
  });
});

describe('greys and colours of slices', () => {
  const paint = (painter: ReturnType<typeof grayPainter>, values: readonly number[]): Uint8ClampedArray => {
    const pixels = new Uint8ClampedArray(4 * values.length);
    painter(Float64Array.from(values), pixels, [0, values.length]);
    return pixels;
  };

  it("follow both of DICOM's functions", () => {
    // The standard's own example: C.11.2.1.2.1, c = 2048 and w = 4096, black at 0 and white at 4095.
    const window = windowAround(2048, 4096);
    expect(grayRange({ window, windowFunction: 'linear' })).to.deep.equal([0, 4095]);
    expect(grayRange({ window, windowFunction: 'linear-exact' })).to.deep.equal([0, 4096]);
    expect(grayRange({ window: windowAround(2048, 1), windowFunction: 'linear' })).to.deep.equal([2047.5, 2047.5]);
    expect(grayRange({ window: windowAround(0, 100), windowFunction: 'linear' })).to.deep.equal([-50, 49]);
  });

  it('are rounded once, and nothing is drawn where there is nothing', () => {
    const painter = grayPainter({ window: [-100, 155], windowFunction: 'linear-exact' }, { slope: 2, intercept: -100 });
    const pixels = paint(painter, [0, 50, 50.3, 1000, -3, NaN]);
    expect([...pixels].filter((_, i) => i % 4 === 0)).to.deep.equal([0, 100, 101, 255, 0, 0]);
    expect([...pixels].filter((_, i) => i % 4 === 3)).to.deep.equal([255, 255, 255, 255, 255, 0]);
    const threshold = grayPainter(
      { window: windowAround(10, 1), windowFunction: 'linear' },
      { slope: 1, intercept: 0 },
    );
    expect([...paint(threshold, [9.5, 9.6])].filter((_, i) => i % 4 === 0)).to.deep.equal([0, 255]);
  });

  it('of labels are their own, opaque, and hidden ones are not there', () => {
    const stops = [
      { value: 0.5, color: [1, 0, 0], opacity: 0 },
      { value: 0.5, color: [1, 0, 0], opacity: 0.2 },
      { value: 1.5, color: [1, 0, 0], opacity: 0.2 },
      { value: 1.5, color: [0, 0, 1], opacity: 0.2 },
      { value: 2.5, color: [0, 0, 1], opacity: 0.2 },
    ] as const;
    const pixels = paint(colorPainter(stops, { slope: 1, intercept: 0 }, true), [0, 1, 2]);
    expect([...pixels]).to.deep.equal([0, 0, 0, 0, 255, 0, 0, 255, 0, 0, 255, 255]);
  });
});

describe('the frame of a pane', () => {
  it('holds all of the volume, and zooms around a place that stays', () => {
    const axial = planeOf('axial');
    const all = corners(cartesianGrid(dimensions, indexToWorld));
    const frame = fitFrame(boxAround(axial, all), size);
    const points = all.map((corner) => pointAt(frame, size, toPlane(axial, corner)));
    for (const [axis, max] of [
      [0, 300],
      [1, 200],
    ] as const) {
      expect(Math.min(...points.map((point) => point[axis]))).to.be.above(-1e-9);
      expect(Math.max(...points.map((point) => point[axis]))).to.be.below(max + 1e-9);
    }
    const before = placeAt(frame, size, [40, 170]);
    const after = placeAt(zoomFrame(frame, size, 2.5, [40, 170]), size, [40, 170]);
    expect(Math.hypot(before.u - after.u, before.v - after.v)).to.be.below(1e-12);
  });

  it('has its pixels where its places are', () => {
    const oblique = planeOf('oblique', [0.3, -0.7, 0.65]);
    const frame = { u: 3, v: -4, scale: 0.7 };
    const pixels = pixelsOf(oblique, frame, size, { d: 2.5, columns: 600, rows: 400 });
    const world = add(pixels.first, add(scale(pixels.across, 123), scale(pixels.down, 45)));
    const { u, v, d } = toPlane(oblique, world);
    expect(d).to.be.closeTo(2.5, 1e-12);
    expect(pointAt(frame, size, { u, v })[0]).to.be.closeTo(61.75, 1e-9);
    expect(pointAt(frame, size, { u, v })[1]).to.be.closeTo(22.75, 1e-9);
    expect(cross(oblique.normal, oblique.up)[0]).to.be.closeTo(oblique.right[0], 1e-12);
  });

  it('has a bar of a round length', () => {
    expect([99, 100, 0.03, 7, 4.99].map(roundLength).map((length) => Number(length.toPrecision(6)))).to.deep.equal([
      50, 100, 0.02, 5, 2,
    ]);
  });
});
