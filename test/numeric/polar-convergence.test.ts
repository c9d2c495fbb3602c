import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../src/optics/camera.ts';
import { emission } from '../../src/optics/emission.ts';
import { polarSampler } from '../../src/radar/interpolate-polar.ts';
import { polarField } from '../../src/radar/polar-field.ts';
import { intersectUnitCube, rayThrough, setUpRays } from '../../src/optics/rays.ts';
import type { Ray, RaySetup } from '../../src/optics/rays.ts';
import { castSceneRay, opticsOf } from '../../src/optics/reference.ts';
import type { ReferenceScene } from '../../src/optics/reference.ts';
import { attenuate, composite } from '../../src/optics/segment.ts';
import type { Premultiplied, TransferFunction } from '../../src/optics/transfer-function.ts';
import { longestDiagonal } from '../../src/volume/grid.ts';
import { add, scale } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { beamToLocal, unitToLocal } from '../../src/radar/polar-geometry.ts';
import type { PolarVolume } from '../../src/volume/volume.ts';
import { fitOrder } from '../accuracy/orders.ts';
import { evenAzimuths, radarVolume } from '../helpers/synthetic-radar.ts';

const reach = 40_000;

/** A cloud that ends well inside of what the radar sees: where data end, pictures are of first order only. */
const center: Vector3 = beamToLocal({ range: 20_000, azimuth: 70, elevation: 28 }, Infinity);
const field = ([x, y, z]: Vector3): number => Math.exp(-((x - center[0]) ** 2 + (y - center[1]) ** 2 + 2 * (z - center[2]) ** 2) / 6000 ** 2);

const cloud: TransferFunction = Array.from({ length: 129 }, (_, i) => {
  const value = i / 128;
  return { value, color: [value, 0.5, 1 - value], opacity: 0.5 * value * value };
});

/** @param fineness - 1: 12 sweeps, 40 radials, 20 gates */
function volumeOf(fineness: number): PolarVolume {
  const [sweeps, rays, gates] = [12, 40, 20].map((n) => Math.round(n * fineness));
  const gateLength = reach / gates;
  const firstGate = gateLength / 2;
  return radarVolume({
    beamWidth: 1,
    sweeps: Array.from({ length: sweeps }, (_, i) => {
      const elevation = (i / (sweeps - 1)) * 60;
      return {
        elevation, azimuths: evenAzimuths(rays), gates, gateLength, firstGate, kind: 'float32', slope: 1, intercept: 0,
        stored: (azimuth, gate) => field(beamToLocal({ range: firstGate + gate * gateLength, azimuth, elevation }, Infinity)),
      };
    }),
  }, { beamModel: 'straight', verticalExaggeration: 1 });
}

const [width, height] = [12, 9];

function picture(volume: PolarVolume, cast: (setup: RaySetup, ray: Ray) => Premultiplied): number[] {
  // From outside of the box, at the cloud.
  const camera = orbitCamera({ theta: 0.5, phi: 1.2, radius: 150_000 }, center, 0.16);
  const setup = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(camera.fieldOfView, width / height, 1, 2))!;
  return Array.from({ length: width * height }, (_, i) => {
    const x = (((i % width) + 0.5) / width) * 2 - 1;
    const y = 1 - ((Math.floor(i / width) + 0.5) / height) * 2;
    return cast(setup, rayThrough(setup, x, y));
  }).flat();
}

function sceneOf(volume: PolarVolume, steps: number, maxSubsteps?: number): ReferenceScene {
  return {
    ...volume, transferFunction: cloud, referenceLength: 3000, opacityFactor: 1, lightFactor: 1,
    stepLength: longestDiagonal(volume.grid) / steps, field: polarField(volume), maxSubsteps,
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
      if (!Number.isNaN(value)) composite(accumulated, attenuate(emission(cloud, value), ratio));
    }
    return accumulated;
  });
}

function rms(a: readonly number[], b: readonly number[]): number {
  return Math.sqrt(a.reduce((sum, x, i) => sum + (x - b[i]) ** 2, 0) / a.length);
}

function tell(what: string, counts: readonly number[], errors: readonly number[]): number {
  const order = fitOrder(counts, errors);
  console.log(`polar, ${what}: order ${order.toFixed(2)}; ${counts.map((n, i) => `${n}: ${(errors[i] * 255).toPrecision(3)}`).join(', ')}`);
  return order;
}

describe('the picture of a polar grid converges', () => {
  it('with the step, as that of a cartesian grid does', () => {
    const volume = volumeOf(1);
    const limit = integrate(volume, polarSampler(volume), 4096);
    const counts = [40, 60, 90, 135, 200];
    const errors = counts.map((steps) => rms(draw(volume, steps, 1), limit));
    expect(errors[0] * 255).to.be.above(0.05);
    expect(tell('step length', counts, errors)).to.be.at.least(1.9);
    const inParts = counts.map((steps) => rms(draw(volume, steps), limit));
    tell('step length, with substeps', counts, inParts);
    expect(inParts[0]).to.be.below(errors[0] / 4);
  });

  it('with the distances of sweeps, radials and gates', () => {
    const counts = [1.5, 2.25, 3.375];
    const errors = counts.map((fineness) => {
      const volume = volumeOf(fineness);
      const limit = integrate(volume, (point) => field(unitToLocal(volume.grid.box, point)), 2048);
      return rms(draw(volume, 500), limit);
    });
    expect(errors[0] * 255).to.be.above(0.5);
    expect(tell('grid spacing', counts, errors)).to.be.at.least(1.9);
  });
});
