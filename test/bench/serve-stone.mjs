// In the page: the stone of demos/large without some of its finest levels, as `view.fetch` reads it, over a network that may be slow and fail.

import { startWorkers } from '../../demos/large/ask-workers.js';

/**
 * @typedef {object} Network
 * @property {number} [delay] - before each answer, ms
 * @property {number} [bytesPerSecond] - of all answers together
 * @property {number} [failing] - the share of requests that get HTTP status 503
 */

/**
 * @param {string} base - of the checkout, with a slash at its end
 * @param {number} shift - levels of the stone that are left out; the next one is then the finest. Below 0: so many finer ones are added
 * @param {Network} [network]
 */
export function serveStone(base, shift, { delay = 0, bytesPerSecond = Infinity, failing = 0 } = {}) {
  const folder = `${base}stone.ome.zarr/`;
  const leftOut = Math.max(0, shift);
  const counts = { asked: 0, alive: 0, most: 0, failed: 0, chunks: 0, bytes: 0 };
  const { ask, close } = startWorkers(1, Math.max(0, -shift));
  let state = 1;
  const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  /** When the wire is free again. */
  let free = 0;
  /** @param {number} ms @param {AbortSignal | null | undefined} signal */
  const wait = (ms, signal) =>
    new Promise((resolve, reject) => {
      setTimeout(resolve, ms);
      signal?.addEventListener('abort', () => reject(signal.reason));
    });

  /** @param {string} path */
  async function read(path) {
    const [, level, rest] = /^(?:(\d)\/)?(.*)$/.exec(path) ?? [];
    const body = await ask(level ? `${Number(level) + leftOut}/${rest}` : rest);
    if (rest.startsWith('c/')) counts.chunks++;
    if (level || !body) return body;
    const group = JSON.parse(/** @type {string} */ (body));
    const [image] = group.attributes.ome.multiscales;
    image.datasets = image.datasets.slice(leftOut);
    for (const [i, dataset] of image.datasets.entries()) dataset.path = String(i);
    return JSON.stringify(group);
  }

  /** @param {RequestInfo | URL} url @param {RequestInit} [options] */
  async function fetchStone(url, options) {
    const signal = options?.signal;
    counts.asked++;
    counts.most = Math.max(counts.most, ++counts.alive);
    try {
      if (delay > 0) await wait(delay, signal);
      if (random() < failing) {
        counts.failed++;
        return new Response(null, { status: 503 });
      }
      const body = await read(/** @type {string} */ (url).slice(folder.length));
      const length = body?.length ?? 0;
      counts.bytes += length;
      const now = performance.now();
      free = Math.max(free, now) + (1000 * length) / bytesPerSecond;
      if (free > now + 1) await wait(free - now, signal);
      return new Response(body, { status: body ? 200 : 404 });
    } finally {
      counts.alive--;
    }
  }

  return { folder, fetch: fetchStone, counts, close };
}
