// The first page of the development server (`npm start`) is the site of the docs. All other addresses are Vite's: the demos, from the source.
import { createReadStream, existsSync, readFileSync, statSync } from 'node:fs';
import { extname, join, relative } from 'node:path';
import { addDemosLink } from '../packages/site/build/pages.mjs';
import { buildSiteFolder, siteFolder } from './build-site.mjs';
import { findFile, projectRoot } from './shared-data.mjs';
import { TYPES } from './static-server.mjs';

/** The addresses of the site. The other addresses below `/demos/` are the demos themselves. */
const ADDRESSES =
  /^\/($|[\w-]+\.html$|site\.|search-index\.js$|docs\/|examples\/|studio\/|demos\/data\/LICENSES\.html$)/;

/** What the site is made from, except the element and the studio. @param {string} file */
const isSource = (file) =>
  /^(docs\/|demos\/(index\.html|data\/|images\/)|packages\/site\/(src|build)\/|[A-Z]+\.md$)/.test(
    relative(projectRoot, file).replaceAll('\\', '/'),
  );

/** When the element and the studio were built. */
const builtWith = () =>
  ['dist', 'packages/studio/dist'].map((folder) => {
    const path = join(projectRoot, folder);
    if (!existsSync(path)) throw new Error(`${folder} is missing: run "npm run build" first`);
    return statSync(path).mtimeMs;
  });

/** @param {import('vite').Logger} logger */
async function build(logger) {
  logger.info('  The site of the docs is being built ...');
  const start = performance.now();
  const { pages } = await buildSiteFolder();
  logger.info(
    `  The site of the docs is built: ${pages} pages in ${((performance.now() - start) / 1000).toFixed(1)} s`,
  );
}

/** @param {import('node:http').ServerResponse} response @param {string} file */
function send(response, file) {
  response.writeHead(200, {
    'content-type': TYPES[extname(file)] ?? 'application/octet-stream',
    'cache-control': 'no-store',
  });
  if (extname(file) === '.html') response.end(addDemosLink(readFileSync(file, 'utf8')));
  else createReadStream(file).pipe(response);
}

/** @returns {import('vite').Plugin} */
export function siteOfDocs() {
  /** The newest build of the site; null if there is none, or if a source has changed. @type {Promise<void> | null} */
  let site = null;
  let last = Promise.resolve();
  let parts = '';

  /** One build follows another. @param {import('vite').Logger} logger */
  async function prepare(logger) {
    const now = builtWith().join();
    if (site && now === parts) return site;
    parts = now;
    const own = last.then(() => build(logger));
    site = own;
    last = own.catch(() => {
      if (site === own) site = null;
    });
    return own;
  }

  return {
    name: 'volume-view-site',
    configureServer(server) {
      const { logger } = server.config;
      server.watcher.on('all', (_, file) => {
        if (isSource(file)) site = null;
      });
      server.middlewares.use((request, response, next) => {
        const path = (request.url ?? '/').replace(/[?#].*$/, '');
        if (!ADDRESSES.test(path)) return next();
        prepare(logger).then(() => {
          const file = findFile(siteFolder, path.endsWith('/') ? `${path}index.html` : path);
          if (file) send(response, file);
          else next();
        }, next);
      });
      // Only `vite` itself prints addresses: other programs that use its server need no site.
      const print = server.printUrls.bind(server);
      server.printUrls = () => {
        print();
        prepare(logger).catch((/** @type {Error} */ error) => logger.error(error.message));
      };
    },
  };
}
