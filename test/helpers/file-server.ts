// A server of files, in place of the network.

// Node 20 has none.
if (!('navigator' in globalThis)) Object.assign(globalThis, { navigator: { onLine: true } });

/** Its origin. */
export const serverOfFiles = 'https://files.test';

/** What a server does that others do not. */
export interface Habits {
  readonly sendsNoParts?: boolean;
  /** As servers of another origin mostly do. */
  readonly hidesSizes?: boolean;
  /** As of another origin that allows no header: there is no answer to requests for parts. */
  readonly refusesParts?: boolean;
  readonly packsParts?: boolean;
  /** The status of the n-th request, from 0, in place of a file; undefined for a file. */
  readonly fail?: (n: number, url: string) => number | undefined;
}

export interface Asked {
  readonly name: string;
  readonly isPart: boolean;
}

/** A request with the bytes that came. */
export interface Sent extends Asked {
  readonly bytes: number;
}

export interface Served {
  readonly asked: Asked[];
  readonly sent: Sent[];
  readonly most: () => number;
}

/** Runs with files on a server, which answers after a moment. */
export async function withFiles<T>(
  files: ReadonlyMap<string, Uint8Array<ArrayBuffer>>,
  habits: Habits,
  run: (served: Served) => Promise<T>,
): Promise<T> {
  const native = globalThis.fetch;
  const asked: Asked[] = [];
  const sent: Sent[] = [];
  let [running, most] = [0, 0];
  globalThis.fetch = async (url, { headers, signal } = {}) => {
    const address = url as string;
    const range = new Headers(headers).get('range');
    const status = habits.fail?.(asked.length, address);
    const one = { name: address.slice(serverOfFiles.length + 1), isPart: range !== null };
    asked.push(one);
    most = Math.max(most, ++running);
    await new Promise((resolve) => setTimeout(resolve, 1));
    running--;
    signal?.throwIfAborted();
    if (status !== undefined) return new Response('', { status });
    const all = files.get(address)!;
    if (range === null || habits.sendsNoParts) {
      sent.push({ ...one, bytes: all.length });
      return new Response(all, { headers: { 'content-length': String(all.length) } });
    }
    if (habits.refusesParts) throw new TypeError('Failed to fetch');
    const [start, last] = /=(\d+)-(\d+)$/.exec(range)!.slice(1).map(Number);
    const part = all.subarray(start, last + 1);
    sent.push({ ...one, bytes: part.length });
    return new Response(part, {
      status: 206,
      headers: {
        'content-length': String(part.length),
        ...(habits.hidesSizes ? {} : { 'content-range': `bytes ${start}-${start + part.length - 1}/${all.length}` }),
        ...(habits.packsParts ? { 'content-encoding': 'gzip' } : {}),
      },
    });
  };
  try {
    return await run({ asked, sent, most: () => most });
  } finally {
    globalThis.fetch = native;
  }
}
