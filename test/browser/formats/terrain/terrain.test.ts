// The ground under a radar: tiles of heights, where they lie, and how they are thinned.
import { expect } from '@esm-bundle/chai';
import { readSurface, readTerrain } from '../../../../src/viewer/attachments/surface-attributes.ts';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { cornerOf, readHgt } from '../../../../src/formats/terrain/hgt.ts';
import type { HgtTile } from '../../../../src/formats/terrain/hgt.ts';
import { makeTerrain } from '../../../../src/formats/terrain/make-terrain.ts';
import type { TerrainRadar } from '../../../../src/formats/terrain/make-terrain.ts';
import { joinTiles } from '../../../../src/formats/terrain/terrain-raster.ts';
import { placeFromEarth } from '../../../../src/radar/place-from-earth.ts';
import { placeOnEarth } from '../../../../src/radar/place-on-earth.ts';
import type { EarthPoint } from '../../../../src/radar/place-on-earth.ts';
import type { Surface } from '../../../../src/volume/surface.ts';
import { fetchFixture } from '../../../helpers/decode.ts';
import { trianglesOf } from '../../../helpers/meshes.ts';
import { hgtBytes } from '../../../helpers/terrain.ts';

const radar: TerrainRadar = { site: { latitude: 46.4, longitude: 7.5 }, height: 800, reach: 25_000, exaggeration: 2 };
const tile = (height: Parameters<typeof hgtBytes>[0], name = 'N46E007.hgt'): Promise<HgtTile> =>
  readHgt(hgtBytes(height), name, null);
const terrainOf = async (height: Parameters<typeof hgtBytes>[0], from = radar, max = 200_000): Promise<Surface> =>
  makeTerrain(joinTiles([await tile(height)], from.site, from.reach), from, max);

/** Height of a surface in the world at a place, found triangle by triangle; NaN where there is none. */
function heightOf(surface: Surface, [x, y]: readonly [number, number]): number {
  for (const [a, b, c] of trianglesOf(surface)) {
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    const u = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;
    const v = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
    if (u >= -1e-6 && v >= -1e-6 && u + v <= 1 + 1e-6) return a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]);
  }
  return Number.NaN;
}

const hills = (north: number, east: number): number =>
  900 + 600 * Math.sin(9 * north) * Math.cos(7 * east) + 80 * Math.sin(60 * (north + 0.3 * east));

