import { fetchBytes } from '../../src/sources/fetch-bytes.ts';
import type { FetchOptions } from '../../src/sources/download.ts';
import type { DecodeInput } from '../../src/formats/base/decoded-volume.ts';

/** One answer of a server, or a failure of the network. */
export interface Answer {
  readonly status?: number;
  readonly headers?: Record<string, string>;
  /** The bytes, in the pieces in which they arrive. */
  readonly pieces?: readonly (readonly number[] | Uint8Array<ArrayBuffer>)[];
  /** Whether the connection breaks after these pieces. */
  readonly breaks?: boolean;
  /** Whether there is no answer at all. */
  readonly refused?: boolean;
}

export interface Asked {
  readonly url: string;
  readonly headers: Record<string, string>;
  readonly credentials: RequestCredentials | undefined;
}

/** Run with a fake server that gives one answer after the other, and with timers that end at once. */
export async function withServer<T>(
  answers: readonly Answer[],
  run: (asked: Asked[], waits: number[]) => Promise<T>,
): Promise<T> {
  const { fetch: nativeFetch, setTimeout: nativeTimeout } = globalThis;
  const asked: Asked[] = [];
  const waits: number[] = [];
  const left = [...answers];
  globalThis.fetch = async (url, { headers, credentials } = {}) => {
    asked.push({ url: url as string, headers: { ...(headers as Record<string, string>) }, credentials });
    const answer = left.shift() ?? { refused: true };
    if (answer.refused) throw new TypeError('Failed to fetch');
    return new Response(streamOf(answer), { status: answer.status ?? 200, headers: answer.headers });
  };
  globalThis.setTimeout = ((act: () => void, ms = 0) => {
    if (ms > 0) waits.push(ms);
    return nativeTimeout(act);
  }) as typeof setTimeout;
  try {
    return await run(asked, waits);
  } finally {
    Object.assign(globalThis, { fetch: nativeFetch, setTimeout: nativeTimeout });
  }
}

/** Pieces arrive when the reader pulls them, so that it sees all pieces before a break. */
function streamOf({ pieces = [], breaks }: Answer): ReadableStream<Uint8Array> {
  let next = 0;
  return new ReadableStream({
    pull(controller) {
      const piece = pieces[next++];
      if (piece) controller.enqueue(ArrayBuffer.isView(piece) ? piece : Uint8Array.from(piece));
      else if (breaks) controller.error(new TypeError('network error'));
      else controller.close();
    },
  });
}

export const pageOrigin = 'https://example.test';

export function fetchOne(path = '/a.nii', options: Partial<FetchOptions> = {}): Promise<DecodeInput> {
  return fetchBytes(new URL(path, pageOrigin).href, { pageOrigin, onProgress: () => undefined, ...options });
}
