// A static server of the files of a store, on this machine, with the faults that servers have. In Node.
import { createServer } from 'node:http';
import type { IncomingMessage, ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import type { ZarrFiles } from './zarr-bytes.ts';

export interface ZarrFaults {
  /** Whether parts of files are sent; else the whole file comes. */
  readonly ranges?: boolean;
  /** Whether pages of other origins may read. */
  readonly open?: boolean;
  /** Of so many requests one fails: with status 503, or broken off in the middle, in turns; 0 for none. */
  readonly failEvery?: number;
  /** In place of 404 for what is not there. */
  readonly missingStatus?: number;
  /** Whether no answer says how long it is. */
  readonly hidesSizes?: boolean;
  /** Milliseconds before each answer. */
  readonly slowMs?: number;
}

export interface ZarrServer {
  readonly origin: string;
  /** Of the store: a folder. */
  readonly url: string;
  /** Method and path of all requests, below the folder. */
  readonly asked: readonly string[];
  /** Bytes of files that were sent. */
  readonly sent: () => number;
  /** Requests that were open at the same time, and that are open now. */
  readonly most: () => number;
  readonly running: () => number;
  close(): Promise<void>;
}

/** @param files - a change of them is served; the path '' is the address itself @param name - of the folder */
export async function startZarr(
  files: ZarrFiles,
  faults: ZarrFaults = {},
  name = 'brain.ome.zarr',
): Promise<ZarrServer> {
  const { ranges = true, open = true, failEvery = 0, missingStatus = 404, slowMs = 0, hidesSizes = false } = faults;
  const asked: string[] = [];
  let [running, most, sent, count] = [0, 0, 0, 0];
  const folder = `/data/${name}`;
  const answer = async (request: IncomingMessage, response: ServerResponse): Promise<void> => {
    if (open) response.setHeader('Access-Control-Allow-Origin', '*');
    const { pathname } = new URL(request.url!, 'http://x');
    const path = decodeURIComponent(pathname.slice(folder.length).replace(/^\//, ''));
    asked.push(`${request.method} ${path}`);
    if (slowMs) await new Promise((resolve) => setTimeout(resolve, slowMs));
    const file = pathname.startsWith(folder) ? files.get(path) : undefined;
    if (!file) return void response.writeHead(missingStatus).end();
    const isFailing = failEvery > 0 && ++count % failEvery === 0;
    if (isFailing && (count / failEvery) % 2 === 1) return void response.writeHead(503).end();
    const [, first, last] = /^bytes=(\d*)-(\d*)$/.exec(request.headers.range ?? '') ?? [];
    let bytes = file;
    if (ranges && first !== undefined) {
      const start = first === '' ? Math.max(0, file.length - Number(last)) : Number(first);
      const end = first === '' || last === '' ? file.length : Math.min(file.length, Number(last) + 1);
      if (start >= file.length) return void response.writeHead(416).end();
      bytes = file.subarray(start, end);
      response.statusCode = 206;
      response.setHeader('Content-Range', `bytes ${start}-${end - 1}/${file.length}`);
    }
    if (!hidesSizes) response.setHeader('Content-Length', bytes.length);
    if (request.method === 'HEAD') return void response.end();
    sent += bytes.length;
    if (!isFailing) return void response.end(bytes);
    response.write(bytes.subarray(0, bytes.length >> 1));
    setTimeout(() => request.socket.destroy(), 5);
  };
  const server = createServer((request, response) => {
    most = Math.max(most, ++running);
    response.on('close', () => running--);
    void answer(request, response);
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  return {
    origin,
    url: origin + folder,
    asked,
    sent: () => sent,
    most: () => most,
    running: () => running,
    close: () => new Promise((resolve) => void (server.closeAllConnections(), server.close(() => resolve()))),
  };
}
