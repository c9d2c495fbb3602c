// The largest, the smallest and the mean value of all places of a line: exact, as very many samples of it tell.
import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { cubicAt, turnOfCubic } from '../../../../src/optics/rays/cubic.ts';
import { pickRay } from '../../../../src/optics/pick-ray.ts';
import { sampleSlab } from '../../../../src/optics/attachments/plane-slices.ts';
import { projectionGather } from '../../../../src/optics/rays/projection.ts';
import { cartesianField } from '../../../../src/optics/rays/ray-field.ts';
import { projectionKinds } from '../../../../src/optics/rays/ray-style.ts';
import type { ProjectionKind } from '../../../../src/optics/rays/ray-style.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import { cutToVoxels, meetVoxelPlanes } from '../../../../src/optics/rays/voxel-planes.ts';
import { fillRows } from '../../../../src/panes/fill-slice.ts';
import type { SlicePixels } from '../../../../src/panes/fill-slice.ts';
import { lineMerger } from '../../../../src/panes/merge-line.ts';
import { linearSampler, nearestSampler } from '../../../../src/panes/sample-at.ts';
import { SlicedVolume } from '../../../../src/panes/slice-field.ts';
import { planeOf } from '../../../../src/panes/slice-plane.ts';
import type { CartesianGrid } from '../../../../src/volume/grid.ts';
import { boundingSphere } from '../../../../src/volume/grid.ts';
import { normalize, transformDirection, transformPoint } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const dimensions: Vector3 = [9, 7, 8];
const random = randomNumbers(350);
const noise = Float32Array.from({ length: 9 * 7 * 8 }, () => Math.fround(random()));
const within = (low: number, high: number): number => low + random() * (high - low);

/** One bright voxel, at 4 3 5, in the dark. */
const speck = syntheticVolume({ dimensions: [9, 7, 11], spacing: [1, 1.5, 0.8], kind: 'uint8', field: () => 0 });
speck.samples[4 + 9 * (3 + 7 * 5)] = 255;

/** Of very many places, evenly: the mean in the middles of as many parts. */
function lookFinely(valueAt: (share: number) => number, parts: number): Record<ProjectionKind, number> {
  let [max, min, sum, count] = [-Infinity, Infinity, 0, 0];
  for (let i = 0; i < parts; i++) {
    const value = valueAt((i + 0.5) / parts);
    if (Number.isNaN(value)) continue;
    [max, min, sum, count] = [Math.max(max, value), Math.min(min, value), sum + value, count + 1];
  }
  return { max, min, average: sum / count };
}

describe('a cubic', () => {
  it('turns where its slope is nought: x^3 - 3 x around 2, and flat ones nowhere', () => {
    const values = [0, 1, 2, 3].map((u) => (u - 1.5) ** 3 - 0.75 * (u - 1.5)) as [number, number, number, number];
    expect(turnOfCubic(values, 1)).to.be.closeTo(1, 1e-12);
    expect(turnOfCubic(values, -1)).to.be.closeTo(2, 1e-12);
    expect(cubicAt(values, 1)).to.be.closeTo(0.25, 1e-12);
    expect(turnOfCubic([2, 2, 2, 2], 1)).to.satisfy(Number.isNaN);
    expect(turnOfCubic([0, 2, 2, 0], 1), 'a parabola').to.be.closeTo(1.5, 1e-12);
  });
});

describe("planes of voxels' centres", () => {
  it('are met where a coordinate is a whole number of voxels, and nowhere beyond the outermost', () => {
    expect(meetVoxelPlanes([-0.5, 2, 2], [4, 0, 0], [3, 5, 5])).to.deep.equal([0.125, 0.375, 0.625]);
    expect(meetVoxelPlanes([2.5, 2, 2], [-4, 0, 0], [3, 5, 5], 0.5)).to.deep.equal([0.25, 0.5]);
    expect(cutToVoxels([-2.5, 2, 2], [8, 0, 0], [3, 5, 5])).to.deep.equal([0.25, 0.625]);
    expect(cutToVoxels([-2.5, 9, 2], [8, 0, 0], [3, 5, 5])).to.equal(null);
  });
});

