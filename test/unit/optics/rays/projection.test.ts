import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { projectionGather } from '../../../../src/optics/rays/projection.ts';
import { projectionKinds } from '../../../../src/optics/rays/ray-style.ts';
import type { ProjectionKind } from '../../../../src/optics/rays/ray-style.ts';
import { storedField } from '../../../../src/optics/rays/ray-field.ts';
import type { FieldStage, Interval, RayStages } from '../../../../src/optics/rays/ray-stages.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import type { Ray, RaySetup } from '../../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import { add, scale } from '../../../../src/volume/matrix.ts';
import { cutRegion } from '../../../../src/volume/region.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const plain = {
  transferFunction: [{ value: 0, color: [1, 1, 1], opacity: 1 }],
  referenceLength: 1,
  opacityFactor: 1,
  lightFactor: 1,
} as const;

interface Cast {
  readonly kind: ProjectionKind;
  readonly threshold?: number;
  readonly stepLength: number;
  readonly field?: FieldStage;
  readonly region?: readonly number[];
}

function raysOf(volume: Volume, region?: readonly number[]): RaySetup {
  const camera = orbitCamera({ theta: 0.4, phi: 1.2, radius: 60 }, [0, 0, 0], 0.5);
  return setUpRays(
    volume.grid,
    viewMatrix(camera),
    projectionMatrix(0.5, 1, 1, 1e3),
    region ? cutRegion(volume.grid, region) : null,
  )!;
}

/** Rays in all directions through the middle of the picture. */
function listRays(rays: RaySetup, count: number): Ray[] {
  const random = randomNumbers(61);
  return Array.from({ length: count }, () => rayThrough(rays, 0.8 * random() - 0.4, 0.8 * random() - 0.4));
}

/** What a ray projects to, in data units; NaN where it is clear. */
function projectRay(volume: Volume, { kind, threshold, stepLength, field }: Cast, rays: RaySetup, ray: Ray): number {
  const scene = {
    ...volume,
    ...plain,
    stepLength,
    gather: projectionGather(kind, threshold),
    ...(field ? { field } : {}),
  };
  const stages: RayStages = stagesOf(scene, rays);
  const [value, , , alpha] = castRay(
    { ...stages, classify: { ...stages.classify, classifyValue: (v) => [v, 0, 0, 1] } },
    ray,
  );
  return alpha > 0 ? value : NaN;
}

function project(volume: Volume, cast: Cast, count = 40): number[] {
  const rays = raysOf(volume, cast.region);
  return listRays(rays, count).map((ray) => projectRay(volume, cast, rays, ray));
}

const bump = (x: number, y: number, z: number): number =>
  Math.exp(-9 * ((x - 0.45) ** 2 + (y - 0.52) ** 2 + (z - 0.5) ** 2)) + 0.2 * x - 0.1 * y * z;
const smooth = storedField(([x, y, z]) => bump(x, y, z), { slope: 1, intercept: 0 });
const negative = storedField(([x, y, z]) => -bump(x, y, z), { slope: 1, intercept: 0 });
const cube = syntheticVolume({ dimensions: [24, 24, 24], kind: 'float32', field: bump });
const rms = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot(...a.map((x, i) => x - b[i])) / Math.sqrt(a.length);

const open: Interval = { entry: -Infinity, exit: Infinity, behind: null };

/** Values at very many places of the same rays. */
function sampleFinely(stages: RayStages, ray: Ray, samples: number): number[] {
  const { entry, exit } = stages.intervals.reduce((interval, stage) => stage(ray, interval), open);
  return Array.from(
    { length: samples + 1 },
    (_, i) => stages.field.sampleAt(add(ray.point, scale(ray.direction, entry + ((exit - entry) * i) / samples))).value,
  );
}

