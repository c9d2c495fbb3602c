import type { DecodedVolume, DecodeSettings } from './base/decoded-volume.ts';
import { loadReader } from './base/load-reader.ts';
import { placeVolume } from './base/place-volume.ts';
import { hasNumbers, hasSweeps, isFrame } from './base/scan-data.ts';
import type { ScanData } from './base/scan-data.ts';
import { readScan } from './series/read-scan.ts';
import type { ScanAccess } from './series/read-scan.ts';

/**
 * Reads one volume of several, at its place in a page: its numbers, or the files that only a reader understands.
 * @throws {VolumeViewError} `format/…`, and what fetching throws
 */
export async function readPlacedScan(
  scan: ScanData,
  settings: DecodeSettings,
  access: ScanAccess,
): Promise<DecodedVolume> {
  if (hasSweeps(scan))
    return (await loadReader(() => import('#rare/formats/radar/read-radar.ts'))).readSweepsAgain(
      scan,
      settings,
      access,
    );
  if (isFrame(scan))
    return (await loadReader(() => import('#rare/formats/manifest/read-frames.ts'))).readFrameAgain(
      scan,
      settings,
      access,
    );
  const volume = hasNumbers(scan)
    ? await readScan(scan, access)
    : await (await loadReader(() => import('./dicom/read-phase.ts'))).readPhase(scan, access);
  return placeVolume(volume, settings);
}
