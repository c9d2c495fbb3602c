import { Budget } from '../formats/base/budget.ts';
import { readManifest } from '../formats/manifest/manifest.ts';
import type { Manifest } from '../formats/manifest/manifest.ts';
import { readPng } from '../formats/images/png.ts';
import { readPolarMosaic } from '../formats/radar/polar-mosaic.ts';
import { radarKinds } from '../formats/radar/more-radar-formats.ts';
import type { RadarFile } from '../formats/radar/radar-file.ts';
import { openRadar } from '../formats/radar/read-radar.ts';
import { findFormat } from '../formats/sniff.ts';
import type { ByteStore } from '../sources/byte-store.ts';
import { writePolarMosaic } from './write-polar-mosaic.ts';
import type { WrittenMosaic } from './write-polar-mosaic.ts';

/**
 * The mosaic of a radar's scan: from its file, or from a manifest that names one or is itself of a mosaic.
 * @param url - of the file @param index - of the scan in a manifest @param moment - null: the one that a volume of the file shows
 * @throws {VolumeViewError} as the readers do
 */
export async function writeRadar(
  store: ByteStore,
  url: string,
  index: number,
  moment?: string,
): Promise<WrittenMosaic> {
  const { bytes } = await store.read(url);
  const file = await readRadar(bytes);
  if (file) return writePolarMosaic(file, moment);
  const { scans, ...single } = readManifest(bytes);
  const manifest: Manifest = scans ? scans[index] : single;
  const named = (await store.read(new URL(manifest.image ?? manifest.files![0], url).href)).bytes;
  const own = await readRadar(named);
  const written = writePolarMosaic(own ?? (await readMosaic(named, manifest)), moment ?? manifest.moment);
  const { title, credit, window, transferFunction } = manifest;
  const said = Object.fromEntries(
    Object.entries({ title, credit, window, transferFunction }).filter(([, value]) => value !== undefined),
  );
  return { ...written, manifest: { ...written.manifest, ...said } };
}

async function readRadar(bytes: Uint8Array<ArrayBuffer>): Promise<RadarFile | null> {
  const format = await findFormat(bytes, [...radarKinds.keys()]);
  const kind = format && radarKinds.get(format);
  return kind ? openRadar(kind, bytes, Budget.ofFile(bytes.length)) : null;
}

async function readMosaic(bytes: Uint8Array<ArrayBuffer>, manifest: Manifest): Promise<RadarFile> {
  const { slope = 1, intercept = 0, unit = '', elevations = [] } = manifest;
  return readPolarMosaic(await readPng(bytes), 'PNG', { ...manifest, slope, intercept, unit, elevations });
}
