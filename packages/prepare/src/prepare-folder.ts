import { mkdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { ChildPool } from './child-pool.ts';
import { findJobs } from './find-jobs.ts';
import type { FolderRequest, Output } from './folder-request.ts';
import { FolderWork } from './folder-work.ts';
import { Misuse } from './misuse.ts';
import { PrivateState } from './private-state.ts';
import { joinRadarScans } from './join-radar-scans.ts';
import { copyPlayer, copyScript, writeIndexPage } from './site-files.ts';
import { removeUnfinished, writeWhole } from './write-folder.ts';
import { isPackage } from './write-packages.ts';

/**
 * Makes a site of all volumes in a folder. A volume that was made before, and whose files have not changed, is left as it is.
 * @returns the exit status: 0, or 2 where some volumes could not be made
 */
export async function prepareFolder(request: FolderRequest, output: Output): Promise<number> {
  const folder = resolve(request.folder);
  const site = resolve(request.site);
  const state = new PrivateState(`${site}.private`);
  if (state.watched)
    throw new Misuse(
      'got the site of a run with --watch, which removes old scans; expected another --out for a run without it',
    );
  mkdirSync(site, { recursive: true });
  await removeUnfinished(site);
  const found = await findJobs(folder, { without: [site, state.folder] }, state, (done, all) =>
    output.progress(`looked at ${done} of ${all} files`),
  );
  const pool = new ChildPool(request.child, request.timeout);
  const work = new FolderWork(request, { folder, site, state, pool, output });
  try {
    for (const { key, ...line } of found.bad) work.report(key, [line], false);
    const sources =
      request.options.as === 'video'
        ? joinRadarScans(folder, found.sources, await work.lookAtRadars(found.sources))
        : found.sources;
    for (const phase of [0, 1, 2]) await work.runAll(sources.filter(({ source }) => source.phase === phase));
  } finally {
    pool.close();
  }
  await writeIndexPage(site, work.done);
  await writeWhole(state.folder, 'scans.tsv', work.table.map((row) => `${row}\n`).join(''));
  const { as } = request.options;
  if (as === 'embed') await copyPlayer(site, request.player);
  else if (!isPackage(as)) await copyScript(site, request.player);
  await state.compact(found.files, work.keys);
  state.unlock();
  output.progress('');
  const others = found.others + work.others;
  const left = [
    found.images > 0 ? `${found.images} images without a manifest, of which nobody knows what they hold` : '',
    others > 0 ? `${others} files that hold no volume` : '',
  ].filter(Boolean);
  output.say(
    `${work.counts.done} made, ${work.counts.unchanged} unchanged, ${work.counts.failed} failed${left.length > 0 ? `; left out: ${left.join(', ')}` : ''}. ` +
      `${site} is for the web server. ${state.folder} is not: it knows the names of files, also of those that failed (scans.tsv).`,
  );
  return work.counts.failed > 0 ? 2 : 0;
}
