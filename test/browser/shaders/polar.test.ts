import { expect } from '@esm-bundle/chai';
import { polarSampler } from '../../../src/radar/interpolate-polar.ts';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { fieldChunks } from '../../../src/renderer/ray/compose-ray.ts';
import { beamToLocal, localToBeam } from '../../../src/radar/polar-geometry.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { PolarVolume, Volume } from '../../../src/volume/volume.ts';
import { finishUpload } from '../../../src/renderer/textures/fill-texture.ts';
import { polarText, uploadPolarVolume } from '../../../src/radar/gpu/polar-field-module.ts';
import { createGl, releaseGl, runChunk } from '../../helpers/gl.ts';
import type { TestGl } from '../../helpers/gl.ts';
import { sampleOnGpu } from '../../helpers/sample-field.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';
import { evenAzimuths, polarScenes, radarVolume } from '../../helpers/synthetic-radar.ts';
import type { RadarOptions } from '../../helpers/synthetic-radar.ts';

const plain = polarText({ twoBytes: false, radialElevations: false, folds: false, crowds: false });

/** Anywhere, and where it is hard: on gates, at the seam, on the axis, at the antenna and at the ends. */
function pointsOf({ grid }: PolarVolume): Vector3[] {
  const random = randomNumbers(50);
  const { low, high } = grid.box;
  const toUnit = (local: Vector3): Vector3 =>
    local.map((x, axis) => (x - low[axis]) / (high[axis] - low[axis])) as unknown as Vector3;
  const points: Vector3[] = Array.from({ length: 600 }, () => [random(), random(), random()]);
  for (let i = 0; i < 900; i++) {
    const sweep = grid.sweeps[i % grid.sweeps.length];
    const elevation = sweep.elevation + (i % 3) * (random() - 0.5);
    const ray = Math.floor(random() * sweep.azimuths.length);
    const azimuth = sweep.azimuths[ray] + (i % 2) * (random() - 0.5) * 3;
    const range = sweep.firstGate + random() * sweep.gates * sweep.gateLength;
    points.push(toUnit(beamToLocal({ range, azimuth, elevation }, grid.earthRadius)));
    if (i % 9 === 0)
      points.push(toUnit(beamToLocal({ range, azimuth: (random() - 0.5) / 50, elevation }, grid.earthRadius)));
    if (i % 9 === 1) points.push(toUnit([0, 0, low[2] + random() * (high[2] - low[2])]));
  }
  points.push(toUnit([0, 0, 0]), toUnit([0, 1e-3, 1e-5]));
  return points.map((p) => p.map(Math.fround) as unknown as Vector3).filter((p) => p.every((x) => x >= 0 && x <= 1));
}

/**
 * How far values around a point are apart: across a jump either side is right. NaN where some have no data.
 * @param step - of the unit cube; float32 knows an azimuth to so much of a place's distance, however narrow the box
 */
function spreadAround(valueAt: (p: Vector3) => number, p: Vector3, step: Vector3): number {
  const signs = [-1, 0, 1];
  const values = signs.flatMap((x) =>
    signs.flatMap((y) => signs.map((z) => valueAt([p[0] + x * step[0], p[1] + y * step[1], p[2] + z * step[2]]))),
  );
  const valid = values.filter((value) => !Number.isNaN(value)).length;
  if (valid === 0) return 0;
  return valid < values.length ? NaN : Math.max(...values) - Math.min(...values);
}

function sample(test: TestGl, volume: Volume, at: Vector3[], maxTextureSize = test.device.maxTextureSize): number[] {
  return sampleOnGpu(
    test,
    volume,
    finishUpload(uploadPolarVolume(test.gl, volume, { ...test.device, maxTextureSize })),
    at,
  );
}

/** Largest difference, as a share of the type's full scale, of points that are near no jump and where values run smoothly. */
function compare(
  test: TestGl,
  options: RadarOptions,
  maxTextureSize?: number,
): { worst: number; compared: number; valid: number; all: number } {
  const volume = radarVolume(options);
  const valueAt = polarSampler(volume);
  const at = pointsOf(volume);
  const full = volume.samples instanceof Float32Array ? 1 : volume.samples instanceof Uint16Array ? 65535 : 255;
  const got = sample(test, volume, at, maxTextureSize);
  const [east, north] = [0, 1].map((axis) => volume.grid.box.high[axis] - volume.grid.box.low[axis]);
  const step: Vector3 = [(2e-6 * Math.max(east, north)) / east, (2e-6 * Math.max(east, north)) / north, 2e-6];
  let [worst, compared, valid] = [0, 0, 0];
  at.forEach((p, i) => {
    const spread = spreadAround(valueAt, p, step);
    if (!(spread < 0.02 * full)) return;
    const expected = valueAt(p);
    compared++;
    if (Number.isNaN(expected) !== Number.isNaN(got[i]))
      throw new Error(`at ${p.join(' ')}: got ${got[i]}, expected ${expected}`);
    if (Number.isNaN(expected)) return;
    valid++;
    const difference = Math.abs(got[i] - expected) / full;
    // Next to the antenna gates lie so close that float32 can't tell places as far apart as the spread's.
    if (difference > spread / full + 1e-5) throw new Error(`at ${p.join(' ')}: got ${got[i]}, expected ${expected}`);
    if (spread < 1e-3 * full) worst = Math.max(worst, difference);
  });
  return { worst, compared, valid, all: at.length };
}

