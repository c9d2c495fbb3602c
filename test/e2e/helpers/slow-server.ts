import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';

/** A server of one file that stops half way. */
export interface SlowServer {
  readonly url: string;
  /** Requests so far. */
  readonly requests: () => number;
  /** Resolves when a page gave a request up before its end. */
  readonly dropped: Promise<void>;
  /** Send the rest, now and to all later requests. */
  readonly release: () => void;
  readonly close: () => void;
}

/**
 * Serve a file to all origins; the second part of it is sent when the test says so.
 * @param share - 0..1, of the bytes that are sent at once
 */
export async function serveSlowly(bytes: Uint8Array, share: number): Promise<SlowServer> {
  let release = (): void => {};
  const released = new Promise<void>((resolve) => (release = resolve));
  let drop = (): void => {};
  const dropped = new Promise<void>((resolve) => (drop = resolve));
  let requests = 0;
  const split = Math.round(bytes.length * share);
  const server = createServer((_, response) => {
    requests++;
    response.writeHead(200, {
      'content-length': bytes.length,
      'access-control-allow-origin': '*',
      'cache-control': 'no-store',
    });
    response.write(bytes.subarray(0, split));
    response.once('close', () => {
      if (!response.writableFinished) drop();
    });
    void released.then(() => response.end(bytes.subarray(split)));
  });
  await new Promise<void>((resolve) => void server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}/field.nii`,
    requests: () => requests,
    dropped,
    release,
    close: () => {
      server.close();
      server.closeAllConnections();
    },
  };
}
