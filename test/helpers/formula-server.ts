// A server on this machine of files that are computed, with the delays and failures of real ones. In Node.
import { createServer } from 'node:http';
import type { IncomingMessage, ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import type { FormulaFiles } from './formula-pyramid.ts';

export interface ServerFaults {
  /** Milliseconds before each answer. */
  readonly delayMs?: number;
  /** Share of the requests for chunks that fail: with status 503, or broken off in the middle, in turns. */
  readonly failing?: number;
  /** Bytes a second, of all answers together; as fast as it can if undefined. */
  readonly bytesPerSecond?: number;
}

export interface FormulaServer {
  readonly origin: string;
  /** Of the folder, with a slash at its end. */
  readonly url: string;
  /** Paths below the folder, in the order of the requests. */
  readonly asked: readonly string[];
  /** Counts of requests: open at the same time at most, open now, given up before the answer was sent, made to fail; and bytes sent. */
  readonly counts: { most: number; running: number; cancelled: number; failed: number; sent: number };
  /** May be changed at any time. */
  faults: ServerFaults;
  close(): Promise<void>;
}

/** @param name - of the folder */
export async function startFormulaServer(
  files: FormulaFiles,
  faults: ServerFaults = {},
  name = 'formula.ome.zarr',
): Promise<FormulaServer> {
  const asked: string[] = [];
  const counts = { most: 0, running: 0, cancelled: 0, failed: 0, sent: 0 };
  const folder = `/${name}/`;
  let [due, failures] = [0, 0];
  /** Waits until the connection, which all share, has sent so many bytes. */
  const send = async (bytes: number): Promise<void> => {
    const { bytesPerSecond } = served.faults;
    if (!bytesPerSecond) return;
    due = Math.max(due, performance.now()) + (1000 * bytes) / bytesPerSecond;
    await wait(due - performance.now());
  };
  const answer = async (request: IncomingMessage, response: ServerResponse): Promise<void> => {
    response.setHeader('Access-Control-Allow-Origin', '*');
    response.setHeader('Access-Control-Allow-Headers', 'range');
    const { pathname } = new URL(request.url!, 'http://x');
    const path = decodeURIComponent(pathname.slice(folder.length));
    asked.push(path);
    const { delayMs, failing = 0 } = served.faults;
    if (delayMs) await wait(delayMs);
    if (response.destroyed) return;
    const size = pathname.startsWith(folder) ? files.sizeOf(path) : null;
    if (size === null) return void response.writeHead(404).end();
    failures += path.endsWith('.json') ? 0 : failing;
    const isFailing = failures >= 1;
    if (isFailing) {
      failures -= 1;
      if (counts.failed++ % 2 === 0) return void response.writeHead(503).end();
    }
    const [, first, last] = /^bytes=(\d*)-(\d*)$/.exec(request.headers.range ?? '') ?? [];
    let [start, end] = [0, size];
    if (first !== undefined) {
      start = first === '' ? Math.max(0, size - Number(last)) : Number(first);
      end = first === '' || last === '' ? size : Math.min(size, Number(last) + 1);
      if (start >= size) return void response.writeHead(416).end();
      response.statusCode = 206;
      response.setHeader('Content-Range', `bytes ${start}-${end - 1}/${size}`);
    }
    response.setHeader('Content-Length', end - start);
    if (request.method === 'HEAD') return void response.end();
    const bytes = files.bytesOf(path, start, end);
    await send(bytes.length);
    if (response.destroyed) return;
    counts.sent += bytes.length;
    if (!isFailing) return void response.end(bytes);
    response.write(bytes.subarray(0, bytes.length >> 1));
    setTimeout(() => request.socket.destroy(), 5);
  };
  const server = createServer((request, response) => {
    counts.most = Math.max(counts.most, ++counts.running);
    response.on('close', () => {
      counts.running--;
      if (!response.headersSent) counts.cancelled++;
    });
    void answer(request, response);
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  const served: FormulaServer = {
    origin,
    url: origin + folder,
    asked,
    counts,
    faults,
    close: () => new Promise((resolve) => void (server.closeAllConnections(), server.close(() => resolve()))),
  };
  return served;
}

const wait = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, Math.max(0, ms)));
