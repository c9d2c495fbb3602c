import { Budget } from '../formats/base/budget.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { decodeFile } from '../formats/decode.ts';
import { finishVolume } from '../formats/finish-volume.ts';
import type { GrayImage } from '../volume/mosaic.ts';
import type { AppearanceSettings } from '../viewer/model/settings.ts';
import type { LossyError, Volume } from '../volume/volume.ts';
import { drawPoster } from './draw-poster.ts';
import { encodePng } from './radar-mosaic.ts';

/** Pixels with less opacity show nothing in 8 bits. */
const visible = 0.5 / 255;

/**
 * How far the picture of a volume is from that of the one before, 1/255, over the pixels that one of the two covers. Both are drawn by the
 * float64 reference, from the
 * camera that readers have of the changed volume: what a lossy form leaves in empty places may move it.
 * @param image - a mosaic of the changed volume @param manifest - without the name of the image
 * @param size - pixels across
 */
export async function comparePictures(
  before: Volume,
  image: GrayImage,
  manifest: object,
  size: number,
): Promise<LossyError> {
  return compareVolumes(before, await readBack(image, manifest), size);
}

/** The same for a changed volume that has been read. @param said - what a page says of the look */
export async function compareVolumes(
  before: Volume,
  after: Volume,
  size: number,
  said?: AppearanceSettings,
): Promise<LossyError> {
  // The window belongs to all scans.
  const { window } = after;
  const [{ pixels: a }, { pixels: b }] = [
    await drawPoster({ ...before, window }, size, after, said),
    await drawPoster(after, size, after, said),
  ];
  const worst: number[] = [];
  let squares = 0;
  for (let i = 0; i < a.length; i += 4) {
    if (a[i + 3] < visible && b[i + 3] < visible) continue;
    let max = 0;
    for (let c = i; c < i + 4; c++) {
      const off = 255 * Math.abs(a[c] - b[c]);
      squares += off * off;
      max = Math.max(max, off);
    }
    worst.push(max);
  }
  worst.sort((x, y) => x - y);
  const { length } = worst;
  return {
    rms: Math.sqrt(squares / Math.max(1, 4 * length)),
    p99: worst[Math.min(length - 1, Math.floor(0.99 * length))] ?? 0,
    max: worst.at(-1) ?? 0,
  };
}

/** The volume as a view reads it. */
export async function readBack(image: GrayImage, manifest: object): Promise<Volume> {
  const files: Readonly<Record<string, Uint8Array<ArrayBuffer>>> = {
    'https://video.invalid/image.png': new Uint8Array(encodePng(image)),
    'https://video.invalid/scan.json': new TextEncoder().encode(JSON.stringify({ image: 'image.png', ...manifest })),
  };
  const fetchFile = async (url: string): Promise<DecodeInput> => ({ bytes: files[url], url, contentType: '' });
  const decoded = await decodeFile(
    await fetchFile('https://video.invalid/scan.json'),
    {},
    {
      fetchFile,
      async *fetchFiles(urls) {
        for (const url of urls) yield await fetchFile(url);
      },
      budget: new Budget(),
      onProgress: () => undefined,
    },
  );
  return finishVolume(decoded, { maxVoxelsPerAxis: Infinity, maxAtlasSize: null, maxBytes: Infinity });
}
