import { expect } from '@esm-bundle/chai';
import { buildPolarVolume } from '../../../src/formats/radar/build-polar-volume.ts';
import { openRadar } from '../../../src/formats/radar/read-radar.ts';
import { cartesianGrid, unitToWorld } from '../../../src/volume/grid.ts';
import { transformPoint } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import {
  beamToLocal,
  boxIndexToWorld,
  localToBeam,
  spansOfRings,
  standardEarthRadius,
  unitToLocal,
} from '../../../src/radar/polar-geometry.ts';
import type { BeamPoint } from '../../../src/radar/polar-geometry.ts';
import { fetchFixture } from '../../helpers/decode.ts';
import { fetchSharedData } from '../../helpers/shared-data.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

interface Positions {
  readonly gates: readonly (readonly number[])[];
}

interface SharedPositions {
  readonly files: readonly {
    readonly path: string;
    readonly positions: readonly Record<'range' | 'azimuth' | 'elevation' | 'x' | 'y' | 'z', number>[];
  }[];
}

/** Where Py-ART puts gates of a shared file: sweep and radial in its order, range, metres east, north and up of the antenna. */
interface PlacedGates {
  readonly path: string;
  readonly gates: readonly (readonly [sweep: number, ray: number, range: number, x: number, y: number, z: number])[];
}

