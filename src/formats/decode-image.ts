import { VolumeViewError } from '../core/errors.ts';
import type { GrayImage } from '../volume/mosaic.ts';
import type { Budget } from './base/budget.ts';
import { isRadar } from './base/decoded-volume.ts';
import type { DecodedVolume, DecodeInput, DecodeSettings } from './base/decoded-volume.ts';
import type { FileAccess, Format, ImageFormat, ReadContext } from './base/format.ts';
import { joinSlices } from './images/join-slices.ts';
import type { Slice } from './images/join-slices.ts';
import { loadReader } from './base/load-reader.ts';
import { readMosaic } from './images/mosaic.ts';
import { nameOf } from './base/name-of.ts';
import { sniffFile } from './sniff.ts';

/** Reads an image as a mosaic: its tiles are slices, or a radar's sweeps. */
export async function readImage(
  format: ImageFormat,
  bytes: Uint8Array<ArrayBuffer>,
  settings: DecodeSettings,
  { budget, onProgress }: Pick<ReadContext, 'budget' | 'onProgress'>,
): Promise<DecodedVolume> {
  onProgress(0, bytes.length);
  const read = await loadReader(() => format.loadImage());
  return cutImage(await read(bytes, { channels: settings.channels, budget }), format.name, settings, budget);
}

interface ImageStack {
  readonly first: DecodeInput;
  readonly format: ImageFormat;
  /** Absolute URLs of all images, the first one included. */
  readonly files: readonly string[];
  readonly formats: readonly Format[];
}

/**
 * Reads several images, each one slice or one of a radar's sweeps: tiles of one column.
 * @throws {VolumeViewError} `mosaic/layout` if a mosaic is set too, `format/unsupported`, `format/corrupt`,
 * `format/too-large`
 */
export async function readImageStack(
  stack: ImageStack,
  settings: DecodeSettings,
  access: FileAccess & Pick<ReadContext, 'budget'>,
): Promise<DecodedVolume> {
  if (settings.mosaic) {
    throw new VolumeViewError(
      'mosaic/layout',
      'the stack of images got a mosaic layout too; expected one of them: in a stack each image is one slice',
    );
  }
  const { format, files } = stack;
  const image = await joinSlices(readSlices(stack, settings, access), files.length, access.budget);
  const volume = await cutImage(
    image,
    format.name,
    { ...settings, mosaic: { columns: 1, rows: files.length } },
    access.budget,
  );
  return { ...volume, format: `${format.name} stack` };
}

/** Reads one image after another, and releases each after it was used. */
async function* readSlices(
  { first, files, formats }: ImageStack,
  settings: DecodeSettings,
  { budget, fetchFiles }: FileAccess & Pick<ReadContext, 'budget'>,
): AsyncGenerator<Slice> {
  const readOne = async (input: DecodeInput): Promise<Slice> => {
    const format = await sniffFile(input, formats);
    const name = nameOf(input.url);
    if (!('loadImage' in format)) {
      throw new VolumeViewError(
        'format/unsupported',
        `the stack of images got ${name}, which is none (${format.name}); expected images alone, a slice each`,
      );
    }
    const read = await loadReader(() => format.loadImage());
    return { name, image: await read(input.bytes, { channels: settings.channels, budget }) };
  };
  yield await readOne(first);
  for await (const input of fetchFiles(files.slice(1))) yield await readOne(input);
}

async function cutImage(
  image: GrayImage,
  format: string,
  settings: DecodeSettings,
  budget: Budget,
): Promise<DecodedVolume> {
  if (isRadar(settings)) {
    const { readRadarMosaic } = await loadReader(() => import('./radar/read-radar.ts'));
    return readRadarMosaic(image, format, settings, budget);
  }
  return readMosaic(image, format, settings, budget);
}
