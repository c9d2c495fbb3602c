// Which pixels of a picture get more rays, where these go, and what they make of a sphere's silhouette.
import { expect } from '@esm-bundle/chai';
import { orbitCamera, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { edgeOffsets, findEdges, meanAtEdges } from '../../../../src/optics/rays/edge-rays.ts';
import { lightAt, pointField, towardsEye } from '../../../../src/optics/rays/lit.ts';
import { storedField } from '../../../../src/optics/rays/ray-field.ts';
import { raysOfLattice, setUpRays } from '../../../../src/optics/rays/rays.ts';
import type { Ray, RaySetup } from '../../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import { surfaceGather } from '../../../../src/optics/surfaces/surfaces.ts';
import { unitToWorld } from '../../../../src/volume/grid.ts';
import { transformDirection } from '../../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../../src/volume/matrix.ts';
import { plainOptics } from '../../../helpers/picture.ts';
import { castPixels, rayOfPixel } from '../../../helpers/pixel-rays.ts';
import { remember } from '../../../helpers/remember.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const pictureOf = (
  width: number,
  height: number,
  level: (x: number, y: number) => number,
): { data: Uint8Array; width: number; height: number } => ({
  width,
  height,
  data: Uint8Array.from({ length: 4 * width * height }, (_, i) =>
    i % 4 === 1 ? level((i >> 2) % width, Math.floor((i >> 2) / width)) : 0,
  ),
});

describe('pixels with edges', () => {
  it('are on both sides of a jump, in quads of 2 x 2', () => {
    const half = (limit: number, from = 0): number[] => [
      ...findEdges(
        pictureOf(9, 5, (x) => (x < limit ? from : from + 40)),
        27.7,
      ),
    ];
    // Five quads across, three up. From pixel 4 on: between the quads 1 and 2.
    expect(half(4)).to.deep.equal([1, 2, 6, 7, 11, 12]);
    expect(half(5, 200)).to.deep.equal([2, 7, 12]);
    expect([
      ...findEdges(
        pictureOf(9, 5, (_, y) => (y < 4 ? 0 : 40)),
        27.7,
      ),
    ]).to.deep.equal([5, 6, 7, 8, 9, 10, 11, 12, 13, 14]);
  });

  it('are none where a picture runs straight, or jumps less', () => {
    expect(
      findEdges(
        pictureOf(10, 10, (x, y) => 13 * x + 12 * y),
        27.7,
      ),
    ).to.have.length(0);
    expect(
      findEdges(
        pictureOf(10, 10, (x) => (x < 5 ? 100 : 127)),
        27.7,
      ),
    ).to.have.length(0);
    expect(
      findEdges(
        pictureOf(10, 10, (x) => (x < 5 ? 0 : 255)),
        16 * 32,
      ),
    ).to.have.length(0);
    // A line one pixel wide bends twice as much as it stands out.
    expect([
      ...findEdges(
        pictureOf(10, 2, (x) => (x === 4 ? 14 : 0)),
        27.7,
      ),
    ]).to.deep.equal([2]);
  });

  it('have five rays, no two in one of five rows or columns', () => {
    const all = [[0, 0], ...edgeOffsets];
    for (const axis of [0, 1]) {
      const places = new Set(all.map((offset) => Math.round(5 * offset[axis] + 2)));
      expect(places).to.deep.equal(new Set([0, 1, 2, 3, 4]));
    }
  });
});

