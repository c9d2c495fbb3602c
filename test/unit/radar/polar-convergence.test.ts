import { expect } from '@esm-bundle/chai';
import { projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { emission } from '../../../src/optics/transfer/emission.ts';
import { polarSampler } from '../../../src/radar/interpolate-polar.ts';
import { polarField } from '../../../src/radar/polar-field.ts';
import { intersectUnitCube, setUpRays } from '../../../src/optics/rays/rays.ts';
import type { Ray, RaySetup } from '../../../src/optics/rays/rays.ts';
import { castSceneRay, opticsOf } from '../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../src/optics/reference.ts';
import { attenuate, composite } from '../../../src/optics/rays/segment.ts';
import type { Premultiplied } from '../../../src/optics/transfer/transfer-function.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import { add, scale } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { unitToLocal } from '../../../src/radar/polar-geometry.ts';
import type { PolarVolume } from '../../../src/volume/volume.ts';
import { fitOrder } from '../../accuracy/orders.ts';
import { castPixels } from '../../helpers/pixel-rays.ts';
import { cloudCamera, cloudColors, cloudField, cloudVolume } from '../../helpers/polar-cloud.ts';

const [width, height] = [12, 9];

function picture(volume: PolarVolume, cast: (setup: RaySetup, ray: Ray) => Premultiplied): number[] {
  const setup = setUpRays(
    volume.grid,
    viewMatrix(cloudCamera),
    projectionMatrix(cloudCamera.fieldOfView, width / height, 1, 2),
  )!;
  return castPixels(setup, [width, height], (ray) => cast(setup, ray));
}

function sceneOf(volume: PolarVolume, steps: number, maxSubsteps?: number): ReferenceScene {
  return {
    ...volume,
    transferFunction: cloudColors,
    referenceLength: 3000,
    opacityFactor: 1,
    lightFactor: 1,
    stepLength: longestDiagonal(volume.grid) / steps,
    field: polarField(volume),
    maxSubsteps,
  };
}

function draw(volume: PolarVolume, steps: number, maxSubsteps?: number): number[] {
  const scene = sceneOf(volume, steps, maxSubsteps);
  const optics = opticsOf(scene);
  return picture(volume, (setup, ray) => castSceneRay(scene, setup, ray, optics));
}

/** The integral by samples at points. @param valueAt - by point of the unit cube */
function integrate(volume: PolarVolume, valueAt: (point: Vector3) => number, samples: number): number[] {
  return picture(volume, (setup, ray) => {
    const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
    const accumulated: Premultiplied = [0, 0, 0, 0];
    if (!(exit > entry)) return accumulated;
    const ratio = ((exit - entry) * ray.lengthPerT * setup.diameter) / 3000 / samples;
    for (let i = 0; i < samples; i++) {
      const value = valueAt(add(ray.point, scale(ray.direction, entry + ((i + 0.5) / samples) * (exit - entry))));
      if (!Number.isNaN(value)) composite(accumulated, attenuate(emission(cloudColors, value), ratio));
    }
    return accumulated;
  });
}

function rms(a: readonly number[], b: readonly number[]): number {
  return Math.sqrt(a.reduce((sum, x, i) => sum + (x - b[i]) ** 2, 0) / a.length);
}

function logOrder(what: string, counts: readonly number[], errors: readonly number[]): number {
  const order = fitOrder(counts, errors);
  console.log(
    `polar, ${what}: order ${order.toFixed(2)}; ${counts.map((n, i) => `${n}: ${(errors[i] * 255).toPrecision(3)}`).join(', ')}`,
  );
  return order;
}

describe('the picture of a polar grid converges', () => {
  it('with the step, as that of a cartesian grid does', () => {
    const volume = cloudVolume(1);
    const limit = integrate(volume, polarSampler(volume), 4096);
    const counts = [40, 60, 90, 135, 200];
    const errors = counts.map((steps) => rms(draw(volume, steps, 1), limit));
    expect(errors[0] * 255).to.be.above(0.05);
    expect(logOrder('step length', counts, errors)).to.be.at.least(1.9);
    const inSubsteps = counts.map((steps) => rms(draw(volume, steps), limit));
    logOrder('step length, with substeps', counts, inSubsteps);
    expect(inSubsteps[0]).to.be.below(errors[0] / 4);
  });

  it('with the distances of sweeps, radials and gates', () => {
    const counts = [1.5, 2.25, 3.375];
    const errors = counts.map((fineness) => {
      const volume = cloudVolume(fineness);
      const limit = integrate(volume, (point) => cloudField(unitToLocal(volume.grid.box, point)), 2048);
      return rms(draw(volume, 500), limit);
    });
    expect(errors[0] * 255).to.be.above(0.5);
    expect(logOrder('grid spacing', counts, errors)).to.be.at.least(1.9);
  });
});
