// The development server of the demos (`npm start`). The package is built by scripts/build.mjs.
import { createReadStream } from 'node:fs';
import { defineConfig, type Plugin, type ViteDevServer } from 'vite';
import { findSharedData, sharedDataPrefix } from './scripts/shared-data.mjs';

const hasDisplay =
  process.platform === 'darwin' ||
  process.platform === 'win32' ||
  Boolean(process.env.DISPLAY || process.env.WAYLAND_DISPLAY);

/** `/` is the gallery, and `/shared-data/` the larger data beside the checkout, where there are any. */
const routes: Plugin = {
  name: 'volume-view-routes',
  configureServer(server) {
    sayPlaces(server);
    server.middlewares.use((request, response, next) => {
      const path = (request.url ?? '/').replace(/[?#].*$/, '');
      if (path === '/' || path === '/demos') {
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

/** Says where the demos and the lesson studio are, and how to get the site of the guide, which is a build of its own. */
function sayPlaces(server: ViteDevServer): void {
  const print = server.printUrls.bind(server);
  server.printUrls = () => {
    print();
    const [origin = '/'] = server.resolvedUrls?.local ?? [];
    server.config.logger.info(`  Demos          ${origin}demos/
  Lesson studio  ${origin}packages/studio/dist/index.html
  Guide          npm run site, in another terminal: its pages with examples that can be changed
`);
  };
}

export default defineConfig({
  appType: 'mpa', // A missing file is a 404, not the gallery.
  publicDir: false,
  plugins: [routes],
  resolve: { conditions: ['module', 'browser', 'production'] }, // Lit's development build talks on the console.
  server: { host: '127.0.0.1', open: hasDisplay && !process.env.CI ? '/demos/' : false },
  optimizeDeps: { entries: ['demos/*.html'] },
});
