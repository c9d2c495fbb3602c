import { expect } from '@esm-bundle/chai';
import { fillRows } from '../../../src/panes/fill-slice.ts';
import { fitFrame, pixelsOf } from '../../../src/panes/pane-frame.ts';
import { SlicedVolume } from '../../../src/panes/slice-field.ts';
import { planeOf, sideLetters, toPlane } from '../../../src/panes/slice-plane.ts';
import { cartesianGrid } from '../../../src/volume/grid.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';
import { multiply, scale, transformPoint } from '../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { decodeBytes, fetchFile, fetchFixture } from '../../helpers/decode.ts';

const mark = 100;
const orders: readonly Vector3[] = [
  [0, 1, 2],
  [0, 2, 1],
  [1, 0, 2],
  [1, 2, 0],
  [2, 0, 1],
  [2, 1, 0],
];
const signs = Array.from({ length: 8 }, (_, n): Vector3 => [n & 1 ? -1 : 1, n & 2 ? -1 : 1, n & 4 ? -1 : 1]);

/** Axis a of the voxels runs along axis order[a] of the world, forwards or backwards. */
function affine(order: Vector3, sign: Vector3): Matrix4 {
  const spacing = [1, 2, 1.5];
  const rows = [0, 1, 2].map((axis) => [
    ...order.map((to, a) => (to === axis ? sign[a] * spacing[a] : 0)),
    [10, -20, 5][axis],
  ]);
  return [...rows.flat(), 0, 0, 0, 1];
}

/** Turned by some degrees around each axis in turn. */
function turned(degrees: number): Matrix4 {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  const x: Matrix4 = [1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0, 0, 0, 0, 1];
  const y: Matrix4 = [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1];
  const z: Matrix4 = [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  return multiply(x, multiply(y, z));
}

/** A volume with a mark in the voxel that is farthest to a patient's right, front and head. */
function marked(indexToWorld: Matrix4): { sliced: SlicedVolume; place: Vector3 } {
  const dimensions: Vector3 = [5, 7, 6];
  const grid: CartesianGrid = cartesianGrid(dimensions, indexToWorld);
  const samples = new Uint8Array(5 * 7 * 6);
  let [best, at, place] = [-Infinity, 0, [0, 0, 0] as Vector3];
  samples.forEach((_, n) => {
    const index: Vector3 = [n % 5, Math.floor(n / 5) % 7, Math.floor(n / 35)];
    const world = transformPoint(indexToWorld, index);
    const far = world[0] + world[1] + world[2];
    if (far > best) [best, at, place] = [far, n, world];
  });
  samples[at] = mark;
  return {
    sliced: new SlicedVolume({ samples, hasNoData: false, slope: 1, intercept: 0 } as unknown as Volume, grid),
    place,
  };
}

/** Where in the picture of the slice through a place its brightest pixel is, as shares of width and height from the top left. */
function findMark(
  type: 'axial' | 'coronal' | 'sagittal',
  sliced: SlicedVolume,
  place: Vector3,
): { across: number; down: number; value: number } {
  const plane = planeOf(type);
  const size = { width: 90, height: 90 };
  const pixels = pixelsOf(plane, fitFrame(sliced.boxAlong(plane), size), size, {
    d: toPlane(plane, place).d,
    columns: 90,
    rows: 90,
  });
  const values = new Float64Array(90 * 90);
  fillRows(
    {
      field: sliced.field(true),
      pixels,
      slab: { normal: plane.normal, thickness: 0, projection: 'average', planes: 1 },
    },
    values,
    [0, 90],
  );
  const found = values.reduce((best, value, i) => (value > values[best] || Number.isNaN(values[best]) ? i : best), 0);
  return { across: (found % 90) / 90, down: Math.floor(found / 90) / 90, value: values[found] };
}

describe("a patient's right, front and head in slices", () => {
  const ways = [
    ...orders.flatMap((order) =>
      signs.map((sign) => [`${order.join('')} ${sign.join()}`, affine(order, sign)] as const),
    ),
    ...[0, 5, 13].flatMap((n) =>
      [8, -20].map(
        (degrees) =>
          [
            `${n}, turned by ${degrees} degrees`,
            multiply(turned(degrees), affine(orders[n % 6], signs[n % 8])),
          ] as const,
      ),
    ),
  ];

  it('are left and above in axial and coronal ones, and front is left in sagittal ones, whatever order a file has', () => {
    for (const [name, indexToWorld] of ways) {
      const { sliced, place } = marked(indexToWorld);
      for (const type of ['axial', 'coronal', 'sagittal'] as const) {
        const { across, down, value } = findMark(type, sliced, place);
        expect(value, `${type} ${name}`).to.equal(mark);
        expect(across, `${type} ${name}`).to.be.below(0.5);
        expect(down, `${type} ${name}`).to.be.below(0.5);
      }
      expect(sliced.valueAt(place), name).to.equal(mark);
    }
    expect(ways.length).to.equal(54);
  });

  it('have the letters of these sides at these edges', () => {
    const edges = (type: 'axial' | 'coronal' | 'sagittal'): string[] => {
      const { right, up } = planeOf(type);
      return [sideLetters(scale(right, -1)), sideLetters(up)];
    };
    expect(['axial', 'coronal', 'sagittal'].map((type) => edges(type as 'axial'))).to.deep.equal([
      ['R', 'A'],
      ['R', 'S'],
      ['A', 'S'],
    ]);
  });

  it('goes a voxel with each step along the axes of the file', () => {
    const { sliced } = marked(affine([2, 0, 1], [1, -1, 1]));
    const steps = (['sagittal', 'coronal', 'axial'] as const).map((type) => sliced.stepAlong(planeOf(type).normal));
    expect(steps).to.deep.equal([2, 1.5, 1]);
  });
});

/** What nibabel and SciPy read there; made by test/fixtures/make-slice-values.py. */
const expected = JSON.parse(new TextDecoder().decode(await fetchFixture('slice-values.json'))) as Record<
  string,
  { first: Vector3; across: Vector3; down: Vector3; values: number[] }
>;

describe("oblique slices of the demos' volumes", () => {
  for (const [name, { first, across, down, values }] of Object.entries(expected)) {
    it(`${name}: are what nibabel and SciPy read`, async () => {
      const volume = await decodeBytes(await fetchFile(`/demos/data/${name}`), name);
      const sliced = new SlicedVolume(volume, volume.grid as CartesianGrid);
      const filled = new Float64Array(values.length);
      const pixels = { width: 6, height: values.length / 6, first, across, down };
      fillRows(
        {
          field: sliced.field(false),
          pixels,
          slab: { normal: [0, 0, 1], thickness: 0, projection: 'average', planes: 1 },
        },
        filled,
        [0, values.length / 6],
      );
      filled.forEach((stored, i) =>
        expect(volume.slope * stored + volume.intercept, `${i}`).to.be.closeTo(values[i], 1e-9),
      );
    });
  }
});
