import { expect } from '@esm-bundle/chai';
import { polarSampler } from '../../../src/radar/interpolate-polar.ts';
import type { Ray } from '../../../src/optics/rays/rays.ts';
import { straightColor } from '../../../src/optics/attachments/plane-slices.ts';
import { sliceMeeter } from '../../../src/radar/slices.ts';
import type { Slice } from '../../../src/radar/slices.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { beamToLocal, heightOverCone, standardEarthRadius } from '../../../src/radar/polar-geometry.ts';
import type { Sweep } from '../../../src/volume/polar-grid.ts';
import type { PolarVolume } from '../../../src/volume/volume.ts';
import { evenAzimuths, polarScenes, radarVolume } from '../../helpers/synthetic-radar.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** From a ray's local points at t = 0 and 1, in metres. */
function rayFrom({ grid }: PolarVolume, from: Vector3, to: Vector3): Ray {
  const { low, high } = grid.box;
  const toUnit = (local: Vector3): Vector3 =>
    local.map((x, axis) => (x - low[axis]) / (high[axis] - low[axis])) as unknown as Vector3;
  const [point, end] = [toUnit(from), toUnit(to)];
  return { point, direction: end.map((x, axis) => x - point[axis]) as unknown as Vector3, lengthPerT: 1 };
}

/** Paints the stored value itself: red and blue are it, as a share. */
const linear = [
  { value: 0, color: [0, 0.5, 1], opacity: 1 },
  { value: 256, color: [1, 0.5, 0], opacity: 1 },
] as const;

/** Stored values as data, painted linearly. */
function meeterOf(volume: PolarVolume, slices: readonly Slice[]): ReturnType<typeof sliceMeeter> {
  return sliceMeeter({ ...volume, slope: 1, intercept: 0 }, slices, { transferFunction: linear, lightFactor: 1 });
}

const whole: [number, number] = [0, 1];
const five = radarVolume(polarScenes['five sweeps']);
const gateOf = (sweep: Sweep, ray: number, gate: number): Vector3 =>
  beamToLocal(
    { range: sweep.firstGate + gate * sweep.gateLength, azimuth: sweep.azimuths[ray], elevation: sweep.elevation },
    five.grid.earthRadius,
  );