describe('a line through voxels', () => {
  it('has the extremes and the mean of all of its places, in any direction, with nearest values too', () => {
    const block = { samples: noise, dimensions, hasNoData: false };
    for (let n = 0; n < 120; n++) {
      const from: Vector3 = [within(-3, 10), within(-3, 9), within(-3, 9)];
      const axis = n % 3;
      const way: Vector3 =
        n % 4 === 0
          ? ([0, 0, 0].map((_, i) => (i === axis ? within(-14, 14) : 0)) as unknown as Vector3)
          : [within(-14, 14), within(-14, 14), within(-14, 14)];
      for (const isNearest of [false, true]) {
        const sampleAt = (isNearest ? nearestSampler : linearSampler)(block);
        const fine = lookFinely(
          (share) => sampleAt(from[0] + share * way[0], from[1] + share * way[1], from[2] + share * way[2]),
          8000,
        );
        for (const kind of projectionKinds) {
          const value = lineMerger(block, { way, kind, isNearest })(...from);
          if (!Number.isFinite(fine.max)) {
            expect(value).to.satisfy((x: number) => Number.isNaN(x) || cutToVoxels(from, way, dimensions) !== null);
            continue;
          }
          if (kind === 'max') expect(value).to.be.at.least(fine.max - 1e-12);
          if (kind === 'min') expect(value).to.be.at.most(fine.min + 1e-12);
          // What lies between two of the many samples: a slope of some voxels' values in an eight-thousandth of the line.
          expect(value, `${kind} ${isNearest} ${n}`).to.be.closeTo(
            fine[kind],
            isNearest && kind !== 'average' ? 1e-2 : 4e-3,
          );
        }
      }
    }
  });

  it('of one value has that value, to the last bit', () => {
    const block = { samples: new Float32Array(noise.length).fill(0.1), dimensions, hasNoData: false };
    for (const kind of projectionKinds)
      expect(lineMerger(block, { way: [3, 4, 5], kind, isNearest: false })(0.3, 0.2, 0.1), kind).to.equal(
        Math.fround(0.1),
      );
  });

  it('leaves out what has no data', () => {
    const samples = Float32Array.from(noise, (value, i) => (i % 5 === 0 ? NaN : value));
    const block = { samples, dimensions, hasNoData: true };
    const sampleAt = linearSampler(block);
    for (let n = 0; n < 40; n++) {
      const [from, way]: [Vector3, Vector3] = [
        [within(0, 3), within(0, 3), within(0, 3)],
        [within(1, 5), within(1, 3), within(1, 4)],
      ];
      const fine = lookFinely(
        (share) => sampleAt(from[0] + share * way[0], from[1] + share * way[1], from[2] + share * way[2]),
        4000,
      );
      expect(lineMerger(block, { way, kind: 'average', isNearest: false })(...from)).to.be.closeTo(fine.average, 0.05);
      expect(lineMerger(block, { way, kind: 'max', isNearest: false })(...from))
        .to.be.closeTo(fine.max, 0.08)
        .and.at.most(1);
    }
  });
});

describe('a slab', () => {
  // By definition: the largest of the slab's voxels is 255. numpy.max of the array says the same.
  it('of the largest values shows a single voxel as it is, wherever the slab is and whichever way it looks', () => {
    const grid = speck.grid as CartesianGrid;
    const sliced = new SlicedVolume(speck, grid);
    const voxel = transformPoint(grid.indexToWorld, [4, 3, 5]);
    const normals: [string, Vector3][] = [
      ['axial', [0, 0, 1]],
      ['coronal', [0, 1, 0]],
      ['sagittal', [1, 0, 0]],
      ['oblique', normalize([1, -2, 2])],
      ['oblique', normalize([3, 1, 5])],
    ];
    for (const [type, normal] of normals) {
      const { right, up } = planeOf(type as 'oblique', normal);
      for (const off of [0, 0.13, 0.25, -0.4, 0.9]) {
        const first = voxel.map((x, axis) => x + off * normal[axis]) as unknown as Vector3;
        const pixels: SlicePixels = {
          width: 1,
          height: 1,
          first,
          across: right,
          down: up.map((x) => -x) as unknown as Vector3,
        };
        for (const isNearest of [false, true]) {
          const values = new Float64Array(1);
          fillRows(
            { field: sliced.field(isNearest), pixels, slab: { normal, thickness: 4, projection: 'max' } },
            values,
            [0, 1],
          );
          expect(values[0], `${type} ${off} ${isNearest}`).to.be.closeTo(255, 1e-9);
        }
      }
    }
  });

  it('that is painted in the picture shows what a pane shows', () => {
    const volume = syntheticVolume({ dimensions, kind: 'float32', field: () => random() });
    const sliced = new SlicedVolume(volume, volume.grid as CartesianGrid);
    const field = cartesianField({ ...volume, dimensions });
    for (let n = 0; n < 60; n++) {
      const normal =
        n % 3 === 0
          ? (
              [
                [1, 0, 0],
                [0, 1, 0],
                [0, 0, 1],
              ] as const
            )[(n / 3) % 3]
          : normalize([within(-1, 1), within(-1, 1), within(-1, 1)]);
      const at: Vector3 = [within(0, 8), within(0, 6), within(0, 7)];
      const pixels: SlicePixels = {
        width: 1,
        height: 1,
        first: transformPoint((volume.grid as CartesianGrid).indexToWorld, at),
        across: planeOf('oblique', normal).right,
        down: planeOf('oblique', normal).up,
      };
      for (const kind of projectionKinds) {
        const values = new Float64Array(1);
        fillRows(
          { field: sliced.field(false), pixels, slab: { normal, thickness: 5, projection: kind } },
          values,
          [0, 1],
        );
        const way = transformDirection(sliced.worldToIndex, normal).map(
          (x, axis) => (5 * x) / dimensions[axis],
        ) as unknown as Vector3;
        const place = at.map((x, axis) => (x + 0.5) / dimensions[axis]) as unknown as Vector3;
        expect(sampleSlab(field, place, { way, kind }).value, `${kind} ${n}`).to.be.closeTo(values[0], 1e-9);
      }
    }
  });
});

