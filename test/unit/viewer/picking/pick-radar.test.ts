// Picks in a radar's volume: gate, place, height and value are Py-ART's.
import { expect } from '@esm-bundle/chai';
import { buildPolarVolume } from '../../../../src/formats/radar/build-polar-volume.ts';
import { readManifest } from '../../../../src/formats/manifest/manifest.ts';
import { readPng } from '../../../../src/formats/images/png.ts';
import { readPolarMosaic } from '../../../../src/formats/radar/polar-mosaic.ts';
import { openRadar } from '../../../../src/formats/radar/read-radar.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { pickRay } from '../../../../src/optics/pick-ray.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import { placeOnEarth } from '../../../../src/radar/place-on-earth.ts';
import { polarField } from '../../../../src/radar/polar-field.ts';
import { stretchOf } from '../../../../src/radar/polar-geometry.ts';
import { sliceInterval, sliceMeeter } from '../../../../src/radar/slices.ts';
import { describeRadar } from '../../../../src/viewer/picking/pick-radar.ts';
import { projectPlace } from '../../../../src/viewer/camera/project-place.ts';
import { longestDiagonal } from '../../../../src/volume/grid.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Sweep } from '../../../../src/volume/polar-grid.ts';
import type { PolarVolume } from '../../../../src/volume/volume.ts';
import { fetchFile, fetchFixture } from '../../../helpers/decode.ts';
import { fetchSharedData } from '../../../helpers/shared-data.ts';
import { finishPolar, radarVolume } from '../../../helpers/synthetic-radar.ts';

/** By Py-ART, see test/fixtures/make-radar-picks.py. */
interface ExpectedGate {
  readonly range: number;
  readonly azimuth: number;
  readonly elevation: number;
  readonly value: number;
  readonly local: Vector3;
  readonly latitude?: number;
  readonly longitude?: number;
  readonly altitude?: number;
}

interface ExpectedFile {
  readonly path: string;
  readonly field: string;
  readonly gates: readonly ExpectedGate[];
}

const { files } = JSON.parse(new TextDecoder().decode(await fetchFixture('radar-picks.json'))) as {
  files: ExpectedFile[];
};

async function loadVolume(context: Mocha.Context, { path, field }: ExpectedFile): Promise<PolarVolume> {
  if (path.startsWith('shared-data/'))
    return finishPolar(
      buildPolarVolume(await openRadar('hdf5', new Uint8Array(await fetchSharedData(context, path.slice(12)))), {}),
    );
  if (path.endsWith('.nc'))
    return finishPolar(buildPolarVolume(await openRadar('netcdf3', await fetchFile(`/${path}`)), { moment: field }));
  const manifest = readManifest(await fetchFile(`/${path}`));
  const { slope = 1, intercept = 0, unit = '', elevations = [] } = manifest;
  const image = await readPng(await fetchFile(`/demos/data/${manifest.image}`));
  return finishPolar(
    buildPolarVolume(readPolarMosaic(image, 'PNG', { ...manifest, elevations, slope, intercept, unit }), {}),
  );
}

/** Hardly anything shows but slices. */
const faint = (range: readonly [number, number]) => [
  { value: range[0] - 1, color: [1, 1, 1] as const, opacity: 2e-5 },
  { value: range[1] + 1, color: [1, 0, 0] as const, opacity: 2e-5 },
];

/** What is picked where a place of the world is seen from straight above, on the cone of a sweep. */
function pickAbove(volume: PolarVolume, sweep: number, [x, y, z]: Vector3) {
  const { grid } = volume;
  const size = { width: 1000, height: 800 };
  const world: Vector3 = [x, y, z * stretchOf(grid)];
  const camera = orbitCamera({ theta: 0.3, phi: 0, radius: 2 * longestDiagonal(grid) }, [x + 3000, y - 2000, 0], 0.5);
  const rays = setUpRays(grid, viewMatrix(camera), projectionMatrix(0.5, size.width / size.height, 1, 1e7))!;
  const at = projectPlace(camera, world, size)!;
  const appearance = { transferFunction: faint(volume.range), projection: null };
  const optics = { ...appearance, lightFactor: 1, opacityFactor: 1, referenceLength: 1e6 };
  const scene = {
    ...volume,
    ...optics,
    stepLength: longestDiagonal(grid) / 100,
    field: polarField(volume),
    ends: [sliceInterval(sliceMeeter(volume, [{ kind: 'cone', sweep }], optics))],
  };
  const found = pickRay(
    stagesOf(scene, rays),
    rayThrough(rays, (2 * at[0]) / size.width - 1, 1 - (2 * at[1]) / size.height),
    { at: 'jump', look: appearance },
  );
  return found && describeRadar(volume, found.place);
}

