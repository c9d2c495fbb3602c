// `npm run bench -- video` (`SCENES=radar,mri SCANS=8`, of the radar): bytes of scans in time against their error, as PNG, WebP, VP9 and AV1. It needs
// ffmpeg, runs in Node, and its numbers do not depend on a clock.
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot, sharedDataFolder } from '../../scripts/shared-data.mjs';
import { loadModule } from './load-module.mjs';
import { printTable } from './table.mjs';

const series = join(sharedDataFolder, 'radar/odim_behel_series');

/** @type {Readonly<Record<string, { title: string, unit: string, paths: () => string[] }>>} */
const scenes = {
  radar: {
    title: 'Reflectivity of the Belgian radar Helchteren',
    unit: 'dBZ',
    paths: () =>
      (existsSync(series) ? readdirSync(series) : [])
        .filter((name) => name.includes('dbzh'))
        .slice(0, Number(process.env.SCANS ?? 8))
        .map((name) => join(series, name)),
  },
  mri: {
    title: 'Functional MRI, 17 x 21 x 3 voxels',
    unit: 'values',
    paths: () => [join(projectRoot, 'demos/data/functional.nii')],
  },
};

export async function run() {
  /** @type {typeof import('./video/compare-forms.ts')} */
  const { compareForms } = await loadModule('test/bench/video/compare-forms.ts');
  for (const name of process.env.SCENES?.split(',') ?? Object.keys(scenes)) {
    const { title, unit, paths } = scenes[name];
    const files = paths();
    if (files.length === 0) {
      console.log(`${title}: left out, the shared data are not here\n`);
      continue;
    }
    const results = await compareForms(files);
    const [{ bytes: png }] = results;
    printTable(
      `${title}: kilobytes of all scans, and the error in ${unit}`,
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
}