describe('polar geometry', () => {
  it('puts gates where Py-ART and wradlib put them, within a metre', async () => {
    const { gates } = JSON.parse(new TextDecoder().decode(await fetchFixture('polar-positions.json'))) as Positions;
    let worst = 0;
    for (const [range, azimuth, elevation, x, y, z, distance, height] of gates) {
      const local = beamToLocal({ range, azimuth, elevation }, standardEarthRadius);
      const differences = [
        Math.hypot(local[0] - x, local[1] - y),
        local[2] - z,
        Math.hypot(local[0], local[1]) - distance,
        local[2] - height,
      ].map(Math.abs);
      worst = Math.max(worst, ...differences);
    }
    expect(gates.length).to.equal(315);
    console.log(`gates to 460 km and 90 degrees: at most ${worst.toFixed(3)} m from Py-ART and wradlib`);
    // The issue asks for 10 m; the fixture is rounded to a centimetre.
    expect(worst).to.be.below(1);
  });

  it('puts the gates of the shared files where their programs put them, within 10 m', async () => {
    const { files } = JSON.parse(new TextDecoder().decode(await fetchFixture('radar-shared.json'))) as SharedPositions;
    let [worst, count] = [0, 0];
    for (const { path, positions } of files) {
      for (const { range, azimuth, elevation, x, y, z } of positions) {
        const local = beamToLocal({ range, azimuth, elevation }, standardEarthRadius);
        const [across, up] = [Math.hypot(local[0] - x, local[1] - y), Math.abs(local[2] - z)];
        // The issue's own bounds.
        expect(across, path).to.be.below(10);
        expect(up, path).to.be.below(10);
        worst = Math.max(worst, across, up);
        count++;
      }
    }
    expect(count).to.be.above(1000);
    console.log(`${count} gates of the shared files: at most ${worst.toFixed(2)} m away`);
  });

  it('of volumes of the shared files puts gates where Py-ART does, within 10 m', async function () {
    this.timeout(120_000);
    const { files } = JSON.parse(new TextDecoder().decode(await fetchFixture('polar-positions-shared.json'))) as {
      files: PlacedGates[];
    };
    expect(files.length).to.equal(24);
    let [all, inVolumes, worst, plain] = [0, 0, 0, 0];
    for (const { path, gates } of files) {
      const file = await openRadar(
        path.includes('nexrad') ? 'nexrad' : path.includes('cr_raster') ? 'netcdf3' : 'hdf5',
        new Uint8Array(await fetchSharedData(this, path)),
      );
      const { sweeps } = buildPolarVolume(file, {}).grid;
      for (const [number, ray, range, x, y, z] of gates) {
        const { azimuths, elevation, elevations } = file.sweeps[number];
        const offBy = (at: BeamPoint): number => {
          const local = beamToLocal(at, standardEarthRadius);
          return Math.max(Math.hypot(local[0] - x, local[1] - y), Math.abs(local[2] - z));
        };
        const azimuth = azimuths[ray];
        const own = offBy({ range, azimuth, elevation: elevations?.[ray] ?? elevation });
        expect(own, `${path}, sweep ${number}, ray ${ray}`).to.be.below(1);
        all++;
        plain = Math.max(plain, offBy({ range, azimuth, elevation }));
        // Of sweeps at one elevation the volume holds one.
        const shown = sweeps.find((sweep) => sweep.elevation === elevation && sweep.azimuths.includes(azimuth));
        if (!shown) continue;
        const off = offBy({
          range,
          azimuth,
          elevation: shown.elevations?.[shown.azimuths.indexOf(azimuth)] ?? elevation,
        });
        // The issue's own bounds.
        expect(off, `${path}, sweep ${number}, ray ${ray}`).to.be.below(10);
        worst = Math.max(worst, off);
        inVolumes++;
      }
    }
    expect(all).to.equal(2400);
    expect(inVolumes).to.be.above(2000);
    expect(plain, 'by the elevations of sweeps').to.be.above(100);
    console.log(
      `${inVolumes} of ${all} gates of ${files.length} shared files in their volumes: at most ${worst.toFixed(2)} m from Py-ART's places; ${plain.toFixed(0)} m by the sweeps' elevations`,
    );
  });

  it('agrees with the formula as printed, where that keeps its digits', () => {
    // Doviak and Zrnic 1993, eq. 2.28 b and c.
    const a = standardEarthRadius;
    for (const [range, elevation] of [
      [1e5, 0.5],
      [4.6e5, 19.5],
      [2e5, 60],
      [3e5, -0.5],
    ]) {
      const e = (elevation * Math.PI) / 180;
      const h = Math.sqrt(range ** 2 + a ** 2 + 2 * range * a * Math.sin(e)) - a;
      const s = a * Math.asin((range * Math.cos(e)) / (a + h));
      const local = beamToLocal({ range, azimuth: 90, elevation }, a);
      expect(local[0]).to.be.closeTo(s, 1e-6);
      expect(local[2]).to.be.closeTo(h, 1e-6);
    }
  });

  for (const [name, radius] of [
    ['a round Earth', standardEarthRadius],
    ['a flat ground', Infinity],
  ] as const) {
    it(`comes back to range, azimuth and elevation over ${name}`, () => {
      const random = randomNumbers(60);
      for (let i = 0; i < 2000; i++) {
        const beam = { range: 10 ** (1 + 4.7 * random()), azimuth: 360 * random(), elevation: 90 * random() - 5 };
        const back = localToBeam(beamToLocal(beam, radius), radius);
        // Heights of a far low beam are the rest of numbers a thousand times as large.
        expect(back.range / beam.range).to.be.closeTo(1, 1e-12);
        expect(back.elevation).to.be.closeTo(beam.elevation, 1e-10);
        if (beam.elevation < 89.9) expect(back.azimuth).to.be.closeTo(beam.azimuth, 1e-9);
      }
    });
  }

  it('is straight over a flat ground', () => {
    const [x, y, z] = beamToLocal({ range: 2e5, azimuth: 30, elevation: 30 }, Infinity);
    expect(z).to.be.closeTo(1e5, 1e-9);
    expect(x).to.be.closeTo(1e5 * Math.sqrt(3) * 0.5, 1e-9);
    expect(y).to.be.closeTo(1e5 * 1.5, 1e-9);
  });

  it('knows the antenna, the zenith and the nadir', () => {
    expect(localToBeam([0, 0, 0], standardEarthRadius)).to.deep.equal({ range: 0, azimuth: 0, elevation: 0 });
    expect(localToBeam([0, 0, 5000], standardEarthRadius)).to.deep.equal({ range: 5000, azimuth: 0, elevation: 90 });
    expect(localToBeam([0, 0, -20], Infinity)).to.deep.equal({ range: 20, azimuth: 0, elevation: -90 });
    expect(localToBeam([-1e-20, 1, 0], Infinity).azimuth).to.equal(0);
    expect(localToBeam([-1, 0, 0], Infinity).azimuth).to.equal(270);
  });

  it('survives float32: what a shader computes with the same formulas is right to a hundredth of a gate', () => {
    const f = Math.fround;
    const k = f(1 / standardEarthRadius);
    const random = randomNumbers(61);
    for (let i = 0; i < 2000; i++) {
      const beam = { range: 4.6e5 * random(), azimuth: 0, elevation: 30 * random() ** 3 };
      const [, y, z] = beamToLocal(beam, standardEarthRadius).map(f) as unknown as Vector3;
      const g2 = f(f(y * k) ** 2);
      const chord = f(y * f(1 - f(g2 * f(1 / 24 - f(g2 / 1920)))));
      const stretch = f(1 + f(z * k));
      const up = f(z - f(f(f(f(0.5 * stretch) * chord) * chord) * k));
      const along = f(f(stretch * chord) * f(1 - f(g2 * f(0.125 - f(g2 / 384)))));
      expect(Math.hypot(up, along)).to.be.closeTo(beam.range, 0.25);
      expect((Math.atan2(up, along) * 180) / Math.PI).to.be.closeTo(beam.elevation, 1e-5);
    }
  });

  it('spans of range rings hold all of their points, and no more than necessary', () => {
    const random = randomNumbers(62);
    for (const radius of [standardEarthRadius, Infinity]) {
      for (let i = 0; i < 400; i++) {
        const near = random() < 0.2 ? 0 : 3e5 * random();
        const arcs = [near, near + 10 ** (2 + 3 * random())] as const;
        const bottom = random() < 0.2 ? -500 : 2e4 * random() - 300;
        const heights = [bottom, bottom + 10 ** (1 + 3 * random())] as const;
        const span = spansOfRings(arcs, radius)(heights);
        const found = { range: [Infinity, -Infinity], elevation: [Infinity, -Infinity] };
        for (let a = 0; a <= 32; a++) {
          for (let h = 0; h <= 32; h++) {
            const place: Vector3 = [
              arcs[0] + ((arcs[1] - arcs[0]) * a) / 32,
              0,
              heights[0] + ((heights[1] - heights[0]) * h) / 32,
            ];
            const beam = localToBeam(place, radius);
            for (const key of ['range', 'elevation'] as const) {
              found[key] = [Math.min(found[key][0], beam[key]), Math.max(found[key][1], beam[key])];
            }
          }
        }
        for (const key of ['range', 'elevation'] as const) {
          const wide = span[key][1] - span[key][0];
          expect(span[key][0], key).to.be.at.most(found[key][0] + 1e-9);
          expect(span[key][1], key).to.be.at.least(found[key][1] - 1e-9);
          // Points of the lattice come within a thirtieth; next to the antenna all elevations crowd.
          if (near > 1e4) expect(found[key][1] - found[key][0], key).to.be.at.least(0.9 * wide - 1e-9);
        }
      }
    }
  });

  it('maps the unit cube to the box, and to the world with heights stretched', () => {
    const box = { low: [-3e5, -2e5, -100] as const, high: [3e5, 2e5, 15000] as const };
    const dimensions: Vector3 = [7, 5, 3];
    const grid = cartesianGrid(dimensions, boxIndexToWorld(box, dimensions, 5));
    for (const p of [
      [0, 0, 0],
      [1, 1, 1],
      [0.25, 0.5, 0.75],
    ] as Vector3[]) {
      const [x, y, z] = unitToLocal(box, p);
      const world = transformPoint(unitToWorld(grid), p);
      [x, y, 5 * z].forEach((value, axis) => expect(world[axis]).to.be.closeTo(value, 1e-6));
    }
    expect(unitToLocal(box, [0, 0, 0])).to.deep.equal(box.low);
  });
});
