import { slotSide } from '../../src/bricks/brick-data.ts';
import { VolumeViewError } from '../../src/core/errors.ts';
import { decodeFile } from '../../src/formats/decode.ts';
import type { DecodeContext } from '../../src/formats/decode.ts';
import { fetchInOrder } from '../../src/sources/fetch-files.ts';
import { Budget } from '../../src/formats/base/budget.ts';
import type { LoadRequest, ScansListener } from '../../src/formats/base/load-request.ts';
import type { ScanData } from '../../src/formats/base/scan-data.ts';
import { checkGeometry } from '../../src/formats/base/check-geometry.ts';
import { finishVolume } from '../../src/formats/finish-volume.ts';
import type { FileTree } from '../../src/formats/zarr/file-tree.ts';
import { readZarr } from '../../src/formats/zarr/read-zarr.ts';
import { MemoryStore } from '../../src/sources/memory-store.ts';
import { openBricksOf } from '../helpers/brick-stores.ts';
import { findTrees, openTree } from '../../src/sources/store-tree.ts';
import { ZipStore } from '../../src/sources/zip-store.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { isPolar } from '../../src/volume/volume.ts';
import { decodeRequest } from '../../src/worker/decode-request.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { buildPolarTable } from '../../src/radar/polar-table.ts';
import { layOutRadials } from '../../src/radar/polar-layout.ts';
import { startCounting, stopCounting } from './count-memory.ts';
import type { FilesCase, FuzzCase, ServerCase, WebCase } from './fuzz-case.ts';
import { judgeText } from './judge-text.ts';
import { answerWeb, webSeries } from './web-server.ts';
import { judgeCost, runSafely } from './verdict.ts';
import type { Finding, Verdict } from './verdict.ts';

/** A device that is common: what does not fit is made smaller. */
const device = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 29 };
const maxTextureSize = 8192;

/** For folders, where chunks that are not there stand for as much as the device holds: so little that it is seen where more is taken. */
const smallDevice = { ...device, maxBytes: 2 ** 22 };
const smallBudget = 2 ** 26;

/** Load a case as the package does, and judge what came of it. */
export async function judge(one: FuzzCase): Promise<Verdict> {
  if ('attribute' in one) return judgeText(one);
  const size = one.files.reduce((sum, { bytes }) => sum + bytes.length, 0);
  startCounting();
  const start = process.cpuUsage();
  const { finding, ...answer } = await runSafely(() => load(one));
  const { user, system } = process.cpuUsage(start);
  const { peak, pausedMs } = stopCounting();
  const ms = Math.max(0, (user + system) / 1000 - pausedMs);
  return { ...answer, finding: finding ?? judgeCost(ms, peak, size), ms, peak, size };
}

async function load(one: FilesCase): Promise<Finding | null> {
  if (one.isBricks) return loadBricks(one);
  if (one.isTree) return loadTree(one);
  if (one.web) return loadWeb(one, one.web);
  if (one.times) return loadTimes(one);
  return judgeVolume(await (one.folder ? loadFolder(one) : one.server ? loadList(one, one.server) : loadFiles(one)));
}

/** Loads the wanted time. */
type LoadTime = (wanted: Pick<LoadRequest, 'scan' | 'data'>, onScans?: ScansListener) => Promise<Volume>;

/** All times of chosen files, each as it is loaded when it is shown. */
const loadTimes = (one: FilesCase): Promise<Finding | null> =>
  judgeTimes((wanted, onScans) => loadFolder(wanted.data ? { files: [] } : one, wanted, onScans));

/** All times of a series on a DICOMweb server. */
function loadWeb({ files }: FilesCase, web: WebCase): Promise<Finding | null> {
  const fetch = answerWeb(files, web);
  return withoutWaits(() =>
    judgeTimes((wanted, onScans) =>
      decodeRequest(
        { url: webSeries, limits: device, ...wanted },
        { pageOrigin: 'https://example.test', onProgress: () => undefined, onCoarse: () => undefined, onScans, fetch },
      ),
    ),
  );
}

/** So many times are shown. */
const maxTimes = 8;

async function judgeTimes(load: LoadTime): Promise<Finding | null> {
  const scans: ScanData[] = [];
  const first = await load({ scan: { index: 0 } }, (_times, data) => scans.push(...(data ?? [])));
  let wrong = judgeVolume(first);
  for (const [index, data] of scans.slice(0, maxTimes).entries()) {
    try {
      wrong ??= judgeVolume(await load({ scan: { index }, data }));
    } catch (error) {
      if (!(error instanceof VolumeViewError) || error.code === 'internal') throw error;
    }
  }
  return wrong;
}

