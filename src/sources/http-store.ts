import { VolumeViewError } from '../core/errors.ts';
import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import type { ByteRange, ByteStore, FileStat, ReadOptions } from './byte-store.ts';
import { Download } from './download.ts';
import type { FetchOptions } from './download.ts';
import { fetchBytes } from './fetch-bytes.ts';

/** Files on servers, and `data:` and `blob:` URLs. */
export class HttpStore implements ByteStore {
  constructor(readonly options: Pick<FetchOptions, 'pageOrigin' | 'credentials' | 'fetch'>) {}

  async list(): Promise<null> {
    return null;
  }

  /** Requests the head of the file. Where the server does not send it, the size is unknown, and reading the file says why. */
  async stat(url: string): Promise<FileStat> {
    if (!url.startsWith('http')) return { size: null };
    const { headers, ok } = await fetch(url, { method: 'HEAD', credentials: this.options.credentials }).catch(() =>
      Response.error(),
    );
    const size = Number((!headers.has('content-encoding') && headers.get('content-length')) || NaN);
    return { size: ok && Number.isSafeInteger(size) ? size : null };
  }

  /** For a range it requests no more than that. Servers that can't send parts send the file from its start, and are cut off. */
  async read(url: string, { range, onProgress = () => undefined, ...limits }: ReadOptions = {}): Promise<DecodeInput> {
    const options: FetchOptions = { ...this.options, ...limits, onProgress };
    const part = range && url.startsWith('http') ? await readPart(url, range, options) : null;
    if (part) return part;
    const whole = await fetchBytes(url, options);
    return range ? { ...whole, bytes: whole.bytes.slice(range.start, range.end) } : whole;
  }
}

/** @returns null where the whole file has to be tried: that tries again, and explains what is wrong. */
async function readPart(url: string, range: ByteRange, options: FetchOptions): Promise<DecodeInput | null> {
  const download = new Download(url, options);
  try {
    const response = await download.open({ range: `bytes=${range.start}-${range.end - 1}` });
    const { headers, status } = response;
    // Servers of another origin hide this header, unless they say otherwise.
    const isRange = headers.get('content-range')?.startsWith(`bytes ${range.start}-`) ?? true;
    if (status === 206 && isRange && !headers.has('content-encoding')) return await download.read(response);
    const contentType = headers.get('content-type') ?? '';
    if (status === 200) return { bytes: await readUpTo(response, range), url: response.url || url, contentType };
    await response.body?.cancel();
    if (status === 416) return { bytes: new Uint8Array(), url, contentType };
  } catch (cause) {
    options.signal?.throwIfAborted();
    if (cause instanceof VolumeViewError) throw cause;
  }
  return null;
}

/** Reads a file from its start to the end of a range, and keeps the range. */
async function readUpTo({ body }: Response, { start, end }: ByteRange): Promise<Uint8Array<ArrayBuffer>> {
  const reader = body?.getReader();
  const kept: Uint8Array<ArrayBuffer>[] = [];
  for (let at = 0; at < end;) {
    const { done, value } = (await reader?.read()) ?? { done: true, value: undefined };
    if (done || !value) break;
    kept.push(value.slice(Math.max(0, start - at), Math.max(0, end - at)));
    at += value.length;
  }
  await reader?.cancel();
  return new Uint8Array(await new Blob(kept).arrayBuffer());
}
