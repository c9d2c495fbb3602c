// Where the pin of a note stands, against the rays of the picture: the ray of this pixel meets the place.
import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import { rayToPlace } from '../../../../src/optics/transmittance.ts';
import { beamToLocal, unitToLocal } from '../../../../src/radar/polar-geometry.ts';
import { projectInView } from '../../../../src/viewer/camera/project-place.ts';
import { locateNote } from '../../../../src/viewer/notes/note-place.ts';
import { describePlace } from '../../../../src/viewer/picking/pick-radar.ts';
import { boundingSphere, cartesianGrid, unitToWorld } from '../../../../src/volume/grid.ts';
import type { Grid } from '../../../../src/volume/volume.ts';
import { add, invertAffine, length, scale, subtract, transformPoint } from '../../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../../src/volume/matrix.ts';
import type { PolarVolume } from '../../../../src/volume/volume.ts';
import { obliqueAffine, randomNumbers } from '../../../helpers/synthetic.ts';
import { radarVolume, unequalSweeps } from '../../../helpers/synthetic-radar.ts';

const [width, height] = [640, 480];

/** Cameras around a grid: 20 in perspective, 20 in parallel. */
function* cameras(grid: Grid): Generator<{ view: Matrix4; projection: Matrix4 }> {
  const random = randomNumbers(21);
  const { center, radius } = boundingSphere(grid);
  for (let n = 0; n < 20; n++) {
    const orbit = { theta: 6.28 * random(), phi: 0.1 + 2.9 * random(), radius: (1.2 + 3 * random()) * radius };
    const view = viewMatrix(orbitCamera(orbit, center, 0.6));
    yield { view, projection: projectionMatrix(0.3 + random(), width / height, radius / 100, radius * 10) };
    const reach = 1 / (radius * (0.5 + random()));
    yield {
      view,
      projection: [(reach * height) / width, 0, 0, 0.1, 0, reach, 0, -0.2, 0, 0, -1e-4, 0, 0, 0, 0, 1],
    };
  }
}

/** The farthest that the ray of a pin's pixel is from the place of the note, in pixels, over all cameras. */
function findWorst(grid: Grid, at: Vector3, region: Grid | null): { worst: number; cameras: number } {
  const toUnit = invertAffine(unitToWorld(grid))!;
  const unit = transformPoint(toUnit, at);
  let [worst, count] = [0, 0];
  for (const view of cameras(grid)) {
    const { x, y, depth } = projectInView(view, at);
    if (depth <= 0) continue;
    count++;
    const setup = setUpRays(grid, view.view, view.projection, region)!;
    // The ray of the pixel, where it is nearest to the place, in pixels from it.
    const ray = rayThrough(setup, x, y);
    const to = rayToPlace(setup, unit)!;
    const miss = length(subtract(add(ray.point, scale(ray.direction, to.t)), unit));
    expect(miss).to.be.below(1e-6);
    worst = Math.max(worst, (Math.abs(to.x - x) * width) / 2, (Math.abs(to.y - y) * height) / 2);
  }
  return { worst, cameras: count };
}