/** A list of files on a server, as a worker loads it. */
function loadList({ files }: FilesCase, server: ServerCase): Promise<Volume> {
  const origin = 'https://example.test';
  const urls = files.map(({ name }) => `${origin}/${encodeURIComponent(name)}`);
  const answer = async (url: string, headers: Headers): Promise<Response> => {
    const place = urls.indexOf(url);
    if (place === server.lacks) return new Response(null, { status: 404 });
    const all = files[place].bytes;
    const [, end = null] = /^bytes=0-(\d+)$/.exec(headers.get('range') ?? '') ?? [];
    const part = server.sendsParts && end !== null ? all.subarray(0, Number(end) + 1) : all;
    const body = place === server.cuts ? part.subarray(0, part.length >> 1) : part;
    const length = { 'content-length': String(Math.max(0, body.length + server.liesBy)) };
    if (!server.sendsParts || end === null) return new Response(body, { headers: length });
    const range = `bytes 0-${part.length - 1}/${server.hidesSizes ? '*' : all.length + server.liesBy}`;
    return new Response(body, { status: 206, headers: { ...length, 'content-range': range } });
  };
  return withoutWaits(() =>
    decodeRequest(
      { url: urls[0], files: urls, limits: device },
      {
        pageOrigin: origin,
        onProgress: () => undefined,
        onCoarse: () => undefined,
        fetch: (url, options) => answer(url as string, new Headers(options?.headers)),
      },
    ),
  );
}

/** Tries again at once what a page tries again after seconds, and as long as a browser is online. */
async function withoutWaits<T>(run: () => Promise<T>): Promise<T> {
  const { setTimeout: native } = globalThis;
  globalThis.setTimeout = ((act: () => void) => native(act)) as typeof setTimeout;
  if (!('navigator' in globalThis)) Object.assign(globalThis, { navigator: { onLine: true } });
  try {
    return await run();
  } finally {
    globalThis.setTimeout = native;
  }
}

/** As a reader's choice of files is loaded. */
function loadFolder(
  { files, settings }: FilesCase,
  wanted: Pick<LoadRequest, 'scan' | 'data'> = {},
  onScans?: ScansListener,
): Promise<Volume> {
  const base = 'https://local-1.invalid/';
  const chosen = files.map(({ name, bytes }) => {
    const file = new File([bytes], name);
    Object.defineProperty(file, 'webkitRelativePath', { value: name });
    return file;
  });
  return decodeRequest(
    { url: base, local: { base, files: chosen }, settings, limits: device, ...wanted },
    { pageOrigin: 'https://example.test', onProgress: () => undefined, onCoarse: () => undefined, onScans },
  );
}

async function loadFiles({ files, stack, settings = {} }: FilesCase): Promise<Volume> {
  const fetchFile: DecodeContext['fetchFile'] = async (url) => {
    const name = decodeURIComponent(new URL(url).pathname.slice(1));
    const file = files.find((one) => one.name === name);
    if (!file) throw new VolumeViewError('source/not-found', `there is no ${name.slice(0, 100)}`);
    return { bytes: file.bytes.slice(), url, contentType: '' };
  };
  const urls = files.map(({ name }) => `https://example.test/${encodeURIComponent(name)}`);
  const context: DecodeContext = {
    fetchFile,
    fetchFiles: (urls) =>
      fetchInOrder(
        urls,
        (url) => fetchFile(url),
        () => undefined,
      ),
    onProgress: () => undefined,
    ...(stack ? { files: urls } : {}),
  };
  return finishVolume(await decodeFile(await fetchFile(urls[0]), settings, context), device);
}

/** The folder of a case. */
async function treeOf({ files, isPacked, choice }: FilesCase): Promise<FileTree> {
  const found = new Map(files.map(({ name, bytes }) => [name, bytes] as const));
  const packed = isPacked ? await openArchive(files[0].bytes) : null;
  return {
    ...choice,
    async read(path, { part } = {}) {
      const bytes = found.get(path);
      if (!bytes || !part) return bytes?.slice() ?? null;
      return 'end' in part ? bytes.slice(part.start, part.end) : bytes.slice(Math.max(0, bytes.length - part.last));
    },
    ...packed,
    showPart: async (part) => void (await finishVolume(part, smallDevice)),
  };
}

async function loadTree(one: FilesCase): Promise<Finding | null> {
  const { settings = {} } = one;
  const tree = await treeOf(one);
  const load = { limits: smallDevice, budget: new Budget(smallBudget), onProgress: () => undefined };
  const decoded = await readZarr(tree, settings, load);
  checkGeometry(decoded);
  return judgeVolume(await finishVolume(decoded, smallDevice));
}

