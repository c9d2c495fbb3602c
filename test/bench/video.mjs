// `npm run bench -- video` (`SCANS=8`, of the radar): bytes of scans in time against their error, as PNG, WebP, VP9 and AV1. It needs ffmpeg, runs in Node, and its numbers do
// not depend on a clock.
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'vite';
import { projectRoot, sharedDataFolder } from '../../scripts/shared-data.mjs';
import { printTable } from './table.mjs';

/** @returns {Promise<typeof import('./video/compare-forms.ts')>} */
async function load() {
  const folder = mkdtempSync(join(projectRoot, 'node_modules/.bench-video-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  await build({
    configFile: false,
    root: projectRoot,
    publicDir: false,
    logLevel: 'warn',
    ssr: { noExternal: true },
    build: {
      ssr: true,
      outDir: folder,
      minify: false,
      target: 'node20',
      rolldownOptions: {
        input: { forms: join(projectRoot, 'test/bench/video/compare-forms.ts') },
        output: { entryFileNames: '[name].mjs' },
      },
    },
  });
  return import(pathToFileURL(join(folder, 'forms.mjs')).href);
}

const series = join(sharedDataFolder, 'radar/odim_behel_series');
/** @type {{ name: string, paths: () => string[], needsShared?: boolean, unit: string }[]} */
const scenes = [
  {
    name: 'radar: reflectivity, scans of the Belgian radar Helchteren',
    paths: () =>
      readdirSync(series)
        .filter((name) => name.includes('dbzh'))
        .slice(0, Number(process.env.SCANS ?? 8))
        .map((name) => join(series, name)),
    needsShared: true,
    unit: 'dBZ',
  },
  {
    name: 'functional MRI, 17 x 21 x 3 voxels',
    paths: () => [join(projectRoot, 'demos/data/functional.nii')],
    unit: '',
  },
];

const { compareForms } = await load();
for (const { name, paths, needsShared, unit } of scenes) {
  if (needsShared && !existsSync(series)) {
    console.log(`${name}: left out, the shared data are not here`);
    continue;
  }
  const files = paths();
  const results = await compareForms(files);
  const png = results[0].bytes;
  printTable(
    `${name}: kilobytes of all scans, and the error in ${unit || 'values'}`,
    results.map(({ form, bytes, error, picture }) => ({
      form,
      kB: (bytes / 1000).toFixed(1),
      'of PNG': (bytes / png).toFixed(2),
      rms: error.rms.toPrecision(2),
      p99: error.p99.toPrecision(2),
      max: error.max.toPrecision(2),
      'picture, rms, 1/255': picture.toFixed(2),
    })),
  );
}
