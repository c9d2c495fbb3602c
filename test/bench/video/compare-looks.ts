// What a video loses in a picture, as an element would state it in looks that differ from that in which the loss was measured, against what it does lose there.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { bytesOfFrame, decodeVideo, encodeVideo, readFrames } from '../../../packages/prepare/src/ffmpeg.ts';
import { storeOfFile } from '../../../packages/prepare/src/folder-store.ts';
import { compareVolumes, readBack } from '../../../src/prepare/compare-pictures.ts';
import { encodeValues, LossySum, ValueRange } from '../../../src/prepare/video-codes.ts';
import { readVideoScans } from '../../../src/prepare/video-scans.ts';
import type { VideoScan } from '../../../src/prepare/video-scans.ts';
import { scaleLoss } from '../../../src/quality/include-loss.ts';
import type { ColorsOfValues } from '../../../src/quality/include-loss.ts';
import { withDefaultLook } from '../../../src/viewer/appearance/default-look.ts';
import { resolveAppearance } from '../../../src/viewer/appearance/resolve-appearance.ts';
import { plainAppearance } from '../../../src/viewer/model/plain-appearance.ts';
import type { AppearanceSettings } from '../../../src/viewer/model/settings.ts';
import type { Lossy, LossyError, Volume } from '../../../src/volume/volume.ts';

/** Pixels across. */
const size = 48;

export interface LookResult {
  readonly look: string;
  /** Root mean square, 1/255. */
  readonly known: number;
  readonly stated: number;
}

/** The looks that are compared, by what they do to the window that the data have. */
function looksOf([low, high]: readonly [number, number]): Readonly<Record<string, Partial<AppearanceSettings>>> {
  const [middle, width] = [(low + high) / 2, high - low];
  const unlit = { shading: 'unlit', opacityFactor: 6 } as const;
  return {
    unlit,
    'unlit and thin': { ...unlit, opacityFactor: 1 },
    'unlit and very thin': { ...unlit, opacityFactor: 0.2 },
    lit: { shading: 'lit', opacityFactor: 1 },
    'lit and dense': { shading: 'lit', opacityFactor: 20 },
    'half the window': { window: [middle - width / 4, middle + width / 4] },
    'a quarter of it': { window: [middle, middle + width / 4] },
    'three times the window': { window: [low - width, high + width] },
    'an opaque step': { ...unlit, transferFunction: `${middle} black 0, ${middle} white 50%` },
    viridis: { shading: 'lit', opacityFactor: 6, transferFunction: 'viridis' },
  };
}

/** @param path - of a file, the first scan of which is encoded @param quality - VP9's crf */
export async function compareLooks(path: string, quality: number): Promise<readonly LookResult[]> {
  const { store, url } = storeOfFile(resolve(path));
  const scans = readVideoScans(store, { first: url, phase: 1 }, { deviceBytes: 2 ** 30 });
  const scan = (await scans.next()).value as VideoScan;
  await scans.return(undefined);
  const { after, lost } = await encode(scan, quality);
  const before = scan.volume;
  const lossy: Lossy = { ...lost, picture: await compareVolumes(before, after, size) };
  const made = await colorsOf(after, plainAppearance);
  const results: LookResult[] = [];
  for (const [look, changes] of Object.entries(looksOf(after.window ?? after.range))) {
    const said = { ...plainAppearance, ...changes };
    const stated = scaleLoss(lossy, after, { now: await colorsOf(after, said), made });
    const known = await compareVolumes(before, after, size, said);
    results.push({ look, known: known.rms, stated: stated!.rms });
  }
  return results;
}

async function colorsOf(volume: Volume, said: AppearanceSettings): Promise<ColorsOfValues> {
  const { transferFunction, opacityFactor, referenceLength } = await resolveAppearance(
    withDefaultLook(said, volume),
    volume,
  );
  return { transferFunction, opticalScale: opacityFactor / referenceLength };
}

/** The scan as a page reads it from a video, and what its values lost. */
async function encode(
  { values, step, width, height, manifest, isRadar }: VideoScan,
  quality: number,
): Promise<{ readonly after: Volume; readonly lost: LossyError }> {
  const range = new ValueRange();
  range.add(values, step);
  const scale = range.scale(true);
  const { slope, intercept, noDataBelow } = scale;
  const work = mkdtempSync(join(tmpdir(), 'volume-view-bench-looks-'));
  try {
    const [video, decoded] = [join(work, 'video.webm'), join(work, 'decoded.yuv')];
    const raw = { path: join(work, 'raw.yuv'), width, height, frames: 1 };
    const chroma = new Uint8Array(bytesOfFrame(raw) - width * height).fill(128);
    writeFileSync(raw.path, Buffer.concat([encodeValues(values, scale), chroma]));
    encodeVideo(raw, video, { codec: 'vp9', quality, rate: 5 });
    decodeVideo(video, decoded);
    const [codes] = readFrames({ ...raw, path: decoded });
    const sum = new LossySum(scale);
    sum.add(values, codes);
    const image = { width, height, data: codes.map((code) => (code < noDataBelow ? 0 : code)) };
    const own = { ...manifest, slope, intercept, ...(noDataBelow > 0 && !isRadar ? { noData: 0 } : {}) };
    return { after: await readBack(image, own), lost: sum.error };
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}