/** The first, the last and another brick of each level, and what is said of the levels. A brick that can't be read keeps no other from it. */
async function loadBricks(one: FilesCase): Promise<Finding | null> {
  const { signal } = new AbortController();
  const opening = { signal, keptBytes: smallDevice.maxBytes, deviceBytes: smallBudget };
  const store = await openBricksOf(await treeOf(one), opening, one.settings ?? {});
  if (!store) return null;
  let wrong = findOdd(store.levels, 'levels') ?? findOdd([store.slope, store.intercept], 'scaling');
  let failure: unknown;
  for (const [level, { bricks }] of store.levels.entries())
    for (const share of [0, 0.5, 1]) {
      const at = bricks.map((n) => Math.round(share * (n - 1))) as unknown as Vector3;
      try {
        const { samples, low, high } = await store.read({ level, at }, signal);
        if (samples.length !== slotSide ** 3) wrong ??= `${samples.length} samples`;
        if (low <= high) wrong ??= findOdd([low, high], 'range');
      } catch (error) {
        if (!(error instanceof VolumeViewError) || error.code === 'internal') throw error;
        failure ??= error;
      }
    }
  const table = await store.residuals(signal);
  for (const { max, rms } of table?.levels ?? []) wrong ??= findOdd([...max, ...rms], 'residuals');
  store.close();
  if (failure) throw failure;
  return wrong === null ? null : { kind: 'not finite', detail: wrong };
}

/** An OME-Zarr in a ZIP archive. */
async function openArchive(bytes: Uint8Array<ArrayBuffer>): Promise<Pick<FileTree, 'read'>> {
  const url = 'https://example.test/x.ozx';
  const base = 'https://archive.invalid/';
  const zip = await ZipStore.open(new MemoryStore({ bytes, url, contentType: '' }), url, base, 'x.ozx');
  const [folder] = findTrees(await zip.list(), base);
  if (folder === undefined) throw new VolumeViewError('format/unknown', 'the archive holds no Zarr');
  const opened = await openTree(zip, { folder, base }, undefined, { kind: 'archive' });
  return { read: opened.tree!.read };
}

/** What a page does with a volume before it is drawn, and whether all numbers are ones that can be drawn with. */
function judgeVolume(volume: Volume): Finding | null {
  const { samples, macrocells: _cells, histogram, channels, ...rest } = volume;
  // Samples may be NaN: no data.
  const ofChannels = channels?.list.map(({ samples: _values, ...one }) => one);
  const wrong =
    findOdd(rest, '') ??
    findOdd(ofChannels, 'channels') ??
    findOdd(boundingSphere(volume.grid), 'boundingSphere') ??
    findOdd(Array.from(histogram.counts), 'histogram');
  if (wrong) return { kind: 'not finite', detail: wrong };
  if (!volume.grid.spacing.every((length) => length > 0))
    return { kind: 'not finite', detail: `spacing ${volume.grid.spacing.join(' x ')}` };
  if (volume.range[0] > volume.range[1] || volume.slope === 0)
    return { kind: 'not finite', detail: `range ${volume.range.join(' to ')}, slope ${volume.slope}` };
  if (isPolar(volume)) {
    const layout = layOutRadials(volume.grid, maxTextureSize);
    if (layout) buildPolarTable(volume.grid, layout, maxTextureSize);
    return null;
  }
  const voxels = volume.grid.dimensions.reduce((product, n) => product * n, 1);
  const isWhole =
    samples.length === voxels &&
    (channels?.colors.length ?? 4 * voxels) === 4 * voxels &&
    (channels?.list.every((one) => one.samples.length === voxels) ?? true);
  return isWhole
    ? null
    : { kind: 'samples', detail: `${samples.length} samples for ${volume.grid.dimensions.join(' x ')}` };
}

/** Where in a value the first number is that is not finite. An Earth without curvature has an infinite radius. */
function findOdd(value: unknown, path: string): string | null {
  if (typeof value === 'number')
    return Number.isFinite(value) || path.endsWith('.earthRadius') ? null : `${path} is ${value}`;
  if (typeof value !== 'object' || value === null) return null;
  for (const [key, inner] of ArrayBuffer.isView(value)
    ? (value as unknown as number[]).entries()
    : Object.entries(value)) {
    const found = findOdd(inner, `${path}.${key}`);
    if (found) return found;
  }
  return null;
}
