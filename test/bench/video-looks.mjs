// `npm run bench -- video-looks` (`QUALITIES=24,36,45`): what a video loses in a picture in other looks than that in which the loss was measured: as an
// element states it, and what is true. It needs ffmpeg, runs in Node, and its numbers do not depend on a clock.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { sharedDataFolder } from '../../scripts/shared-data.mjs';
import { loadModule } from './load-module.mjs';
import { printTable } from './table.mjs';

const scenes = {
  'MRI, 33 x 41 x 25': 'medical/nibabel_4d/anatomical.nii',
  'CT of a stent': 'medical/stent_nrrd/stent.nrrd',
  'Radar, reflectivity': 'radar/odim_behel_series/20200207130000.rad.behel.pvol.dbzh.scanz.hdf',
};

export async function run() {
  /** @type {typeof import('./video/compare-looks.ts')} */
  const { compareLooks } = await loadModule('test/bench/video/compare-looks.ts');
  /** @type {number[]} */
  const ratios = [];
  for (const [title, name] of Object.entries(scenes)) {
    const path = join(sharedDataFolder, name);
    if (!existsSync(path)) {
      console.log(`${title}: left out, the shared data are not here\n`);
      continue;
    }
    const qualities = (process.env.QUALITIES ?? '24,36,45').split(',');
    /** @type {Map<string, Record<string, string>>} */
    const rows = new Map();
    for (const quality of qualities)
      for (const { look, known, stated } of await compareLooks(path, Number(quality))) {
        ratios.push(stated / known);
        const row = rows.get(look) ?? { look };
        row[`crf ${quality}: true`] = known.toPrecision(3);
        row[`crf ${quality}: stated / true`] = (stated / known).toFixed(2);
        rows.set(look, row);
      }
    printTable(`${title}: root mean square, 1/255`, [...rows.values()]);
  }
  ratios.sort((a, b) => a - b);
  const good = ratios.filter((ratio) => ratio > 0.5 && ratio < 2).length;
  console.log(
    `stated / true: ${[0, 0.5, 1].map((at) => ratios[Math.round(at * (ratios.length - 1))]?.toFixed(2)).join(', ')} (least, median, most); ${good} of ${ratios.length} within a factor of two`,
  );
}