describe('terrain', () => {
  it('lies where pyproj has it on the sphere, and WGS 84 is 0.3 % farther at most', async () => {
    const { radar: site, places } = JSON.parse(new TextDecoder().decode(await fetchFixture('mesh-fixtures.json'))) as {
      radar: EarthPoint;
      places: Record<string, EarthPoint & Record<'sphere' | 'ellipsoid', [number, number]>>;
    };
    for (const { sphere, ellipsoid, ...point } of Object.values(places)) {
      const [east, north] = placeFromEarth(site, point);
      expect(Math.hypot(east - sphere[0], north - sphere[1])).to.be.below(1e-4);
      expect(Math.hypot(east - ellipsoid[0], north - ellipsoid[1])).to.be.at.most(0.003 * Math.hypot(east, north));
      const back = placeOnEarth(site, [east, north]);
      expect(Math.hypot(back.latitude - point.latitude, back.longitude - point.longitude)).to.be.below(1e-10);
    }
  });

  it('of a name or an attribute has its corner there', () => {
    const names = {
      'N46E007.hgt': [46, 7],
      's01w180.HGT.gz': [-1, -180],
      'dem_N00E000.SRTMGL1.hgt': [0, 0],
      N46E007: [46, 7],
      'N46E0071.hgt': null,
      'elevation.hgt': null,
      'N95E007.hgt': null,
    };
    for (const [name, corner] of Object.entries(names)) expect(cornerOf(name), name).to.deep.equal(corner);
  });

  it('has whole degrees, and URLs may have commas', () => {
    const ask = (corner: string) => () => readTerrain((name) => ({ src: 'a,b.hgt', corner })[name] ?? null, null);
    expect(ask('46 7')().request).to.equal(null);
    expect(ask('46 7.5')).to.throw(/^corner of a volume-terrain got "46 7.5"; expected whole degrees/);
    expect(readSurface((name) => (name === 'src' ? ' /a,b.ply ' : null)).request!.url).to.match(/\/a,b\.ply$/);
  });

  it("has heights above the antenna, exaggerated as the radar's, and states its largest error", async () => {
    const surface = await terrainOf(hills, radar, 8000);
    const { error, meanError, heights, voids } = surface.terrain!;
    expect(surface.triangles).to.be.within(1500, 8000);
    expect(error).to.be.within(1, 120);
    expect(meanError).to.be.below(error / 2);
    expect(voids).to.equal(0);
    let worst = 0;
    for (let i = 0; i < 25; i++) {
      // Samples of the tile, so that what is between them is no matter.
      const [north, east] = [
        Math.round(1200 * (0.4 + 0.13 * Math.sin(3 * i))) / 1200,
        Math.round(1200 * (0.5 + 0.2 * Math.cos(2 * i))) / 1200,
      ];
      const found = heightOf(surface, placeFromEarth(radar.site, { latitude: 46 + north, longitude: 7 + east }));
      worst = Math.max(worst, Math.abs(found / 2 + 800 - Math.round(hills(north, east))));
    }
    expect(worst).to.be.at.most(error + 0.5);
    expect(worst).to.be.above(error / 30);
    expect(heights[0]).to.be.above(200);
    expect(heights[1]).to.be.below(1600);
    // Fewer triangles, a larger error.
    expect((await terrainOf(hills, radar, 1500)).terrain!.error).to.be.above(error);
  });

  it('that is flat is few triangles, as far as the radar reaches, and the sea is the sphere', async () => {
    const surface = await terrainOf(() => 0);
    expect(surface.terrain!.error).to.equal(0);
    expect(surface.triangles).to.be.below(9000); // All but the rim is a few large ones.
    expect([surface.low[2], surface.high[2]]).to.deep.equal([-1600, -1600]);
    for (const length of [-surface.low[0], surface.high[0], -surface.low[1], surface.high[1]])
      expect(length).to.be.within(24_800, 25_000);
    for (const [a, b, c] of trianglesOf(surface))
      expect((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])).to.be.above(0);
  });

  it('is left open over voids, which it says', async () => {
    const hole = (north: number, east: number): number | null =>
      Math.abs(north - 0.4) < 0.03 && Math.abs(east - 0.5) < 0.03 ? null : hills(north, east);
    const surface = await terrainOf(hole);
    expect(surface.terrain!.voids).to.be.within(0.01, 0.03);
    expect(surface.notes.join()).to.match(/^[12] % of the terrain has no heights/);
    expect(Number.isNaN(heightOf(surface, [0, 0]))).to.equal(true);
    expect(Number.isNaN(heightOf(surface, [0, 5000]))).to.equal(false);
    expect(surface.low[2]).to.be.above(-1600); // No void is a height.
    const error = await terrainOf(() => null).catch((thrown: unknown) => thrown as VolumeViewError);
    expect((error as VolumeViewError).code).to.equal('format/unsupported');
  });

  it('of several tiles is one, also over the date line', async () => {
    const heightsOf =
      (south: number, west: number) =>
      (north: number, east: number): number =>
        1000 + 300 * Math.sin(4 * (south + north)) + 200 * Math.cos(3 * (west + east));
    const from = { ...radar, site: { latitude: -16.97, longitude: 179.98 } };
    const tiles = await Promise.all(
      (
        [
          [-17, 179],
          [-17, -180],
          [-18, 179],
          [-18, -180],
        ] as const
      ).map(([south, west]) =>
        readHgt(
          hgtBytes(heightsOf(south, west < 0 ? west + 360 : west)),
          `S${-south}${west < 0 ? 'W180' : 'E179'}.hgt`,
          null,
        ),
      ),
    );
    const surface = makeTerrain(joinTiles(tiles, from.site, from.reach), from, 20_000);
    expect(surface.terrain!.voids).to.equal(0);
    for (const [x, y] of [
      [12_000, 9000],
      [-15_000, 3000],
      [8000, -14_000],
      [-9000, -9000],
    ] as const) {
      const { latitude, longitude } = placeOnEarth(from.site, [x, y]);
      const wanted = heightsOf(0, 0)(latitude, longitude < 0 ? longitude + 360 : longitude);
      expect(Math.abs(heightOf(surface, [x, y]) / 2 + 800 - wanted)).to.be.below(surface.terrain!.error + 2);
    }
  });

  it('is refused in words where it is none, or elsewhere', async () => {
    const refused = async (work: () => unknown): Promise<string> => {
      try {
        await work();
      } catch (error) {
        if (error instanceof VolumeViewError) return `${error.code}: ${error.message}`;
        throw error;
      }
      return 'no error';
    };
    expect(await refused(() => readHgt(new Uint8Array(1000), 'N46E007.hgt', null))).to.match(
      /^format\/unknown: N46E007\.hgt has 1,000 bytes; expected heights as SRTM has them/,
    );
    expect(await refused(() => readHgt(Uint8Array.of(0x50, 0x4b, 3, 4), 'N46E007.hgt.zip', null))).to.match(
      /zip archive: unpack it/,
    );
    expect(await refused(() => tile(() => 0, 'heights.hgt'))).to.match(
      /^attribute\/invalid: heights\.hgt does not say where it is.*corner="46 7"/,
    );
    const near = await tile(() => 0);
    expect(await refused(() => joinTiles([near], { latitude: -20, longitude: 7.5 }, 1e5))).to.match(
      /^attribute\/invalid: .*out of the radar's reach, 100 km/,
    );
    expect(await refused(() => joinTiles([near, { ...near, side: 3601 }], radar.site, 1e5))).to.match(
      /^attribute\/invalid: .*expected one kind/,
    );
  });
});
