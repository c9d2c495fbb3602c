// `npm run build` in this folder: builds the program and its modules, from TypeScript and the readers of the element, as JavaScript for
// Node.
import { cpSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const folder = dirname(fileURLToPath(import.meta.url));

/** What a page of a lesson loads, of the folder dist of the element. */
const player = ['volume-view.iife.js', 'volume-view.css', 'x3dom.js', 'classic', 'THIRD-PARTY-LICENSES.txt'];

/** Build the folder dist; the element has been built before. @returns {Promise<void>} */
export async function buildPrepare() {
  await build({
    configFile: false,
    root: folder,
    publicDir: false,
    logLevel: 'warn',
    ssr: { noExternal: /^(?!fast-png$|node:)/ },
    build: {
      ssr: true,
      outDir: join(folder, 'dist'),
      emptyOutDir: true,
      minify: false,
      target: 'node20',
      rolldownOptions: {
        input: {
          index: join(folder, 'src/index.ts'),
          child: join(folder, 'src/child.ts'),
          'volume-view-prepare': join(folder, 'src/volume-view-prepare.ts'),
        },
        external: ['fast-png'],
        output: { entryFileNames: '[name].js', chunkFileNames: 'parts/[name]-[hash].js' },
      },
    },
  });
  for (const name of player)
    cpSync(join(folder, '../../dist', name), join(folder, 'dist/player', name), { recursive: true });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await buildPrepare();
