// A simple server of the checkout on 127.0.0.1, for tests of the built package and for the other engines. A second port is another origin:
// /cors/… sends Access-Control-Allow-Origin, /no-cors/… does not.
import { createReadStream } from 'node:fs';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { pathToFileURL } from 'node:url';
import { findFile, findSharedData, projectRoot } from './shared-data.mjs';

/** @type {Record<string, string>} */
export const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.ts': 'text/javascript; charset=utf-8', // Tests put a script at such an address.
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.map': 'application/json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.webp': 'image/webp',
  '.wasm': 'application/wasm',
};

/**
 * Headers by path prefix.
 * @type {Record<string, Record<string, string>>}
 */
const EXTRA_HEADERS = {
  '/test/e2e/pages/csp/': {
    'content-security-policy':
      "default-src 'self'; script-src 'self'; style-src 'self'; object-src 'none'; base-uri 'none'",
  },
};

/** @param {string} path @returns {Record<string, string>} */
function findExtraHeaders(path) {
  return Object.assign(
    {},
    ...Object.entries(EXTRA_HEADERS).map(([prefix, headers]) => (path.startsWith(prefix) ? headers : {})),
  );
}

/**
 * @param {import('node:http').ServerResponse} response
 * @param {string} path - of the URL, percent-encoded
 * @param {{ root: string, headers?: Record<string, string> }} options
 */
function sendFile(response, path, { root, headers = {} }) {
  const file = findSharedData(path) ?? findFile(root, path.endsWith('/') ? `${path}index.html` : path);
  if (!file) {
    response.writeHead(404, { 'content-type': 'text/plain', ...headers }).end('no such file');
    return;
  }
  const type = TYPES[extname(file)] ?? 'application/octet-stream';
  response.writeHead(200, { 'content-type': type, 'cache-control': 'no-store', ...headers });
  createReadStream(file).pipe(response);
}

/**
 * @param {import('node:http').ServerResponse} response
 * @param {Uint8Array} bytes
 * @param {string} [type]
 */
function sendBytes(response, bytes, type = 'application/octet-stream') {
  const headers = {
    'content-type': type,
    'content-length': bytes.length,
    'cache-control': 'no-store',
  };
  response.writeHead(200, headers).end(bytes);
}

/**
 * Store a page that a test has written, until another page replaces it at the same address.
 * @param {import('node:http').IncomingMessage} request - PUT, with the page in its body
 * @param {import('node:http').ServerResponse} response
 * @param {Map<string, string>} pages - by path and query
 */
async function takePage(request, response, pages) {
  request.setEncoding('utf8');
  let text = '';
  for await (const part of request) text += part;
  pages.set(request.url ?? '', text);
  response.writeHead(204).end();
}

/** @param {string | undefined} url */
const readPath = (url) => (url ?? '/').replace(/[?#].*$/, '');

/**
 * @param {import('node:http').RequestListener} listener
 * @param {number} port - 0 takes any free one
 * @returns {Promise<{ url: string, close: () => void }>}
 */
function listen(listener, port) {
  return new Promise((resolve, reject) => {
    const server = createServer(listener).once('error', reject);
    server.listen(port, '127.0.0.1', () => {
      const address = /** @type {import('node:net').AddressInfo} */ (server.address());
      const close = () => {
        server.close();
        server.closeAllConnections();
      };
      resolve({ url: `http://127.0.0.1:${address.port}`, close });
    });
  });
}

/**
 * @param {{ port?: number, crossPort?: number, made?: Record<string, () => Uint8Array>, root?: string, takesPages?: boolean }} [options] - made: contents
 * that are served without a file, by path; root: the folder that is served, by default the checkout; takesPages: tests may put pages on
 * the server, and browsers may cache the built files, as on a production server
 * @returns {Promise<{ url: string, crossUrl: string, close: () => void }>} no slash at the end of the addresses
 */
export async function startStaticServer({
  port = 0,
  crossPort = 0,
  made = {},
  root = projectRoot,
  takesPages = false,
} = {}) {
  /** @type {Map<string, string>} */
  const pages = new Map();
  const own = await listen((request, response) => {
    const path = readPath(request.url);
    if (path === '/favicon.ico') response.writeHead(204).end(); // Browsers request it by themselves; a 404 would be a console message.
    else if (Object.hasOwn(made, path))
      sendBytes(response, made[path](), /\.(html|js)$/.test(path) ? TYPES[extname(path)] : undefined);
    else if (takesPages && request.method === 'PUT') void takePage(request, response, pages);
    else if (pages.has(request.url ?? ''))
      response
        .writeHead(200, { 'content-type': TYPES[extname(path)] ?? TYPES['.html'], 'cache-control': 'no-cache' })
        .end(pages.get(request.url ?? ''));
    else
      sendFile(response, path, {
        root,
        headers: {
          ...(takesPages && path.startsWith('/dist/') && { 'cache-control': 'max-age=3600' }),
          ...findExtraHeaders(path),
        },
      });
  }, port);
  const cross = await listen((request, response) => {
    const [, kind, rest] = /^\/(cors|no-cors)(\/.*)$/.exec(readPath(request.url)) ?? [];
    if (kind)
      sendFile(response, rest, { root, headers: kind === 'cors' ? { 'access-control-allow-origin': '*' } : {} });
    else response.writeHead(404).end();
  }, crossPort);
  const close = () => {
    own.close();
    cross.close();
  };
  return { url: own.url, crossUrl: cross.url, close };
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const { url, crossUrl } = await startStaticServer({ port: Number(process.env.PORT ?? 0) });
  console.log(`${url}/\n${crossUrl}/cors/ and ${crossUrl}/no-cors/ (another origin)`);
}
