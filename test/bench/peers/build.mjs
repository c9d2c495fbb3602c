// Bundles each peer into dist/, where the benchmark's page finds it.
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const folder = dirname(fileURLToPath(import.meta.url));

/** Peers by file name. */
export const peerNames = ['three', 'vtk', 'niivue'];

/** Whether the peers' packages are installed. */
export const isInstalled = () => existsSync(join(folder, 'node_modules/three/package.json'));

/** @throws where a package lacks what a peer imports */
export async function buildPeers() {
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