describe('the pin of a note is at its voxel, within a pixel', () => {
  const grid = cartesianGrid([40, 30, 20], obliqueAffine(randomNumbers(5), [2, 3, 4], [-30, 12, 5]));
  const region = cartesianGrid([1, 1, 1], [40, 0, 0, -20, 0, 50, 0, 10, 0, 0, 60, 8, 0, 0, 0, 1]);
  for (const [name, shown] of [
    ['all of a volume', null],
    ['a region of it', region],
  ] as const)
    it(`from 20 cameras in perspective and 20 in parallel, in ${name}`, () => {
      for (const voxel of [
        [3, 4, 5],
        [39, 0, 19],
        [20, 15, 10],
      ] as const) {
        const at = transformPoint(grid.indexToWorld, voxel);
        const { worst, cameras: seen } = findWorst(grid, at, shown);
        expect(seen).to.be.at.least(30);
        expect(worst).to.be.below(1e-6);
      }
    });

  it('in a radar with exaggerated heights', () => {
    const plain = radarVolume(unequalSweeps);
    const volume = radarVolume(unequalSweeps, { verticalExaggeration: 3 });
    const local: Vector3 = [4000, -2500, 900];
    const at = locateNote({ kind: 'world', at: local }, { volume, labels: null, labelsMayCome: false })!;
    expect(Math.max(...subtract(at, [4000, -2500, 2700]).map(Math.abs))).to.be.below(1e-9);
    const toUnit = invertAffine(unitToWorld(volume.grid))!;
    const unit = transformPoint(toUnit, at);
    expect(Math.max(...subtract(unitToLocal(volume.grid.box, unit), local).map(Math.abs))).to.be.below(1e-6);
    expect(plain.grid.box).to.deep.equal(volume.grid.box);
    expect(findWorst(volume.grid, at, null).worst).to.be.below(1e-6);
  });

  it('of a latitude, a longitude and a height is where a pick finds these', () => {
    const radar = radarVolume(unequalSweeps, { verticalExaggeration: 3 });
    const site = { latitude: 48.2, longitude: 11.6, height: 520 };
    const volume = { ...radar, radar: { ...radar.radar, site } } as PolarVolume;
    const wanted = { latitude: 48.31, longitude: 11.42, height: 2100 };
    const at = locateNote({ kind: 'earth', ...wanted }, { volume, labels: null, labelsMayCome: false })!;
    const unit = transformPoint(invertAffine(unitToWorld(volume.grid))!, at);
    const found = describePlace(volume, unit);
    expect(found.latitude).to.be.closeTo(wanted.latitude, 1e-9);
    expect(found.longitude).to.be.closeTo(wanted.longitude, 1e-9);
    expect(found.heightAboveSea).to.be.closeTo(wanted.height, 1e-6);
  });

  it('of latitude, longitude and height is in the gate that sees this place over an Earth of 4/3 radius', () => {
    const radar = radarVolume(unequalSweeps, { verticalExaggeration: 2 });
    const site = { latitude: 48.2, longitude: 11.6, height: 520 };
    const volume = { ...radar, radar: { ...radar.radar, site } } as PolarVolume;
    // Range, elevation, azimuth; the place by pyproj 3.7.2, Geod(a=6371000, b=6371000).fwd along the arc s of Doviak & Zrnić 1993, eq. 2.28b
    // and c: h = sqrt(r^2 + (4/3 a)^2 + 2 r (4/3 a) sin e) - 4/3 a above the antenna, s = 4/3 a asin(r cos e / (4/3 a + h)).
    const beams = [
      [20_000, 0.5, 30, 48.35567842, 11.7353289, 718.073],
      [100_000, 1.5, 135, 47.56064641, 12.54171163, 3725.695],
      [180_000, 0.5, 222.5, 46.99562691, 9.99716388, 3997.144],
      [230_000, 4.5, 301, 49.22838171, 8.89937031, 21653.023],
      [60_000, 19.5, 359, 48.70736075, 11.58658002, 20736.253],
    ];
    let worst = 0;
    for (const [range, elevation, azimuth, latitude, longitude, height] of beams) {
      const place = { kind: 'earth', latitude, longitude, height } as const;
      const at = locateNote(place, { volume, labels: null, labelsMayCome: false })!;
      const local = unitToLocal(volume.grid.box, transformPoint(invertAffine(unitToWorld(volume.grid))!, at));
      const expected = beamToLocal({ range, elevation, azimuth }, volume.grid.earthRadius);
      worst = Math.max(worst, length(subtract(local, expected)));
    }
    // A gate is 250 m long.
    console.log(`notes of latitude and longitude: at most ${worst.toFixed(3)} m from pyproj's place of the gate`);
    expect(worst).to.be.below(250);
    expect(worst).to.be.below(1);
  });

  it('stays in every scan of a series, whatever the range of the scan', () => {
    const at = locateNote(
      { kind: 'world', at: [4000, -2500, 900] },
      { volume: radarVolume(unequalSweeps), labels: null, labelsMayCome: false },
    )!;
    const shorter = unequalSweeps.sweeps.map((sweep) => ({ ...sweep, gates: Math.ceil(sweep.gates! / 3) }));
    for (const sweeps of [unequalSweeps.sweeps, shorter, shorter.slice(0, 4)]) {
      const volume = radarVolume({ ...unequalSweeps, sweeps });
      const now = locateNote(
        { kind: 'world', at: [4000, -2500, 900] },
        { volume, labels: null, labelsMayCome: false },
      )!;
      expect(now).to.deep.equal(at);
      const { worst, cameras: seen } = findWorst(volume.grid, now, null);
      expect(seen).to.be.at.least(30);
      expect(worst).to.be.below(1e-6);
    }
  });
});
