import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { interpolate } from '../../../src/optics/rays/interpolate.ts';
import { extinction } from '../../../src/optics/transfer/opacity.ts';
import { rayThrough, setUpRays } from '../../../src/optics/rays/rays.ts';
import { storedField } from '../../../src/optics/rays/ray-field.ts';
import { shapeInterval } from '../../../src/optics/rays/ray-intervals.ts';
import { castSceneRay, renderReference } from '../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../src/optics/reference.ts';
import { maxSubsteps } from '../../../src/optics/rays/segment.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { meanExtinction } from '../../helpers/emission.ts';
import { smoothField, syntheticVolume } from '../../helpers/synthetic.ts';

const white = [1, 1, 1] as const;
const gray: TransferFunction = [
  { value: 0, color: [1, 1, 1], opacity: 0.1 },
  { value: 1, color: [1, 1, 1], opacity: 0.6 },
];
const colored: TransferFunction = [
  { value: 0, color: [0.2, 0, 1], opacity: 0 },
  { value: 1, color: [1, 0.8, 0], opacity: 0.3 },
];

function sceneOf(volume: Volume, options: Partial<ReferenceScene>): ReferenceScene {
  const defaults = { transferFunction: gray, referenceLength: 5, opacityFactor: 1, lightFactor: 1, stepLength: 1 };
  return { ...volume, ...defaults, ...options };
}

/** What a ray along z through the middle of a volume shows; it crosses nz voxels. */
function castAlongZ(scene: ReferenceScene) {
  const camera = orbitCamera({ theta: 0, phi: 0, radius: 1e3 }, [0, 0, 0], 1);
  const rays = setUpRays(scene.grid, viewMatrix(camera), projectionMatrix(1, 1, 1, 1e4))!;
  return castSceneRay(scene, rays, rayThrough(rays, 0, 0));
}

/** Slope of log(error) over log(step length), least squares. */
function fitOrder(steps: number[], errors: number[]): number {
  const x = steps.map((n) => -Math.log(n));
  const y = errors.map(Math.log);
  const mean = (v: number[]) => v.reduce((a, b) => a + b, 0) / v.length;
  const [mx, my] = [mean(x), mean(y)];
  return x.reduce((sum, xi, i) => sum + (xi - mx) * (y[i] - my), 0) / x.reduce((sum, xi) => sum + (xi - mx) ** 2, 0);
}

