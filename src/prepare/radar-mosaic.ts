import { encode } from 'fast-png';
import { VolumeViewError } from '../core/errors.ts';
import { findFormat } from '../formats/sniff.ts';
import { radarKinds } from '../formats/radar/more-radar-formats.ts';
import { openRadar } from '../formats/radar/read-radar.ts';
import { writePolarMosaic } from './write-polar-mosaic.ts';
import type { WrittenMosaic } from './write-polar-mosaic.ts';

// Loaded by packages/prepare; no page loads it.

export interface RadarMosaicFiles {
  readonly png: Uint8Array;
  readonly manifest: WrittenMosaic['manifest'];
  /** Largest difference between a value and the value in the image. */
  readonly rounding: number;
  /** Says what is missing from a file that ends too early. */
  readonly partial?: string;
}

/**
 * One moment of any radar file as an image and its manifest.
 * @param name - of the file, for messages
 * @param moment - where undefined, the reflectivity that the largest number of sweeps have
 * @throws {VolumeViewError} as the readers do
 */
export async function makeRadarMosaic(
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  moment?: string,
): Promise<RadarMosaicFiles> {
  const format = await findFormat(bytes, [...radarKinds.keys()]);
  const kind = format && radarKinds.get(format);
  if (!kind) {
    throw new VolumeViewError(
      'format/unknown',
      `${name} is no radar file; expected ODIM_H5, CfRadial, NEXRAD Level II or III, or Rainbow 5`,
    );
  }
  const radar = await openRadar(kind, bytes);
  const { image, manifest, rounding } = writePolarMosaic(radar, moment);
  return {
    png: encodePng(image),
    manifest,
    rounding,
    ...(radar.partial === undefined ? {} : { partial: radar.partial }),
  };
}

/** A grey image of 8 or 16 bits. */
export function encodePng(image: WrittenMosaic['image']): Uint8Array {
  const depth = image.data instanceof Uint8Array ? 8 : 16;
  return encode({ ...image, channels: 1, depth }, { zlib: { level: 9 } });
}
