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

async function buildPeers() {
  await build({
    configFile: false,
    root: folder,
    logLevel: 'error',
    publicDir: false,
    define: { 'process.env.NODE_ENV': '"production"' },
    build: {
      outDir: 'dist',
      target: 'es2022',
      lib: { entry: Object.fromEntries(peerNames.map((name) => [name, join(folder, `${name}.js`)])), formats: ['es'] },
    },
  });
}