describe("a pick in a radar's volume", () => {
  for (const file of files) {
    it(`is Py-ART's gate, place and value: ${file.path}`, async function () {
      this.timeout(120_000);
      const volume = await loadVolume(this, file);
      const { sweeps } = volume.grid;
      let [count, off] = [0, 0];
      for (const gate of file.gates) {
        const radialIn = ({ azimuths }: Sweep): number =>
          azimuths.findIndex((azimuth) => Math.abs(azimuth - gate.azimuth) < 1e-4);
        const sweep = sweeps.findIndex(
          (one) =>
            Math.abs((one.elevations?.[radialIn(one)] ?? one.elevation) - gate.elevation) < 0.01 && radialIn(one) >= 0,
        );
        if (sweep < 0) continue; // Of sweeps at one elevation the volume holds one.
        const radial = radialIn(sweeps[sweep]);
        const number = (gate.range - sweeps[sweep].firstGate) / sweeps[sweep].gateLength;
        const picked = pickAbove(volume, sweep, gate.local);
        const where = `${gate.range} m, ${gate.azimuth}, ${gate.elevation} degrees`;
        expect(picked, where).to.not.equal(null);
        const { value, place } = picked!;
        expect([place.gate.sweep, place.gate.radial, place.gate.gate], where).to.deep.equal([
          sweep,
          radial,
          Math.round(number),
        ]);
        expect(value, where).to.be.closeTo(gate.value, 1e-4);
        // Py-ART's places are rounded to a centimetre; its Earth is ours.
        expect(place.range, where).to.be.closeTo(gate.range, 1);
        expect(place.azimuth, where).to.be.closeTo(gate.azimuth, 1e-3);
        expect(place.elevation, where).to.be.closeTo(gate.elevation, 1e-3);
        expect(place.heightAboveAntenna, where).to.be.closeTo(gate.local[2], 1);
        expect([place.gate.range, place.gate.azimuth], where).to.deep.equal([
          sweeps[sweep].firstGate + Math.round(number) * sweeps[sweep].gateLength,
          sweeps[sweep].azimuths[radial],
        ]);
        if (gate.altitude === undefined)
          expect([place.heightAboveSea, place.latitude, place.longitude]).to.deep.equal([null, null, null]);
        else {
          expect(place.heightAboveSea, where).to.be.closeTo(gate.altitude, 1);
          // Py-ART's Earth under the map has a radius of 6,370.997 km, ours 6,371 km.
          expect(place.latitude, where).to.be.closeTo(gate.latitude!, 1e-5);
          expect(place.longitude, where).to.be.closeTo(gate.longitude!, 2e-5);
        }
        off = Math.max(off, Math.abs(place.range - gate.range), Math.abs(place.heightAboveAntenna - gate.local[2]));
        count++;
      }
      console.log(`${file.path}: ${count} of ${file.gates.length} gates picked, at most ${off.toFixed(3)} m away`);
      expect(count).to.be.above(10);
    });
  }

  it('has the value of a gate that has data, and between gates that of the nearest', () => {
    const volume = radarVolume({
      sweeps: [1, 3, 6].map((elevation) => ({
        elevation,
        stored: (azimuth, gate) => (gate % 2 === 0 ? 0 : 1 + Math.floor(azimuth / 15) + gate),
      })),
    });
    const { low, high } = volume.grid.box;
    const placeAt = (x: number, y: number, z: number): Vector3 =>
      [x, y, z].map((at, axis) => (at - low[axis]) / (high[axis] - low[axis])) as unknown as Vector3;
    // Azimuth 7.5, the first radial: gate 3 is at 3.5 km, gate 4 without data at 4.5 km.
    const [sin, cos] = [Math.sin((7.5 * Math.PI) / 180), Math.cos((7.5 * Math.PI) / 180)];
    const found = describeRadar(volume, placeAt(3900 * sin, 3900 * cos, 70))!;
    expect([found.place.gate.sweep, found.place.gate.radial, found.place.gate.gate]).to.deep.equal([0, 0, 3]);
    expect(found.value).to.equal(0.5 * 4 - 32);
    expect(found.place.heightAboveSea).to.equal(100 + found.place.heightAboveAntenna);
    expect(describeRadar(volume, placeAt(30_000, 30_000, 70)), 'beyond the last gate').to.equal(null);
  });
});

describe('a place on the Earth', () => {
  it("is where Snyder's azimuthal equidistant projection says", () => {
    // Due east along the equator, due north, and over the date line: arcs of a great circle.
    const degree = (6_371_000 * Math.PI) / 180;
    const near = (found: { latitude: number; longitude: number }, latitude: number, longitude: number): void => {
      expect(found.latitude).to.be.closeTo(latitude, 1e-9);
      expect(found.longitude).to.be.closeTo(longitude, 1e-9);
    };
    near(placeOnEarth({ latitude: 0, longitude: 10 }, [3 * degree, 0]), 0, 13);
    near(placeOnEarth({ latitude: 50, longitude: 10 }, [0, -2 * degree]), 48, 10);
    near(placeOnEarth({ latitude: 0, longitude: 179 }, [2 * degree, 0]), 0, -179);
    near(placeOnEarth({ latitude: 45, longitude: 6 }, [0, 0]), 45, 6);
  });
});
