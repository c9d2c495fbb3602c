import { VolumeViewError } from '../../src/errors.ts';
import { decodeFile } from '../../src/formats/decode.ts';
import type { DecodeContext } from '../../src/formats/decode.ts';
import { fetchInOrder } from '../../src/formats/fetch-files.ts';
import { finishVolume } from '../../src/formats/finish-volume.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import { isPolar } from '../../src/volume/volume.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { buildPolarTable } from '../../src/radar/polar-table.ts';
import { layOutRadials } from '../../src/radar/polar-layout.ts';
import { startCounting, stopCounting } from './count-memory.ts';
import type { FilesCase, FuzzCase } from './fuzz-case.ts';
import { judgeText } from './judge-text.ts';

/** Milliseconds of the processor's time: other programs do not count. */
export const mostMs = 2000;
/** Bytes that a case may hold: so many for each byte of its files, and so many more. */
export const mostPerByte = 1100;
export const mostFree = 64 * 2 ** 20;
/** Bytes of the heap that code and the runtime itself need while a case runs. */
export const forRuntime = 8 * 2 ** 20;

export interface Verdict {
  /** 'volume', or the code of the error. */
  readonly outcome: string;
  /** What the error says. */
  readonly words?: string;
  /** What should not be; null where all is well. */
  readonly finding: Finding | null;
  readonly ms: number;
  /** Bytes that were held at the worst, and those of the files. */
  readonly peak: number;
  readonly size: number;
}

export interface Finding {
  /** The sort of a finding: 'time', 'memory', 'not finite', or an exception and where it was thrown. */
  readonly kind: string;
  readonly detail: string;
}

/** A device that is common: what does not fit is made smaller. */
const device = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 29 };
const maxTextureSize = 8192;

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

export function judgeCost(ms: number, peak: number, size: number): Finding | null {
  const allowed = mostPerByte * size + mostFree + forRuntime;
  if (peak > allowed) return { kind: 'memory', detail: `${megabytes(peak)} MB for ${size} bytes; at most ${megabytes(allowed)} MB` };
  return ms > mostMs ? { kind: 'time', detail: `${Math.round(ms)} ms; at most ${mostMs} ms` } : null;
}

const megabytes = (bytes: number): string => (bytes / 2 ** 20).toFixed(1);

/** The outcome of what may throw one of our errors, and nothing else. */
export async function runSafely(run: () => Finding | null | Promise<Finding | null>): Promise<Pick<Verdict, 'outcome' | 'words' | 'finding'>> {
  try {
    return { outcome: 'volume', finding: await run() };
  } catch (error) {
    if (error instanceof VolumeViewError && error.code !== 'internal') return { outcome: error.code, words: error.message.slice(0, 300), finding: judgeWords(error) };
    const cause = error instanceof VolumeViewError ? (error.cause ?? error) : error;
    return { outcome: 'exception', finding: { kind: `exception: ${describe(cause)}`, detail: cause instanceof Error ? (cause.stack ?? '') : String(cause) } };
  }
}

/** A message is for people, and a file can not make it long. */
function judgeWords({ code, message }: VolumeViewError): Finding | null {
  if (message.length < 10) return { kind: `words: ${code}`, detail: `"${message}" says nothing` };
  return message.length > 2000 ? { kind: `words: ${code}`, detail: `a message of ${message.length} characters: ${message.slice(0, 200)}` } : null;
}

/** The error with the function that threw it: one mistake is one finding. */
function describe(error: unknown): string {
  if (!(error instanceof Error)) return String(error);
  const where = /\n\s+at (?:async )?(?:new )?([\w.#<>]+)/.exec(error.stack ?? '')?.[1] ?? '';
  return `${error.name}: ${error.message.replace(/-?\d[\d.e+]*/g, 'N').slice(0, 60)} in ${where}`;
}

async function load({ files, stack, settings = {} }: FilesCase): Promise<Finding | null> {
  const fetchFile: DecodeContext['fetchFile'] = async (url) => {
    const name = decodeURIComponent(new URL(url).pathname.slice(1));
    const file = files.find((one) => one.name === name);
    if (!file) throw new VolumeViewError('source/not-found', `there is no ${name.slice(0, 100)}`);
    return { bytes: file.bytes.slice(), url, contentType: '' };
  };
  const urls = files.map(({ name }) => `https://example.test/${encodeURIComponent(name)}`);
  const context: DecodeContext = { fetchFile, fetchFiles: (urls) => fetchInOrder(urls, fetchFile, () => undefined), onProgress: () => undefined, ...(stack ? { files: urls } : {}) };
  const volume = await finishVolume(await decodeFile(await fetchFile(urls[0]), settings, context), device);
  return judgeVolume(volume);
}

/** What a page does with a volume before it is drawn, and whether all numbers are ones that can be drawn with. */
function judgeVolume(volume: Volume): Finding | null {
  const { samples, macrocells: _cells, histogram, ...rest } = volume;
  const wrong = findOdd(rest, '') ?? findOdd(boundingSphere(volume.grid), 'boundingSphere') ?? findOdd(Array.from(histogram.counts), 'histogram');
  if (wrong) return { kind: 'not finite', detail: wrong };
  if (!volume.grid.spacing.every((length) => length > 0)) return { kind: 'not finite', detail: `spacing ${volume.grid.spacing.join(' x ')}` };
  if (volume.range[0] > volume.range[1] || volume.slope === 0) return { kind: 'not finite', detail: `range ${volume.range.join(' to ')}, slope ${volume.slope}` };
  if (isPolar(volume)) {
    const layout = layOutRadials(volume.grid, maxTextureSize);
    if (layout) buildPolarTable(volume.grid, layout, maxTextureSize);
    return null;
  }
  const voxels = volume.grid.dimensions.reduce((product, n) => product * n, 1);
  return samples.length === voxels ? null : { kind: 'samples', detail: `${samples.length} samples for ${volume.grid.dimensions.join(' x ')}` };
}

/** Where in a value the first number is that is not finite. An Earth without curvature has an infinite radius. */
function findOdd(value: unknown, path: string): string | null {
  if (typeof value === 'number') return Number.isFinite(value) || path.endsWith('.earthRadius') ? null : `${path} is ${value}`;
  if (typeof value !== 'object' || value === null) return null;
  for (const [key, inner] of ArrayBuffer.isView(value) ? (value as unknown as number[]).entries() : Object.entries(value)) {
    const found = findOdd(inner, `${path}.${key}`);
    if (found) return found;
  }
  return null;
}