describe('the reference', () => {
  it('has 1 - exp(-tau L) of a uniform slab for any step, part steps and one long step included', () => {
    const volume = syntheticVolume({
      dimensions: [4, 4, 12],
      spacing: [1, 1, 0.75],
      field: () => 0.4,
      kind: 'float32',
    });
    const tau = extinction(0.1 + Math.fround(0.4) * 0.5) / 5;
    for (const steps of [0.5, 1, 1.0001, 2.7, 8, 33.3, 500, 2048]) {
      const [red, , , alpha] = castAlongZ(sceneOf(volume, { stepLength: 9 / steps }));
      expect(alpha, `${steps} steps`).to.be.closeTo(1 - Math.exp(-tau * 9), 1e-12);
      expect(red).to.be.closeTo(alpha, 1e-12);
    }
  });

  it('is the closed form of a field of straight lines where steps end on its kinks, and converges with their square elsewhere', () => {
    // Slices of opacity 0.1, 0.6 and 0.6: constant over a sixth of the way, linear over a third, constant over a half.
    const volume = syntheticVolume({
      dimensions: [2, 2, 3],
      spacing: [5, 5, 10],
      field: (_x, _y, z) => (z > 0.67 ? 0 : 1),
    });
    const tau = (30 / 5) * (extinction(0.1) / 6 + meanExtinction(0.1, 0.6) / 3 + extinction(0.6) / 2);
    const errorOf = (n: number): number =>
      Math.abs(castAlongZ(sceneOf(volume, { stepLength: 30 / n }))[3] - (1 - Math.exp(-tau)));
    for (const n of [6, 12, 96]) expect(errorOf(n), `${n} steps`).to.be.below(1e-12);
    // So many steps, of eight substeps each, have both kinks within a substep.
    const steps = [4, 7, 13, 25, 49];
    const errors = steps.map(errorOf);
    expect(fitOrder(steps, errors), errors.join(' ')).to.be.above(1.9);
    expect(errors[4]).to.be.below(5e-5);
  });

  it('converges with order 1.9 or more on a smooth field, every channel, oblique rays', () => {
    const volume = syntheticVolume({ dimensions: [40, 36, 44], kind: 'float32' });
    const camera = orbitCamera({ theta: 0.5, phi: 1.1, radius: 90 }, [0, 0, 0], 0.5);
    const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(0.5, 1, 1, 1e3))!;
    const picture = (steps: number): Float64Array =>
      renderReference(sceneOf(volume, { transferFunction: colored, stepLength: 70 / steps }), rays, 6, 6);
    const exact = picture(6000);
    const steps = [15, 30, 60, 120, 240];
    const errors = steps.map((n) =>
      Math.sqrt(picture(n).reduce((sum, x, i) => sum + (x - exact[i]) ** 2, 0) / exact.length),
    );
    expect(fitOrder(steps, errors), errors.join(' ')).to.be.above(1.9);
  });

  it('depends neither on the unit of length nor on where the world begins', () => {
    const at = (unit: number, offset: number) => {
      const indexToWorld = [unit, 0.1 * unit, 0, offset, 0, -unit, 0, offset, 0, 0, 2 * unit, offset, 0, 0, 0, 1];
      const volume = syntheticVolume({ dimensions: [10, 10, 10], indexToWorld });
      const target: Vector3 = [offset + 4.95 * unit, offset - 4.5 * unit, offset + 9 * unit];
      const camera = orbitCamera({ theta: 2, phi: 1, radius: 40 * unit }, target, 0.6);
      const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(0.6, 1, unit, 100 * unit))!;
      const scene = sceneOf(volume, { transferFunction: colored, stepLength: 0.7 * unit, referenceLength: 2 * unit });
      return renderReference(scene, rays, 7, 7);
    };
    const expected = at(1, 0);
    expect(Math.max(...expected)).to.be.above(0.3);
    // Rounding of the offset, 1e-16 * 1e7 voxels, against a picture that changes over a voxel.
    for (const [unit, offset, tolerance] of [
      [1e-6, 0, 1e-10],
      [1e6, 0, 1e-10],
      [1, 1e7, 1e-6],
    ]) {
      at(unit, offset).forEach((x, i) => expect(x).to.be.closeTo(expected[i], tolerance));
    }
  });

  it('does not depend on the size of voxels, except for what interpolation loses: a quarter when they are halved', () => {
    // Flat at both ends, so that the outer half voxels, which hold it constant, are of second order too.
    const field = (_x: number, _y: number, z: number): number => 0.5 - 0.5 * Math.cos(2 * Math.PI * z);
    const cast = (n: number) => {
      const volume = syntheticVolume({ dimensions: [2, 2, n], spacing: [9, 9, 64 / n], kind: 'float32', field });
      return castAlongZ(sceneOf(volume, { transferFunction: colored, stepLength: 0.01 }));
    };
    const exact = cast(2048);
    expect(exact[3]).to.be.within(0.5, 0.99);
    const errors = [8, 16, 32].map((n) => Math.abs(cast(n)[3] - exact[3]));
    expect(errors[2], errors.join(' ')).to.be.below(1e-3);
    expect(fitOrder([8, 16, 32], errors), errors.join(' ')).to.be.within(1.8, 2.2);
  });

  it('ends rays at opaque shapes', () => {
    const volume = syntheticVolume({ dimensions: [4, 4, 10], field: () => 0.5, kind: 'float32' });
    const tau = extinction(0.35) / 5;
    // The volume's centre is t = 0 and its nearest face half of the ten voxels ahead of it.
    const half = castAlongZ(sceneOf(volume, { ends: [shapeInterval(() => 0)] }));
    expect(half[3]).to.be.closeTo(1 - Math.exp(-tau * 5), 1e-12);
    expect(castAlongZ(sceneOf(volume, { ends: [shapeInterval(() => -9)] }))).to.deep.equal([0, 0, 0, 0]);
    expect(castAlongZ(sceneOf(volume, { ends: [shapeInterval(() => Infinity)] }))[3]).to.be.closeTo(
      1 - Math.exp(-tau * 10),
      1e-12,
    );
  });

  it('applies slope and intercept before the transfer function', () => {
    const field = (_x: number, _y: number, z: number): number => smoothField(0.5, 0.5, z);
    const plain = syntheticVolume({ dimensions: [4, 4, 20], field, kind: 'uint16' });
    const houndsfield = syntheticVolume({
      dimensions: [4, 4, 20],
      field,
      kind: 'uint16',
      slope: 4000,
      intercept: -1000,
    });
    const rescaled = colored.map((stop) => ({ ...stop, value: stop.value * 4000 - 1000 }));
    const expected = castAlongZ(sceneOf(plain, { transferFunction: colored }));
    castAlongZ(sceneOf(houndsfield, { transferFunction: rescaled })).forEach((x, c) =>
      expect(x).to.be.closeTo(expected[c], 1e-12),
    );
    expect(expected[3]).to.be.above(0.1);
  });

  it('takes half of a part next to an end without data for empty', () => {
    // Eleven slices seen from +z, data in the nearer six: they reach half way to the next slice, which is 6 deep.
    const volume = syntheticVolume({
      dimensions: [4, 4, 11],
      kind: 'float32',
      field: (_x, _y, z) => (z < 0.45 ? NaN : 0.5),
    });
    const tau = extinction(0.35) / 5;
    for (const stepLength of [0.7, 2.2, 3.1, 4.1, 20]) {
      const { 3: alpha } = castAlongZ(sceneOf(volume, { stepLength, maxSubsteps: 5 }));
      // Where there are data, each step is cut into as many substeps as there may be; the only one of 20 is what the ray is long.
      const substep = Math.min(stepLength, 11) / 5;
      const length = (Math.floor(6 / substep) + 0.5) * substep;
      expect(alpha, `steps of ${stepLength}`).to.be.closeTo(1 - Math.exp(-tau * length), 1e-12);
    }
  });

  it('cuts a step into substeps where something may be seen, and only there', () => {
    // A peak that no sample of a step of 10 hits, in a field that rises by 1 over 40.
    const volume = syntheticVolume({ dimensions: [2, 2, 40], kind: 'float32', field: (_x, _y, z) => z });
    const samplesWith = (value: number): number => {
      let samples = 0;
      const stops = [
        { value: value - 0.01, color: white, opacity: 0 },
        { value, color: white, opacity: 0.9 },
        { value: value + 0.01, color: white, opacity: 0 },
      ];
      const valueAt = (point: Vector3): number => {
        samples++;
        return interpolate(volume.samples, volume.grid.dimensions, point);
      };
      castAlongZ(sceneOf(volume, { stepLength: 10, transferFunction: stops, field: storedField(valueAt, volume) }));
      return samples;
    };
    expect(samplesWith(5)).to.equal(5);
    expect(samplesWith(0.62)).to.be.within(6, 5 + 3 * (maxSubsteps - 1));
  });
});
