// The development server (`npm start`): the site of the docs, and the demos from the source. The package is built by scripts/build.mjs.
import { createReadStream } from 'node:fs';
import { defineConfig, type Plugin, type ViteDevServer } from 'vite';
import { findSharedData, sharedDataPrefix } from './scripts/shared-data.mjs';
import { siteOfDocs } from './scripts/site-plugin.mjs';

const hasDisplay =
  process.platform === 'darwin' ||
  process.platform === 'win32' ||
  Boolean(process.env.DISPLAY || process.env.WAYLAND_DISPLAY);

/** `/shared-data/` is the larger data beside the checkout, where there are any. */
const routes: Plugin = {
  name: 'volume-view-routes',
  configureServer(server) {
    sayPlaces(server);
    server.middlewares.use((request, response, next) => {
      const path = (request.url ?? '/').replace(/[?#].*$/, '');
      if (path === '/demos') {
        response.writeHead(302, { location: '/demos/' }).end();
      } else if (path === '/favicon.ico') {
        response.writeHead(204).end();
      } else if (path.startsWith(sharedDataPrefix)) {
        const file = findSharedData(path);
        response.writeHead(file ? 200 : 404, { 'content-type': 'application/octet-stream' });
        if (file) createReadStream(file).pipe(response);
        else response.end();
      } else next();
    });
  },
};

/** Says where things are. */
function sayPlaces(server: ViteDevServer): void {
  const print = server.printUrls.bind(server);
  server.printUrls = () => {
    print();
    const [origin = '/'] = server.resolvedUrls?.local ?? [];
    server.config.logger.info(`  Guide and gallery  ${origin}
  Demos              ${origin}demos/  (they reload when the source changes)
  Lesson studio      ${origin}studio/index.html
`);
  };
}

export default defineConfig({
  appType: 'mpa', // A missing file is a 404, not the first page.
  publicDir: false,
  plugins: [routes, siteOfDocs()],
  resolve: { conditions: ['module', 'browser', 'production'] }, // Lit's development build talks on the console.
  server: {
    host: '127.0.0.1',
    open: hasDisplay && !process.env.CI,
    watch: { ignored: ['**/packages/*/dist/**'] },
  },
  optimizeDeps: { entries: ['demos/*.html'] },
});
