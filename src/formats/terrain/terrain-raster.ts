import { VolumeViewError } from '../../core/errors.ts';
import type { EarthPoint } from '../../radar/place-on-earth.ts';
import { meanEarthRadius } from '../../radar/polar-geometry.ts';
import { noHeight } from './hgt.ts';
import type { HgtTile } from './hgt.ts';

/** Maximum number of samples within reach, of all tiles together. */
const maxSamples = 2 ** 26;

const degrees = 180 / Math.PI;

/** Heights on a lattice of latitudes and longitudes. */
export interface TerrainRaster {
  /** Degrees north of the first row, and east of the first column, which may be more than 180. */
  readonly north: number;
  readonly west: number;
  /** Degrees from one sample to the next. */
  readonly spacing: number;
  readonly rows: number;
  readonly columns: number;
  /** Metres above the sea, row by row from the north. */
  readonly heights: Int16Array;
}

/**
 * Joins the parts of tiles that lie within a radar's reach.
 * @param reach - metres along the ground
 * @throws {VolumeViewError} `attribute/invalid` if tiles are not of one kind, or none is within reach;
 * `format/too-large`
 */
export function joinTiles(tiles: readonly HgtTile[], radar: EarthPoint, reach: number): TerrainRaster {
  const [{ side }] = tiles;
  if (tiles.some((tile) => tile.side !== side))
    throw new VolumeViewError(
      'attribute/invalid',
      'src of <volume-terrain> names tiles of 1 and of 3 seconds of arc; expected one kind',
    );
  const per = side - 1;
  const north = (reach / meanEarthRadius) * degrees;
  const polar = Math.cos(Math.min(90, Math.abs(radar.latitude) + north) / degrees);
  const east = polar > 1e-3 ? Math.asin(Math.min(1, Math.sin(Math.min(90, north) / degrees) / polar)) * degrees : 180;
  // Rows and columns are counted from the equator and from the radar's own meridian, so that the date line is not a
  // border.
  const near = tiles.map((tile) => ({
    ...tile,
    west: radar.longitude + turnTo(radar.longitude, tile.west + 0.5) - 0.5,
  }));
  const low = (values: readonly number[], limit: number): number =>
    Math.max(Math.min(...values) * per, Math.floor(limit * per));
  const high = (values: readonly number[], limit: number): number =>
    Math.min(Math.max(...values) * per, Math.ceil(limit * per));
  const [souths, wests] = [near.map((tile) => tile.south), near.map((tile) => Math.round(tile.west))];
  const [bottom, top] = [
    low(souths, radar.latitude - north),
    high(
      souths.map((south) => south + 1),
      radar.latitude + north,
    ),
  ];
  const [left, right] = [
    low(wests, radar.longitude - east),
    high(
      wests.map((west) => west + 1),
      radar.longitude + east,
    ),
  ];
  const [rows, columns] = [top - bottom + 1, right - left + 1];
  if (!(rows > 1 && columns > 1))
    throw new VolumeViewError(
      'attribute/invalid',
      `the tiles of <volume-terrain> are out of the radar's reach, ${Math.round(reach / 1000)} km around ${radar.latitude.toFixed(2)} degrees north, ${radar.longitude.toFixed(2)} degrees east`,
    );
  if (rows * columns > maxSamples)
    throw new VolumeViewError(
      'format/too-large',
      `the tiles of <volume-terrain> have ${(rows * columns).toLocaleString('en')} heights within the radar's reach; expected at most ${maxSamples.toLocaleString('en')}. Use tiles of 3 seconds of arc (1201 x 1201)`,
    );
  const heights = new Int16Array(rows * columns).fill(noHeight);
  near.forEach(({ heights: own }, tile) =>
    copyTile(
      { own, side, top: (souths[tile] + 1) * per, left: wests[tile] * per },
      { heights, rows, columns, top, left },
    ),
  );
  return { north: top / per, west: left / per, spacing: 1 / per, rows, columns, heights };
}

interface Placed {
  readonly top: number;
  readonly left: number;
}

function copyTile(
  tile: Placed & { own: DataView; side: number },
  raster: Placed & { heights: Int16Array; rows: number; columns: number },
): void {
  const shift = tile.top - raster.top;
  const [firstColumn, begin] = [Math.max(0, raster.left - tile.left), Math.max(0, tile.left - raster.left)];
  for (let row = Math.max(0, -shift); row < raster.rows && row + shift < tile.side; row++) {
    let column = firstColumn;
    for (let to = begin; to < raster.columns && column < tile.side; to++, column++) {
      const height = tile.own.getInt16(2 * ((row + shift) * tile.side + column));
      if (height !== noHeight) raster.heights[row * raster.columns + to] = height;
    }
  }
}

/** Degrees from one longitude to another, -180..180. */
function turnTo(from: number, to: number): number {
  const turn = to - from;
  return turn - 360 * Math.round(turn / 360);
}
