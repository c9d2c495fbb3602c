// Reads the frames of the video that a manifest names, as scans in time. Loaded with the first such manifest.
import { VolumeViewError } from '../../core/errors.ts';
import type { GrayImage } from '../../volume/mosaic.ts';
import { chooseScan } from '../base/choose-scan.ts';
import { isRadar } from '../base/decoded-volume.ts';
import type { DecodedVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { loadReader } from '../base/load-reader.ts';
import type { ScanOfFrame } from '../base/scan-data.ts';
import { readMosaic } from '../images/mosaic.ts';
import { timeText } from '../series/scan-times.ts';
import type { FrameAccess } from '../video/decode-frame.ts';
import { openVideo } from '../video/open-video.ts';
import { checkPlayer, codecName, hasWebCodecs, readFrame } from '../video/read-frame.ts';
import { countFrames } from '../video/video-table.ts';
import type { VideoTable } from '../video/video-table.ts';
import type { Manifest } from './manifest.ts';
import { applyPrepared } from './manifest-prepared.ts';
import { describeVolume, mergeSettings, resolveFile } from './use-manifest.ts';

/** A frame with what its manifest says of it. */
interface FrameScan extends ScanOfFrame {
  readonly video: VideoTable;
  readonly manifest: Manifest;
}

/**
 * Opens the video of a manifest, and reads the frame that is wanted.
 * @param manifest - of all frames, or of each one
 * @param base - URL of the manifest
 * @throws {VolumeViewError} `manifest/invalid`, `format/…`, `mosaic/layout`, and what fetching throws
 * @throws {NeedsMainThread} in a worker that has nothing which decodes it
 */
export async function openFrames(
  manifest: Manifest | readonly Manifest[],
  base: string,
  settings: DecodeSettings,
  context: ReadContext,
): Promise<DecodedVolume> {
  checkPlayer();
  const listed = Array.isArray(manifest) ? (manifest as readonly Manifest[]) : null;
  const [first] = listed ?? [manifest as Manifest];
  if (isRadar(mergeSettings(settings, first))) context.onRadar?.();
  const { bytes } = await context.fetchFile(resolveFile('video', first.video ?? '', base));
  const video = await openVideo(bytes, context.budget, hasWebCodecs());
  const count = countFrames(video);
  if (listed && listed.length !== count)
    throw new VolumeViewError(
      'manifest/invalid',
      `the manifest's "scans" got ${listed.length.toLocaleString('en')} scans for a video of ${count.toLocaleString('en')} frames; expected one for each frame`,
    );
  const scans = Array.from({ length: count }, (_, frame): FrameScan => ({
    frame,
    video,
    manifest: listed?.[frame] ?? first,
  }));
  const times = scans.map((scan) => timeOf(scan, listed !== null));
  if (count > 1) context.onScans?.(times, scans);
  return readFrameAgain(scans[chooseScan(times, settings.scan ?? { index: 0 }).index], settings, context);
}

/** What a list says, else the time in the video. A radar's time is that of a day, which no video has. */
function timeOf({ frame, video, manifest }: FrameScan, isListed: boolean): string | null {
  if (isListed) return manifest.time ?? null;
  return manifest.elevations ? null : timeText(video.times[frame] - video.times[0], 's');
}

/**
 * Reads a frame of a video that is open.
 * @param scan - as `openFrames` made it, perhaps sent to a page and back
 * @throws as `openFrames` does
 */
export async function readFrameAgain(
  scan: ScanOfFrame,
  settings: DecodeSettings,
  access: FrameAccess,
): Promise<DecodedVolume> {
  const { frame, video, manifest } = scan as FrameScan;
  const image = await readFrame(video, frame, access);
  clearBelow(image.data, manifest.noDataBelow);
  const merged = mergeSettings(settings, manifest);
  const format = `${codecName(video)} video`;
  if (isRadar(merged)) {
    const { readRadarMosaic } = await loadReader(() => import('../radar/read-radar.ts'));
    // It has applied slope and intercept.
    const volume = await readRadarMosaic(image, format, merged, access.budget);
    return applyPrepared(describeVolume(volume, { ...manifest, slope: 1, intercept: 0 }), manifest, access.budget);
  }
  const volume = readMosaic(image, format, merged, access.budget);
  const { noDataBelow, noData = noDataBelow === undefined ? undefined : 0 } = manifest;
  return applyPrepared(describeVolume(volume, manifest), { ...manifest, noData }, access.budget);
}

/** A pixel of 0 has no data, and so have those that a lossy codec made of it. */
function clearBelow(pixels: GrayImage['data'], limit = 0): void {
  for (let i = 0; i < pixels.length; i++) if (pixels[i] < limit) pixels[i] = 0;
}