for (const version of [1, 2] as const) {
  describe(`a polar volume in WebGL ${version}`, () => {
    let test: TestGl;
    before(() => (test = createGl(version)));
    after(() => releaseGl(test));

    it('arc tangent: right to 1e-6 of a turn in all directions', () => {
      const random = randomNumbers(51);
      const a = [
        ...Array.from({ length: 1000 }, () => [random() - 0.5, random() - 0.5, 0, 0]),
        [0, 1, 0, 0],
        [0, -1, 0, 0],
        [1, 0, 0, 0],
        [-1, 0, 0, 0],
        [0, 0, 0, 0],
        [3e5, -1e-3, 0, 0],
      ];
      const got = runChunk(test, {
        defines: plain.defines,
        chunks: fieldChunks([plain]),
        result: 'vec4(arcTangent(a.x, a.y))',
        a,
      });
      const worst = Math.max(...a.map(([y, x], i) => Math.abs(got[i][0] - Math.atan2(Math.fround(y), Math.fround(x)))));
      console.log(`arc tangent: worst ${worst}`);
      expect(worst).to.be.below(1e-6);
    });

    it('beams: range within a metre, angles within 1e-4 degrees, up to 460 km', () => {
      const random = randomNumbers(52);
      for (const radius of [8494667, Infinity]) {
        const a = Array.from({ length: 1000 }, () =>
          [
            ...beamToLocal({ range: 4.6e5 * random(), azimuth: 360 * random(), elevation: 60 * random() ** 2 }, radius),
            0,
          ].map(Math.fround),
        );
        const got = runChunk(test, {
          defines: plain.defines,
          chunks: fieldChunks([plain]),
          result: 'vec4(toBeam(a.xyz), 0.0)',
          a,
          uniforms: { uCurvature: 1 / radius },
        });
        a.forEach(([x, y, z], i) => {
          const beam = localToBeam([x, y, z], radius);
          expect(got[i][0]).to.be.closeTo(beam.range, 1);
          expect(got[i][1]).to.be.closeTo(beam.azimuth, 1e-4);
          expect(got[i][2]).to.be.closeTo(beam.elevation, 1e-4);
        });
      }
    });

    for (const [name, options] of Object.entries(polarScenes)) {
      it(`sampleVolume is the twin's interpolation: ${name}`, () => {
        const { worst, compared, valid, all } = compare(test, options);
        console.log(
          `WebGL ${version} ${name}: worst ${worst.toExponential(1)} of full scale; ${compared} of ${all} points compared, ${valid} of them with data`,
        );
        expect(valid).to.be.above(100);
        expect(compared).to.be.above(0.6 * all);
        // float32: a place in a box is known to 1e-7 of its edge, an angle to 1e-5 degrees.
        expect(worst).to.be.below(2e-4);
      });
    }

    it('kinds of echo are those of gates at every place, and nothing between them', () => {
      const volume = radarVolume(polarScenes['kinds of echo']);
      const got = sample(test, volume, pointsOf(volume)).filter((value) => !Number.isNaN(value));
      const kinds = new Set(volume.samples);
      expect(got.length).to.be.above(400);
      // Texels have 8 bits: a kind is a share of 255 in float32.
      const off = got.filter((value) => !kinds.has(Math.round(value)) || Math.abs(value - Math.round(value)) > 3e-5);
      expect(off).to.deep.equal([]);
      expect(new Set(got.map(Math.round)).size).to.be.above(6);
    });

    it('puts more rays in a row where there are more than the device has rows', () => {
      const options = {
        sweeps: [1, 2, 4].map((elevation, i) => ({ elevation, azimuths: evenAzimuths(360), gates: 9 + i })),
      };
      const { worst, valid } = compare(test, options, 1024);
      expect(valid).to.be.above(100);
      expect(worst).to.be.below(2e-4);
      expect(() => compare(test, { sweeps: [{ elevation: 1, gates: 2000 }] }, 1024))
        .to.throw(VolumeViewError, '24 radials of up to 2000 gates')
        .with.property('code', 'format/too-large');
    });
  });
}
