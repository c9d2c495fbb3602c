import { placeFromEarth } from '../../radar/place-from-earth.ts';
import type { EarthPoint } from '../../radar/place-on-earth.ts';
import type { Surface, TerrainFacts } from '../../volume/surface.ts';
import { boundsOf } from '../meshes/finish-mesh.ts';
import { makeNormals } from '../meshes/make-normals.ts';
import { floatList, wholeList } from '../meshes/number-list.ts';
import { splitMesh } from '../meshes/split-mesh.ts';
import { VolumeViewError } from '../../core/errors.ts';
import { noHeight } from './hgt.ts';
import { makeLattice } from './lattice.ts';
import type { Lattice } from './lattice.ts';
import { addError } from './measure-terrain.ts';
import type { TerrainError } from './measure-terrain.ts';
import { terrainColor } from './terrain-colors.ts';
import type { TerrainRaster } from './terrain-raster.ts';
import { eachTriangle, findError, latticeErrors } from './thin-lattice.ts';

/** Maximum number of samples along a side that are examined. */
const maxSide = 2049;

/** The radar over the terrain, and how it is shown. */
export interface TerrainRadar {
  readonly site: EarthPoint;
  /** Metres of the antenna above the sea; null if unknown: then it stands on the ground. */
  readonly height: number | null;
  /** Metres along the ground. */
  readonly reach: number;
  /** World height = this times the height. */
  readonly exaggeration: number;
}

/**
 * Makes a surface of at most so many triangles in a radar's world: metres east and north along the ground's arc,
 * heights above the antenna, with the radar's exaggeration. The surface states the error of its heights.
 * @throws {VolumeViewError} `format/unsupported` if there are no heights within reach
 */
export function makeTerrain(raster: TerrainRaster, radar: TerrainRadar, maxTriangles: number): Surface {
  const { lattice, errors, error, seen } = thin(raster, radar, maxTriangles);
  const heights = floatList();
  const [places, colors, indices] = [floatList(), floatList(), wholeList()];
  const names = new Uint32Array(lattice.size ** 2);
  const antenna = radar.height ?? heightAt(raster, radar.site);
  const nameOf = (corner: number): number => {
    if (names[corner] === 0) {
      const height = lattice.heights[corner];
      const [east, north] = placeFromEarth(radar.site, pointOf(raster, lattice, corner));
      [east, north, (height - antenna) * radar.exaggeration].forEach((length) => places.push(length));
      terrainColor(height).forEach((channel) => colors.push(channel));
      heights.push(height);
      names[corner] = heights.length;
    }
    return names[corner] - 1;
  };
  const off: TerrainError = { largest: 0, squares: 0, count: 0 };
  eachTriangle(lattice, errors, error, (a, b, c) => {
    [a, b, c].forEach((corner) => indices.push(nameOf(corner)));
    addError(raster, lattice, [a, b, c], off);
  });
  if (indices.length === 0)
    throw new VolumeViewError(
      'format/unsupported',
      "the tiles of <volume-terrain> have no heights within the radar's reach; expected some that are no voids",
    );
  const mesh = makeNormals(
    {
      positions: places.take(),
      normals: null,
      indices: indices.take(),
      colors: colors.take(),
      space: null,
      format: 'HGT',
    },
    180,
  );
  const parts = splitMesh(mesh);
  const all = heights.take();
  const terrain: TerrainFacts = {
    error: off.largest,
    meanError: Math.sqrt(off.squares / Math.max(1, off.count)),
    heights: [all.reduce((a, b) => Math.min(a, b)), all.reduce((a, b) => Math.max(a, b))],
    voids: seen.voids / Math.max(1, seen.all),
  };
  return {
    parts,
    ...boundsOf(parts.map((part) => part.positions)),
    triangles: mesh.indices.length / 3,
    format: 'HGT',
    notes: noteOn(terrain, radar, antenna),
    terrain,
  };
}

/** Simplifies until there are few triangles: with a larger error, and then with fewer samples. */
function thin(
  raster: TerrainRaster,
  { site, reach }: TerrainRadar,
  max: number,
): { lattice: Lattice; errors: Float32Array; error: number; seen: { all: number; voids: number } } {
  const seen = { all: 0, voids: 0 };
  const isSeen = (row: number, column: number): boolean => {
    const [east, north] = placeFromEarth(site, {
      latitude: raster.north - row * raster.spacing,
      longitude: raster.west + column * raster.spacing,
    });
    return Math.hypot(east, north) <= reach;
  };
  let stride = Math.ceil((Math.max(raster.rows, raster.columns) - 1) / (maxSide - 1));
  countVoids(raster, stride, isSeen, seen);
  for (; ; stride *= 2) {
    const lattice = makeLattice(raster, stride, isSeen);
    const errors = latticeErrors(lattice);
    const error = findError(lattice, errors, max);
    if (error !== null || lattice.size <= 3) return { lattice, errors, error: error ?? Infinity, seen };
  }
}

function countVoids(
  { rows, columns, heights }: TerrainRaster,
  stride: number,
  isSeen: (row: number, column: number) => boolean,
  seen: { all: number; voids: number },
): void {
  for (let row = 0; row < rows; row += stride) {
    for (let column = 0; column < columns; column += stride) {
      if (!isSeen(row, column)) continue;
      seen.all++;
      if (heights[row * columns + column] === noHeight) seen.voids++;
    }
  }
}

function pointOf({ north, west, spacing }: TerrainRaster, { size, stride }: Lattice, corner: number): EarthPoint {
  return {
    latitude: north - Math.floor(corner / size) * stride * spacing,
    longitude: west + (corner % size) * stride * spacing,
  };
}

/** Metres above the sea of the sample nearest to a place; 0 if there is none. */
export function heightAt(
  { north, west, spacing, rows, columns, heights }: TerrainRaster,
  { latitude, longitude }: EarthPoint,
): number {
  const [row, column] = [Math.round((north - latitude) / spacing), Math.round((longitude - west) / spacing)];
  const height = row >= 0 && row < rows && column >= 0 && column < columns ? heights[row * columns + column] : noHeight;
  return height === noHeight ? 0 : height;
}

function noteOn({ voids }: TerrainFacts, { height }: TerrainRadar, antenna: number): string[] {
  return [
    ...(voids > 0
      ? [
          `${(100 * voids).toFixed(voids < 0.01 ? 2 : 0)} % of the terrain has no heights in its files, and is left open`,
        ]
      : []),
    ...(height === null
      ? [
          `the radar's file does not say how high the antenna is; it is taken to stand on the ground, ${antenna} m above the sea`,
        ]
      : []),
  ];
}