describe('slices of a radar volume', () => {
  it('on a PPI, gates are seen with exactly their values, from above, below and aside', () => {
    for (const [number, sweep] of five.grid.sweeps.entries()) {
      const meet = meeterOf(five, [{ kind: 'cone', sweep: number }]);
      for (let i = 0; i < 60; i++) {
        const [ray, gate] = [(i * 7) % sweep.azimuths.length, (i * 5) % sweep.gates];
        const [x, y, z] = gateOf(sweep, ray, gate);
        const step: Vector3 = [
          [0, 0, 900],
          [0, 0, -900],
          [400, -300, 700],
          [-200, 90, 5],
        ][i % 4] as unknown as Vector3;
        const hit = meet(
          rayFrom(five, [x - step[0], y - step[1], z - step[2]], [x + step[0], y + step[1], z + step[2]]),
          whole,
        )!;
        expect(hit.t).to.be.closeTo(0.5, 1e-5);
        expect(hit.color[0] * 256).to.be.closeTo(five.samples[sweep.offset + ray * sweep.gates + gate], 0.01);
      }
    }
  });

  it('straight down through a gate, its value is met to the last digit', () => {
    for (const [number, sweep] of five.grid.sweeps.entries()) {
      const meet = meeterOf(five, [{ kind: 'cone', sweep: number }]);
      for (let gate = 0; gate < sweep.gates; gate++) {
        const [x, y, z] = gateOf(sweep, 3, gate);
        const hit = meet(rayFrom(five, [x, y, z + 10], [x, y, z - 10]), whole)!;
        expect(hit.color[0] * 256).to.be.closeTo(five.samples[sweep.offset + 3 * sweep.gates + gate], 1e-4);
      }
    }
  });

  it('on a PPI of radials with their own elevations, gates are visible at these elevations', () => {
    const volume = radarVolume(polarScenes['rays of their own elevations']);
    for (const [number, sweep] of volume.grid.sweeps.entries()) {
      const meet = meeterOf(volume, [{ kind: 'cone', sweep: number }]);
      for (let i = 0; i < 60; i++) {
        const [ray, gate] = [(i * 7) % sweep.azimuths.length, (i * 5) % sweep.gates];
        const range = sweep.firstGate + gate * sweep.gateLength;
        const [x, y, z] = beamToLocal(
          { range, azimuth: sweep.azimuths[ray], elevation: sweep.elevations![ray] },
          volume.grid.earthRadius,
        );
        const hit = meet(rayFrom(volume, [x, y, z + 400], [x, y, z - 400]), whole)!;
        expect(hit.t).to.be.closeTo(0.5, 1e-5);
        expect(hit.color[0] * 256).to.be.closeTo(volume.samples[sweep.offset + ray * sweep.gates + gate], 0.01);
      }
    }
  });

  it('a cone is where the beam is: height over ground by the law of the 4/3 Earth', () => {
    for (const elevation of [-0.5, 0, 0.5, 4, 30]) {
      for (const arc of [0, 1e3, 6e4, 4.6e5]) {
        const turned = (elevation * Math.PI) / 180 + arc / standardEarthRadius;
        const height = standardEarthRadius * (Math.cos((elevation * Math.PI) / 180) / Math.cos(turned) - 1);
        expect(heightOverCone([0.6 * arc, 0.8 * arc, height], elevation, standardEarthRadius)).to.be.closeTo(0, 1e-5);
      }
    }
  });

  it('a line that goes through a cone twice sees the far side where the near one is empty', () => {
    const half = (azimuth: number): number => (azimuth < 180 ? 100 : 0);
    const volume = radarVolume({
      sweeps: [1, 10].map((elevation) => ({ elevation, gates: 40, azimuths: evenAzimuths(36), stored: half })),
    });
    const meet = meeterOf(volume, [{ kind: 'cone', sweep: 1 }]);
    const [x, , z] = beamToLocal({ range: 20_000, azimuth: 90, elevation: 10 }, standardEarthRadius);
    const eastward = meet(rayFrom(volume, [-30_000, 100, z], [30_000, 100, z]), whole)!;
    expect(eastward.t).to.be.closeTo(0.5 + x / 60_000, 1e-4);
    expect(meet(rayFrom(volume, [-30_000, 100, z], [0, 100, z]), whole)).to.equal(null);
    const westward = meet(rayFrom(volume, [30_000, 100, z], [-30_000, 100, z]), whole)!;
    expect(westward.t).to.be.closeTo(0.5 - x / 60_000, 1e-4);
  });

  it("a level and an upright slice are met where planes are, with the volume's own values", () => {
    const random = randomNumbers(7);
    const valueAt = polarSampler(five);
    const [east, toward] = [
      [0.6, 0.8],
      [1000, -2000],
    ] as const;
    const level = meeterOf(five, [{ kind: 'level', height: 700 }]);
    const upright = meeterOf(five, [{ kind: 'upright', from: toward, direction: east, length: 9000 }]);
    let [levels, uprights] = [0, 0];
    for (let i = 0; i < 300; i++) {
      const place = (z: number): Vector3 => [(random() - 0.5) * 2e4, (random() - 0.5) * 2e4, z];
      const [from, to] = [place(1500), place(100)];
      const t = 800 / 1400;
      const hit = level(rayFrom(five, from, to), whole);
      if (hit) {
        levels++;
        expect(hit.t).to.be.closeTo(t, 1e-9);
      }
      const across = ([x, y]: Vector3): number => (x - toward[0]) * east[1] - (y - toward[1]) * east[0];
      const s = across(from) / (across(from) - across(to));
      const met = upright(rayFrom(five, from, to), whole);
      const along = [0, 1].reduce((sum, c) => sum + (from[c] + s * (to[c] - from[c]) - toward[c]) * east[c], 0);
      if (met) {
        uprights++;
        expect(met.t).to.be.closeTo(s, 1e-9);
        expect(along).to.be.within(0, 9000);
      } else if (s > 0 && s < 1 && along > 0 && along < 9000) {
        const { point, direction } = rayFrom(five, from, to);
        const value = valueAt(point.map((x, axis) => x + s * direction[axis]) as unknown as Vector3);
        expect(Number.isNaN(value), 'no data where no slice is').to.equal(true);
      }
    }
    expect(levels).to.be.above(50);
    expect(uprights).to.be.above(20);
  });

  it('of an azimuth begins at the radar', () => {
    const rhi = meeterOf(five, [{ kind: 'upright', from: [0, 0], direction: [0, 1], length: Infinity }]);
    expect(rhi(rayFrom(five, [-50, 8000, 300], [50, 8000, 300]), whole)!.t).to.be.closeTo(0.5, 1e-9);
    expect(rhi(rayFrom(five, [-50, -8000, 300], [50, -8000, 300]), whole)).to.equal(null);
  });

  it('of several the nearest is seen; outside of the span none is', () => {
    const slices: Slice[] = [
      { kind: 'level', height: 300 },
      { kind: 'level', height: 500 },
      { kind: 'cone', sweep: 2 },
    ];
    const meet = meeterOf(five, slices);
    const down = rayFrom(five, [3000, 8000, 1000], [3000, 8000, 0]);
    expect(meet(down, whole)!.t).to.be.closeTo(0.5, 1e-9);
    expect(meet(down, [0.51, 1])!.t).to.be.within(0.54, 0.56);
    expect(meet(down, [0.56, 1])!.t).to.be.closeTo(0.7, 1e-9);
    expect(meet(down, [0.71, 1])).to.equal(null);
    expect(meet(down, [1, 0])).to.equal(null);
  });
});

describe('the colour of a slice', () => {
  const rain = [
    { value: 0, color: [0, 0, 0], opacity: 0 },
    { value: 20, color: [1, 0.5, 0], opacity: 0.1 },
    { value: 20, color: [0, 1, 0], opacity: 0.2 },
    { value: 40, color: [0, 0, 1], opacity: 0.6 },
    { value: 40, color: [1, 1, 1], opacity: 0 },
  ] as const;

  it('is straight, whatever the opacity: what is transparent lends it nothing', () => {
    expect(straightColor(rain, 10)).to.deep.equal([1, 0.5, 0]);
    expect(straightColor(rain, 20)).to.deep.equal([0, 1, 0]);
    const [red, green, blue] = straightColor(rain, 30)!;
    expect(red).to.equal(0);
    expect(green).to.be.closeTo(0.25, 1e-12);
    expect(blue).to.be.closeTo(0.75, 1e-12);
  });

  it('is none where there are no data, and where nothing is to be seen of them', () => {
    for (const value of [NaN, -5, 0, 40, 99]) expect(straightColor(rain, value), `${value}`).to.equal(null);
  });
});
