// `npm run build` in packages/prepare: builds the program and its modules, from TypeScript and the readers of the element, as JavaScript for
// Node.
import { cpSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { licencesOfModules } from './licence-texts.mjs';
import { playerFiles } from './player-files.mjs';
import { projectRoot } from './shared-data.mjs';

const folder = join(projectRoot, 'packages/prepare');

/** Build the folder dist; the element has been built before. @returns {Promise<void>} */
export async function buildPrepare() {
  /** @type {string[]} */
  const modules = [];
  await build({
    configFile: false,
    root: folder,
    publicDir: false,
    logLevel: 'warn',
    plugins: [
      {
        name: 'list-modules',
        generateBundle: (_options, files) => {
          for (const file of Object.values(files)) if (file.type === 'chunk') modules.push(...file.moduleIds);
        },
      },
    ],
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
  writeFileSync(join(folder, 'dist/THIRD-PARTY-LICENSES.txt'), licencesOfModules(modules));
  for (const name of playerFiles)
    cpSync(join(projectRoot, 'dist', name), join(folder, 'dist/player', name), { recursive: true });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await buildPrepare();
