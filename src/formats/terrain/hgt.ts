import { VolumeViewError } from '../../core/errors.ts';
import { unpackAll } from '../meshes/read-mesh.ts';
import { isGzip } from '../codecs/gunzip.ts';

/** Samples along a side of a tile of one degree: of 3 and of 1 second of arc. */
const sides = [1201, 3601];

/** The value of a sample without a height. */
export const noHeight = -32_768;

/** One degree of latitude and longitude, a tile of SRTM. */
export interface HgtTile {
  /** Degrees north and east of its south-west corner. */
  readonly south: number;
  readonly west: number;
  /** Samples along a side; neighbouring tiles share their border samples. */
  readonly side: number;
  /** Metres above the sea, from the north-west corner row by row to the east. */
  readonly heights: DataView;
}

/**
 * The south-west corner of a tile from its file's name, such as N46E007.hgt.
 * @returns degrees north and east; null if the name does not say it
 */
export function cornerOf(name: string): readonly [south: number, west: number] | null {
  const [, ns, latitude, ew, longitude] = /(?:^|[^a-z])([ns])(\d{2})([ew])(\d{3})(?!\d)/i.exec(name) ?? [];
  if (!ns) return null;
  const corner = [Number(latitude) * (/s/i.test(ns) ? -1 : 1), Number(longitude) * (/w/i.test(ew) ? -1 : 1)] as const;
  return isOnEarth(corner) ? corner : null;
}

export function isOnEarth([south, west]: readonly [number, number]): boolean {
  return south >= -90 && south < 90 && west >= -180 && west < 180;
}

/**
 * Reads a tile of heights.
 * Source: *SRTM Topography*, NASA/JPL, section 3: big-endian numbers of 16 bits, voids -32768
 * @param corner - degrees north and east; null to take it from the name
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `attribute/invalid`
 */
export async function readHgt(
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  corner: readonly [number, number] | null,
): Promise<HgtTile> {
  const largest = 2 * sides[1] ** 2;
  const plain = isGzip(bytes) ? await unpackAll(bytes, largest) : bytes;
  const side = sides.find((one) => 2 * one * one === plain.length);
  if (!side) {
    const isZip = plain[0] === 0x50 && plain[1] === 0x4b;
    throw new VolumeViewError(
      'format/unknown',
      `${name} has ${plain.length.toLocaleString('en')} bytes${isZip ? ' and is a zip archive: unpack it' : ''}; expected heights as SRTM has them, ".hgt", of ${sides.map((one) => `${(2 * one * one).toLocaleString('en')} bytes (${one} x ${one} samples)`).join(' or ')}`,
    );
  }
  const [south, west] = corner ?? cornerOf(name) ?? fail(name);
  return { south, west, side, heights: new DataView(plain.buffer, plain.byteOffset, plain.length) };
}

function fail(name: string): never {
  throw new VolumeViewError(
    'attribute/invalid',
    `${name} does not say where it is; expected a name such as N46E007.hgt, for the south-west corner at 46 degrees north and 7 degrees east, or corner="46 7"`,
  );
}
