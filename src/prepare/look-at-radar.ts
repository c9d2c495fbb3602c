import { readScanTime } from '../core/scan-time.ts';
import { radarKinds } from '../formats/radar/more-radar-formats.ts';
import { findFormat } from '../formats/sniff.ts';
import type { ByteStore } from '../sources/byte-store.ts';
import { startBytes } from '../sources/find-volume.ts';
import { isPolar } from '../volume/volume.ts';
import { decodeSource } from './decode-source.ts';
import type { DecodeOptions } from './decode-source.ts';
import { sizeOfRadar } from './prepare-source.ts';

/** What says which scans of a radar belong to one video. */
export interface RadarLook {
  /** Milliseconds since 1970. */
  readonly time: number;
  /** What the scans of one video have in common: the radar, the quantity and the size. */
  readonly kind: string;
}

/**
 * Looks at a file of one radar scan.
 * @returns null where it is another file, holds kinds of echo, or does not say its time
 * @throws {VolumeViewError} where it can't be read
 */
export async function lookAtRadar(store: ByteStore, url: string, options: DecodeOptions): Promise<RadarLook | null> {
  const { bytes } = await store.read(url, { range: { start: 0, end: startBytes } });
  if (!(await findFormat(bytes, [...radarKinds.keys()]))) return null;
  for await (const one of decodeSource(store, { first: url, phase: 1 }, options)) {
    if ('error' in one) throw one.error;
    const { volume } = one;
    if (!isPolar(volume) || volume.isDiscrete || !volume.radar?.time) return null;
    const { site, moment, time } = volume.radar;
    const read = readScanTime(time);
    const kind = JSON.stringify([site.latitude, site.longitude, moment, volume.unit, sizeOfRadar(volume.grid)]);
    return read?.unit === 'UTC' ? { time: read.value, kind } : null;
  }
  return null;
}
