// The stone of demos/large on a server of a benchmark.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { compileFunction } from 'node:vm';
import { projectRoot } from '../../scripts/shared-data.mjs';

/**
 * The stone on a server, under /<levels that are left out>/stone.ome.zarr. A chunk is computed when it is first asked for, and kept.
 * @returns {Promise<{ url: string, counts: { chunks: number, bytes: number }, close: () => void }>}
 */
export function startStone() {
  /** @type {{ ask?: (event: { data: string }) => void, answer: string | Uint8Array | null }} */
  const worker = { answer: null };
  const source = readFileSync(join(projectRoot, 'demos/large/stone.js'), 'utf8');
  compileFunction(source, ['addEventListener', 'postMessage'])(
    (/** @type {string} */ _, /** @type {(event: { data: string }) => void} */ listener) => (worker.ask = listener),
    (/** @type {string | Uint8Array | null} */ data) => (worker.answer = data),
  );
  /** @type {Map<string, string | Uint8Array | null>} */
  const kept = new Map();
  const find = (/** @type {string} */ path) => {
    if (!kept.has(path)) {
      worker.ask?.({ data: path });
      kept.set(path, worker.answer);
    }
    return kept.get(path) ?? null;
  };
  const counts = { chunks: 0, bytes: 0 };
  const server = createServer((request, response) => {
    const [, leftOut, level, rest] = /^\/(\d)\/stone\.ome\.zarr\/(?:(\d)\/)?(.*)$/.exec(request.url ?? '') ?? [];
    const found = find(level ? `${Number(level) + Number(leftOut)}/${rest}` : rest);
    const body = found && (level ? found : describeFrom(String(found), Number(leftOut)));
    if (rest?.startsWith('c/')) counts.chunks++;
    counts.bytes += body?.length ?? 0;
    response.writeHead(body ? 200 : 404, { 'access-control-allow-origin': '*', 'cache-control': 'no-store' }).end(body);
  });
  // It must not close a connection that waits while a chunk is computed.
  server.keepAliveTimeout = 0;
  return new Promise((resolve) =>
    server.listen(0, '127.0.0.1', () => {
      const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
      const close = () => {
        server.close();
        server.closeAllConnections();
      };
      resolve({ url: `http://127.0.0.1:${port}`, counts, close });
    }),
  );
}

/** The stone without its finest levels. @param {string} text - its zarr.json @param {number} leftOut */
function describeFrom(text, leftOut) {
  const group = JSON.parse(text);
  const [image] = group.attributes.ome.multiscales;
  image.datasets = image.datasets.slice(leftOut);
  for (const [i, dataset] of image.datasets.entries()) dataset.path = String(i);
  return JSON.stringify(group);
}