describe('a ray that is projected', () => {
  const plain = {
    transferFunction: [{ value: 0, color: [1, 1, 1], opacity: 1 }],
    referenceLength: 1,
    opacityFactor: 1,
    lightFactor: 1,
  } as const;
  const volume = syntheticVolume({ dimensions, kind: 'float32', field: () => random() });
  const raysFrom = (of: typeof volume, theta: number, phi: number): ReturnType<typeof setUpRays> =>
    setUpRays(
      of.grid,
      viewMatrix(orbitCamera({ theta, phi, radius: 60 }, boundingSphere(of.grid).center, 0.25)),
      projectionMatrix(0.25, 1, 1, 1e3),
    );

  it('shows the extremes and the mean of all of its places, whatever the steps', () => {
    for (let n = 0; n < 30; n++) {
      const rays = raysFrom(volume, within(0, 6), within(0.2, 2.9))!;
      const ray = rayThrough(rays, within(-0.5, 0.5), within(-0.5, 0.5));
      const valueOf = (kind: ProjectionKind, stepLength: number): number => {
        const stages = stagesOf({ ...volume, ...plain, stepLength, gather: projectionGather(kind) }, rays);
        const [value, , , alpha] = castRay(
          { ...stages, classify: { ...stages.classify, classifyValue: (v) => [v, 0, 0, 1] } },
          ray,
        );
        return alpha > 0 ? value : NaN;
      };
      const stages = stagesOf({ ...volume, ...plain, stepLength: 1 }, rays);
      const { entry, exit } = stages.intervals.reduce((interval, stage) => stage(ray, interval), {
        entry: -Infinity,
        exit: Infinity,
        behind: null,
      } as Parameters<(typeof stages.intervals)[0]>[1]);
      if (!(exit > entry)) continue;
      const fine = lookFinely(
        (share) =>
          stages.field.sampleAt(
            ray.point.map(
              (x, axis) => x + (entry + share * (exit - entry)) * ray.direction[axis],
            ) as unknown as Vector3,
          ).value,
        8000,
      );
      for (const kind of projectionKinds) {
        expect(valueOf(kind, 0.9), kind).to.be.closeTo(fine[kind], 4e-3);
        expect(valueOf(kind, 0.9)).to.equal(valueOf(kind, 7));
      }
      expect(valueOf('max', 2)).to.be.at.least(fine.max - 1e-12);
      expect(valueOf('min', 2)).to.be.at.most(fine.min + 1e-12);
    }
  });

  it('through a single voxel shows all of it, whichever way it is seen, and is picked there', () => {
    for (let n = 0; n < 40; n++) {
      const rays = raysFrom(speck, within(0, 6), within(0.2, 2.9))!;
      const stages = stagesOf({ ...speck, ...plain, stepLength: 1, gather: projectionGather('max') }, rays);
      const place: Vector3 = [4.5 / 9, 3.5 / 7, 5.5 / 11];
      // From where the eye is, through the voxel's centre.
      const { direction, point, ...rest } = rayThrough(rays, 0, 0);
      const ray = {
        ...rest,
        direction,
        point: place.map((x, axis) => x - 0.013 * direction[axis]) as unknown as Vector3,
      };
      const seen = castRay(
        { ...stages, eyeT: -Infinity, classify: { ...stages.classify, classifyValue: (v) => [v, 0, 0, 1] } },
        ray,
      );
      expect(seen[0], `${n}: ${point.join(' ')}`).to.be.closeTo(255 * speck.slope + speck.intercept, 1e-9);
      const picked = pickRay({ ...stages, eyeT: -Infinity }, ray, {
        at: 'jump',
        look: { transferFunction: plain.transferFunction, projection: 'max' },
      })!;
      for (let axis = 0; axis < 3; axis++) expect(picked.place[axis]).to.be.closeTo(place[axis], 1e-6);
    }
  });
});
