import { VolumeViewError } from '../core/errors.ts';
import { isSoundGrid } from '../volume/sound-grid.ts';
import { Budget } from './base/budget.ts';
import type { DecodedVolume, DecodeInput, DecodeSettings, ProgressListener } from './base/decoded-volume.ts';
import type { FileAccess, FolderAccess, Format, ReadContext } from './base/format.ts';
import { loadIfReachable, loadReader } from './base/load-reader.ts';
import type { ScansListener } from './base/load-request.ts';
import { NeedsMainThread } from './base/needs-main-thread.ts';
import { allFormats } from './registry.ts';
import { sniffFile } from './sniff.ts';

export interface DecodeContext extends FileAccess {
  readonly onProgress: ProgressListener;
  readonly onScans?: ScansListener;
  readonly onRadar?: () => void;
  /**
   * Absolute URLs of a stack, the files of one volume in their order, the first one included; undefined if it is not a
   * stack.
   */
  readonly files?: readonly string[];
  readonly before?: number;
  readonly folder?: FolderAccess;
  readonly openList?: ReadContext['openList'];
  /** The known formats; all if undefined. */
  readonly formats?: readonly Format[];
  /** The limits of the load; the usual ones if undefined. Files that are fetched are added to it here. */
  readonly budget?: Budget;
}

/**
 * Turns a file's bytes, and those of the other files of a stack, into a volume. A format's reader is loaded when it is
 * needed.
 * @throws {VolumeViewError} `format/…`, `mosaic/layout`, `manifest/invalid`, `internal`, and what fetching throws
 * @throws {NeedsMainThread} in a worker that can't do it
 */
export async function decodeFile(
  input: DecodeInput,
  settings: DecodeSettings,
  context: DecodeContext,
): Promise<DecodedVolume> {
  try {
    const volume = await decodeData(input, settings, { ...context, ...withBudget(input, context), isPart: false });
    if (
      volume.grid.kind === 'polar' ||
      !isSoundGrid(volume.grid) ||
      !Number.isFinite(volume.intercept / volume.slope + volume.slope)
    ) {
      (await loadReader(() => import('#rare/formats/finish-rare.ts'))).checkGeometry(volume);
    }
    return volume;
  } catch (cause) {
    throw await explain(cause, input.url);
  }
}

/** The context with the budget of a load, which grows with each file that is fetched. */
function withBudget(
  input: DecodeInput,
  { budget = new Budget(), fetchFile, fetchFiles }: DecodeContext,
): FileAccess & { readonly budget: Budget } {
  const count = (file: DecodeInput): DecodeInput => {
    budget.addFile(file.packedBytes ?? file.bytes.length);
    return file;
  };
  count(input);
  return {
    budget,
    fetchFile: async (url, range) => count(await fetchFile(url, range)),
    async *fetchFiles(urls) {
      for await (const file of fetchFiles(urls)) yield count(file);
    },
  };
}

async function decodeData(
  input: DecodeInput,
  settings: DecodeSettings,
  context: DecodeContext & { readonly isPart: boolean; readonly budget: Budget },
): Promise<DecodedVolume> {
  const { files, formats = allFormats } = context;
  const format = await sniffFile(input, formats);
  if (files) (await loadReader(() => import('#rare/formats/images/check-stack.ts'))).checkStack(format, input, files);
  if ('loadImage' in format) {
    const { readImage, readImageStack } = await loadReader(() => import('#rare/formats/decode-image.ts'));
    if (!files) return readImage(format, input.bytes, settings, context);
    return readImageStack({ first: input, format, files, formats }, settings, context);
  }
  const read = await loadReader(() => format.load());
  return read(input, settings, {
    ...context,
    further: files?.slice(1) ?? [],
    decode: (first, files, settings, openList = context.openList) =>
      decodeData(first, settings, { ...context, files, openList, isPart: true }),
  });
}

/**
 * Turns whatever was thrown into an error with a code. What stops the work, or moves it to the main thread, is returned
 * as it is. @param url - of the file
 */
export async function explain(cause: unknown, url: string): Promise<unknown> {
  if (cause instanceof VolumeViewError || cause instanceof NeedsMainThread) return cause;
  if (cause instanceof DOMException && cause.name === 'AbortError') return cause;
  const words = await loadIfReachable(() => import('#rare/formats/explain-failure.ts'));
  return words ? words.explainFailure(cause, url) : cause;
}