describe('the silhouette of a lit sphere', () => {
  const [edge, radius, wide] = [64, 20, 64];
  const volume = syntheticVolume({ dimensions: [edge, edge, edge], kind: 'float32', field: () => 0 });
  const from = ([x, y, z]: Vector3): Vector3 => [edge * (x - 0.5), edge * (y - 0.5), edge * (z - 0.5)];
  const field = storedField((place) => edge - Math.hypot(...from(place)), { slope: 1, intercept: 0 });
  const projection: Matrix4 = [2 / wide, 0, 0, 0, 0, 2 / wide, 0, 0, 0, 0, -0.001, 0, 0, 0, 0, 1];
  const rays = setUpRays(
    volume.grid,
    viewMatrix(orbitCamera({ theta: 0.4, phi: 1.2, radius: 200 }, [0, 0, 0], 0.3)),
    projection,
  )!;
  const gradient = (place: Vector3): { perVoxel: Vector3; world: Vector3 } => {
    const outward = transformDirection(
      unitToWorld(volume.grid),
      from(place).map((x) => -x / edge) as unknown as Vector3,
    );
    return { perVoxel: outward, world: outward };
  };
  const light = lightAt({ grid: volume.grid, gradient, flat: 1e-9 });
  const gather = surfaceGather({
    surfaces: [{ value: edge - radius, color: [1, 0.9, 0.8], opacity: 1 }],
    isClear: true,
    light,
    toEye: (ray) => towardsEye(volume.grid, ray),
  });
  const stages = stagesOf(
    { ...volume, ...plainOptics, field, stepLength: 1, maxSubsteps: 1, moreFields: [pointField], gather },
    rays,
  );
  const raysAt = (size: number, first: readonly [number, number] = [0, 0]): RaySetup =>
    raysOfLattice(rays, { width: size, height: size }, { stride: 1, first, width: size, height: size });
  const cast = (ray: Ray): number[] => castRay(stages, ray).map((x) => 255 * x);
  const picture = (size: number, first?: readonly [number, number]): number[] =>
    castPixels(raysAt(size, first), [size, size], cast);
  /** Rays a pixel each way, of the mean that is right. */
  const fine = 8;

  /** Whether the sphere's edge may run through a pixel: in no other pixel does one ray cover more than another. */
  function meetsEdge(size: number, pixel: number): boolean {
    const [x, y] = [pixel % size, Math.floor(pixel / size)].map((at) => (wide / size) * (at + 0.5 - size / 2));
    return Math.abs(Math.hypot(x, y) - radius) < wide / size;
  }

  /** The mean of what many rays of a pixel show. */
  function castMean(size: number, pixel: number): number[] {
    const sum = [0, 0, 0, 0];
    const offset = (i: number): number => (i + 0.5) / fine - 0.5;
    const all = raysAt(size);
    for (let i = 0; i < fine ** 2; i++)
      cast(rayOfPixel(all, [size, size], pixel, [offset(i % fine), offset(Math.floor(i / fine))])).forEach(
        (x, c) => (sum[c] += x / fine ** 2),
      );
    return sum;
  }

  interface Found {
    readonly before: number[];
    readonly after: Float64Array;
    readonly quads: Float32Array;
    /** Where the edge is, else what one ray shows. */
    readonly mean: Float64Array;
  }

  const measure = remember((size: number): Found => {
    const before = picture(size);
    const quads = findEdges({ data: before.map(Math.round), width: size, height: size }, 8 * Math.sqrt(12));
    const after = meanAtEdges([before, ...edgeOffsets.map((offset) => picture(size, offset))], quads, size);
    const mean = Float64Array.from(before);
    for (let pixel = 0; pixel < size ** 2; pixel++)
      if (meetsEdge(size, pixel)) mean.set(castMean(size, pixel), 4 * pixel);
    return { before, after, quads, mean };
  });

  it('is nearly four times nearer to the mean over its pixels, and its area too', function () {
    this.timeout(60_000);
    const found = [33, 38, 41, 46].map((size) => {
      const { before, after, quads, mean } = measure(size);
      // Pixels that are partly covered.
      const partly = (i: number): boolean => mean[i | 3] > 0.5 && mean[i | 3] < 254.5;
      const rmse = (one: ArrayLike<number>): number => {
        const off = Array.from(one, (x, i) => (partly(i) ? (x - mean[i]) ** 2 : -1)).filter((x) => x >= 0);
        return Math.sqrt(off.reduce((sum, x) => sum + x, 0) / off.length);
      };
      const area = (one: ArrayLike<number>): number =>
        ((Array.from(one).reduce((sum, x, i) => sum + (i % 4 === 3 ? x : 0), 0) / 255) * (wide / size) ** 2) /
          (Math.PI * radius ** 2) -
        1;
      console.log(
        `${size} pixels: RMSE ${rmse(before).toFixed(1)} with one ray, ${rmse(after).toFixed(1)} with five; area off by ${[before, after, mean].map((one) => (100 * area(one)).toFixed(3)).join(', ')} %, the last with ${fine ** 2}; ${((400 * quads.length) / size ** 2).toFixed(0)} % of the pixels`,
      );
      return { rmse: [rmse(before), rmse(after)], area: [area(before), area(after)] };
    });
    const rms = (values: readonly number[]): number =>
      Math.sqrt(values.reduce((sum, x) => sum + x * x, 0) / values.length);
    const [before, after] = [0, 1].map((i) => ({
      rmse: rms(found.map((one) => one.rmse[i])),
      area: rms(found.map((one) => one.area[i])),
    }));
    expect(before.rmse).to.be.above(35);
    expect(after.rmse).to.be.below(before.rmse / 3.5);
    expect(after.area).to.be.below(Math.min(0.002, before.area));
  });

  it('is all that changes', () => {
    const size = 41;
    const { before, after, quads } = measure(size);
    const columns = Math.ceil(size / 2);
    const chosen = new Set(quads);
    expect(
      after.every(
        (x, i) =>
          x === before[i] || chosen.has((Math.floor((i >> 2) / size) >> 1) * columns + (((i >> 2) % size) >> 1)),
      ),
    ).to.equal(true);
  });
});
