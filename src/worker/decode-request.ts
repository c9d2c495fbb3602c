import type { Volume } from '../volume/volume.ts';
import { Budget } from '../formats/base/budget.ts';
import { decodeFile, explain } from '../formats/decode.ts';
import type { DecodeContext } from '../formats/decode.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import { startsSeries } from '../formats/nifti/nifti-header.ts';
import { maxFileBytes } from '../sources/download.ts';
import { fetchBytes } from '../sources/fetch-bytes.ts';
import type { FetchOne } from '../sources/fetch-files.ts';
import { isDicomWeb } from '../sources/is-dicomweb.ts';
import { isZarr } from '../sources/is-zarr.ts';
import { isZip } from '../sources/is-zip.ts';
import type { OpenedFiles } from '../sources/opened-files.ts';
import { finishVolume } from '../formats/finish-volume.ts';
import { loadReader } from '../formats/base/load-reader.ts';
import type {
  CoarseListener,
  LoadProgress,
  LoadProgressListener,
  LoadRequest,
  ScansListener,
} from '../formats/base/load-request.ts';

export interface RequestEnvironment {
  readonly signal?: AbortSignal;
  readonly pageOrigin: string;
  /** The limits of the load; if undefined, those of a worker. */
  readonly budget?: Budget;
  /** Awaited between two long pieces of work. */
  readonly breathe?: () => Promise<void>;
  /** Fetches in place of the browser's own function, which is used if undefined. */
  readonly fetch?: typeof globalThis.fetch | null;
  readonly onProgress: LoadProgressListener;
  readonly onScans?: ScansListener;
  readonly onCoarse?: CoarseListener;
}

/**
 * Fetches, decodes and fits a volume on this thread, a worker's or the page's own.
 * @param request - with an absolute `url` and `files`
 * @throws {VolumeViewError} as fetchBytes and decodeFile say; {NeedsMainThread} in a worker that can't do it
 */
export async function decodeRequest(request: LoadRequest, environment: RequestEnvironment): Promise<Volume> {
  const {
    signal,
    pageOrigin,
    budget = new Budget(readDeviceBytes()),
    breathe,
    onProgress,
    onScans,
    onCoarse,
    fetch,
  } = environment;
  const url = request.files?.[0] ?? request.url;
  let opened: OpenedFiles | undefined;
  let { files } = request;
  // Of a file of several volumes, those that are shown are fetched.
  let isEnough = request.scan && !files ? startsSeries : null;
  const settings = { ...request.settings, scan: request.scan, finer: request.finer };
  const { credentials } = settings;
  let named: RequestCredentials | undefined = credentials;
  const report = (phase: LoadProgress['phase']) => (loaded: number, total: number) => {
    signal?.throwIfAborted(); // Long work on the main thread passes here often.
    onProgress({ loaded, total, phase });
  };
  const load = { request, onCoarse, onProgress: report('fetch'), budget };
  const reading = { signal, pageOrigin, fetch, credentials, maxBytes: Math.min(maxFileBytes, budget.deviceBytes) };
  const optionsOf = (url: string) => ({
    ...reading,
    credentials: request.files?.includes(url) ? credentials : named,
    isEnough,
  });
  const fetchOne: FetchOne = (url, onProgress) => (opened?.read ?? fetchBytes)(url, { ...optionsOf(url), onProgress });
  // The first one of many says nothing of all.
  const fetchFile = (url: string) => fetchOne(url, (loaded, total) => load.onProgress(loaded, files?.[1] ? 0 : total));
  const lists = () => loadReader(() => import('#rare/sources/fetch-files.ts'));
  const fetchFiles: DecodeContext['fetchFiles'] = async function* (urls) {
    yield* (await lists()).fetchInOrder(urls, fetchOne, load.onProgress);
  };
  const openList: DecodeContext['openList'] = async (...list) => (await lists()).openList(list, optionsOf, load);
  const start = async (): Promise<DecodeInput> => {
    let first = request.local || isDicomWeb(url) || isZarr(url) ? null : await fetchFile(url);
    // A file from another server chooses what else is fetched: that must not use the reader's cookies and logins.
    if (first?.url.startsWith('http') && new URL(first.url).origin !== pageOrigin) named = 'omit';
    if (!first || (isZip(first.bytes) && !files?.[1])) {
      const { openFiles } = await loadReader(() => import('#rare/sources/open-files.ts'));
      opened = await openFiles(first ?? request.local ?? url, { isStack: files !== undefined, load, signal }, reading);
      ({ files } = opened);
      first = await fetchFile(opened.first);
    }
    isEnough = null;
    await breathe?.();
    return first;
  };
  const decode = async (first: DecodeInput | null) => {
    const read =
      first && !(first.missing! > 0)
        ? decodeFile
        : (await loadReader(() => import('#rare/worker/decode-scan.ts'))).decodeScan;
    return read(first!, settings, {
      fetchFile,
      fetchFiles,
      openList: opened ? undefined : openList,
      files,
      onProgress: report('decode'),
      onScans,
      onRadar: () => load.onCoarse?.(null),
      budget,
      request,
      ...opened,
      ...reading,
    });
  };
  try {
    // Only the decoder holds the file, so that its memory can be freed during the next steps.
    const decoded = await decode(request.data ? null : await start());
    await breathe?.();
    signal?.throwIfAborted();
    return await finishVolume(
      opened?.describe(decoded) ?? decoded,
      await request.limits,
      load.onCoarse,
      settings.clean,
    );
  } catch (cause) {
    throw await explain(cause, url);
  }
}

/**
 * Half of the memory that the device reports; undefined if it reports none. Browsers report 8 GiB at most, or little
 * more.
 */
function readDeviceBytes(): number | undefined {
  const gigabytes = (globalThis.navigator as { deviceMemory?: number } | undefined)?.deviceMemory;
  return gigabytes === undefined ? undefined : gigabytes * 2 ** 29;
}
