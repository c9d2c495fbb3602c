// Bundles each peer into dist/, where the benchmark's page finds it.
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const folder = dirname(fileURLToPath(import.meta.url));

/** Peers by file name. */
export const peerNames = ['three', 'vtk', 'niivue'];

/** Bundle the peers, unless they are not installed: that is said. @returns whether they are there @throws where a package lacks what a peer imports */
export async function preparePeers() {
  const isThere = existsSync(join(folder, 'node_modules/three/package.json'));
  if (isThere) await buildPeers();
  else console.log('left out: the peers are not installed; run: npm ci --prefix test/bench/peers --ignore-scripts');
  return isThere;
}

/** Bundle Cornerstone's loader, with its workers. */
export const buildLoader = () => buildModules(['cornerstone']);

/** Bundle vole-core, with its worker. @returns whether it is there */
export async function buildVole() {
  const isThere = existsSync(join(folder, 'node_modules/@aics/vole-core/package.json'));
  if (isThere) await buildModules(['vole']);
  else console.log('left out: vole-core is not installed; run: npm ci --prefix test/bench/peers --ignore-scripts');
  return isThere;
}

const buildPeers = () => buildModules(peerNames);

async function buildModules(/** @type {readonly string[]} */ names) {
  await build({
    configFile: false,
    root: folder,
    base: './',
    logLevel: 'error',
    publicDir: false,
    define: { 'process.env.NODE_ENV': '"production"' },
    // Node's own module of this name, which a package of Cornerstone's extends.
    resolve: { alias: { events: join(folder, 'node_modules/events/events.js') } },
    worker: { format: 'es' },
    build: {
      outDir: 'dist',
      emptyOutDir: false,
      target: 'es2022',
      lib: { entry: Object.fromEntries(names.map((name) => [name, join(folder, `${name}.js`)])), formats: ['es'] },
    },
  });
}