describe('projection', () => {
  it('max is no less than any sample and no more than the field holds; min the same below', () => {
    const random = randomNumbers(62);
    const noise = syntheticVolume({ dimensions: [12, 12, 12], kind: 'float32', field: () => random() });
    for (const volume of [cube, noise]) {
      const rays = raysOf(volume);
      const stages = stagesOf({ ...volume, ...plain, stepLength: 1 }, rays);
      for (const ray of listRays(rays, 25)) {
        const fine = sampleFinely(stages, ray, 20_000);
        if (fine.some(Number.isNaN)) continue;
        for (const stepLength of [0.3, 0.9, 2.2]) {
          const [max, min] = (['max', 'min'] as const).map((kind) =>
            projectRay(volume, { kind, stepLength }, rays, ray),
          );
          // A fine sample misses a kink of slope 1 a voxel by a thousandth of a voxel.
          expect(max).to.be.at.most(Math.max(...fine) + 2e-3);
          expect(min).to.be.at.least(Math.min(...fine) - 2e-3);
          const coarse = listSamples(volume, stepLength, rays, ray);
          expect(max, `step ${stepLength}`).to.be.at.least(Math.max(...coarse));
          expect(min, `step ${stepLength}`).to.be.at.most(Math.min(...coarse));
        }
      }
    }
  });

  it('of voxels is nearer than samples are, where steps are shorter than a voxel', () => {
    const stepLength = 0.6;
    const limit = project(cube, { kind: 'max', stepLength: 0.004 });
    const rays = raysOf(cube);
    const samples = listRays(rays, 40).map((ray) => Math.max(...listSamples(cube, stepLength, rays, ray)));
    const [plainError, error] = [rms(samples, limit), rms(project(cube, { kind: 'max', stepLength }), limit)];
    console.log(`samples ${plainError.toExponential(1)}, refined ${error.toExponential(1)}`);
    expect(error).to.be.below(plainError / 8);
  });

  it('the mean of a constant is that constant, for any length and step', () => {
    const volume = syntheticVolume({ dimensions: [9, 7, 5], kind: 'float32', field: () => 0.3 });
    for (const stepLength of [0.01, 0.37, 1, 2.9, 1e3]) {
      for (const region of [undefined, [-3.1, -2, -1.7, 2.3, 1.1, 0.2]]) {
        const values = project(volume, { kind: 'average', stepLength, region }).filter((value) => !Number.isNaN(value));
        expect(values.length).to.be.above(4);
        for (const value of values) expect(value).to.equal(Math.fround(0.3));
      }
    }
  });

  it('of a field of straight lines is the value at an end, and in the middle', () => {
    const ramp = storedField(([x, y, z]) => 2 * x - y + 0.5 * z, { slope: 1, intercept: 0 });
    const rays = raysOf(cube);
    const stages = stagesOf({ ...cube, ...plain, stepLength: 1, field: ramp }, rays);
    for (const ray of listRays(rays, 20)) {
      const fine = sampleFinely(stages, ray, 2);
      for (const stepLength of [0.7, 3.3]) {
        expect(projectRay(cube, { kind: 'max', stepLength, field: ramp }, rays, ray)).to.be.closeTo(
          Math.max(...fine),
          1e-12,
        );
        expect(projectRay(cube, { kind: 'min', stepLength, field: ramp }, rays, ray)).to.be.closeTo(
          Math.min(...fine),
          1e-12,
        );
        expect(projectRay(cube, { kind: 'average', stepLength, field: ramp }, rays, ray)).to.be.closeTo(fine[1], 1e-12);
      }
    }
  });

  it('min is max of the opposite', () => {
    const max = project(cube, { kind: 'max', stepLength: 0.8, field: smooth });
    expect(project(cube, { kind: 'min', stepLength: 0.8, field: negative })).to.deep.equal(max.map((value) => -value));
  });

  it('is the first local maximum from a threshold on, and that of the whole ray where none reaches it', () => {
    // Two walls along x; the nearer one to the eye is the lower one, or the higher one.
    const wall = (x: number, at: number, height: number): number => height * Math.exp(-(((x - at) / 0.06) ** 2));
    const walls = (low: number, high: number): FieldStage =>
      storedField(([x]) => wall(x, low, 0.5) + wall(x, high, 1), { slope: 1, intercept: 0 });
    const camera = orbitCamera({ theta: Math.PI / 2, phi: Math.PI / 2, radius: 60 }, [0, 0, 0], 0.3);
    const rays = setUpRays(cube.grid, viewMatrix(camera), projectionMatrix(0.3, 1, 1, 1e3), null)!;
    const ray = rayThrough(rays, 0.01, 0.02);
    const [near, far] = ray.direction[0] < 0 ? [0.75, 0.25] : [0.25, 0.75];
    const cast = (field: FieldStage, threshold?: number, kind: ProjectionKind = 'max'): number =>
      projectRay(cube, { kind, threshold, stepLength: 0.4, field }, rays, ray);
    for (const [threshold, expected] of [
      [undefined, 1],
      [0.3, 0.5],
      [0.45, 0.5],
      [0.6, 1],
      [2, 1],
    ] as const)
      expect(cast(walls(near, far), threshold), `from ${threshold} on`).to.be.closeTo(expected, 2e-3);
    expect(cast(walls(far, near), 0.3), 'the higher wall is the nearer one').to.be.closeTo(1, 2e-3);
    const pits = storedField(([x]) => -wall(x, near, 0.5) - wall(x, far, 1), { slope: 1, intercept: 0 });
    expect([cast(pits, -0.3, 'min'), cast(pits, -0.6, 'min')].map((x) => Math.round(100 * x) / 100)).to.deep.equal([
      -0.5, -1,
    ]);
  });

  it('knows nothing where there are no data, and follows from what is next to them', () => {
    const nothing = syntheticVolume({ dimensions: [8, 8, 8], kind: 'float32', field: () => NaN });
    const half = syntheticVolume({ dimensions: [8, 8, 8], kind: 'float32', field: (x) => (x < 0.5 ? NaN : 0.75) });
    for (const kind of projectionKinds) {
      expect(project(nothing, { kind, stepLength: 0.5 }).every(Number.isNaN), kind).to.equal(true);
      const values = project(half, { kind, stepLength: 0.5 }).filter((value) => !Number.isNaN(value));
      expect(values.length).to.be.above(8);
      expect(new Set(values), kind).to.deep.equal(new Set([0.75]));
    }
  });

  it('does not average across a fold, nor find an extreme there', () => {
    // Two gates of 29 and -29 m/s: between them there is nothing, as values fold; either holds as far as the other one.
    const gates = storedField(([x]) => (x < 0.5 ? 29 : -29), { slope: 1, intercept: 0 }, 30);
    const rays = raysOf(cube);
    for (const ray of listRays(rays, 20)) {
      const values = sampleFinely(stagesOf({ ...cube, ...plain, stepLength: 1, field: gates }, rays), ray, 4000);
      const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
      expect(projectRay(cube, { kind: 'average', stepLength: 0.1, field: gates }, rays, ray)).to.be.closeTo(mean, 0.3);
      for (const kind of ['max', 'min'] as const)
        expect(Math.abs(projectRay(cube, { kind, stepLength: 0.7, field: gates }, rays, ray))).to.equal(29);
    }
  });

  it("shows a value in the transfer function's colour, and the largest opacity as 1, whatever lengths and steps are", () => {
    const volume = syntheticVolume({ dimensions: [9, 7, 5], kind: 'float32', field: () => 0.5 });
    const transferFunction = [
      { value: 0, color: [0, 0, 1], opacity: 0 },
      { value: 1, color: [1, 0, 0], opacity: 0.4 },
    ] as const;
    const rays = raysOf(volume);
    for (const [stepLength, referenceLength, opacityFactor] of [
      [0.1, 1, 1],
      [3, 100, 0.2],
    ]) {
      const scene = {
        ...volume,
        transferFunction,
        referenceLength,
        opacityFactor,
        lightFactor: 1,
        stepLength,
        gather: projectionGather('max'),
      };
      // At half way: opacity 0.2 of 0.4, and all of its colour is the upper stop's.
      expect(
        castRay(stagesOf(scene, rays), rayThrough(rays, 0, 0)).map((x) => Math.round(x * 1e9) / 1e9),
      ).to.deep.equal([0.5, 0, 0, 0.5]);
    }
  });
});

/** The samples of a ray alone. */
function listSamples(volume: Volume, stepLength: number, rays: RaySetup, ray: Ray): number[] {
  const values: number[] = [];
  const stages = stagesOf({ ...volume, ...plain, stepLength }, rays);
  castRay(
    {
      ...stages,
      gather: () => ({
        add: ({ front, back }) => void values.push(front.value, back.value),
        chooseSubsteps: () => 1,
        finish: () => [0, 0, 0, 0],
      }),
    },
    ray,
  );
  return values;
}
