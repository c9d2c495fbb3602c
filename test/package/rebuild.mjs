// A page that is served from dist finds its files while dist is built again.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

const files = ['volume-view.js', 'volume-view.iife.js', 'x3dom.js', 'decode-worker.js', 'embed.html'].map((name) =>
  join(projectRoot, 'dist', name),
);

await check('dist is whole while it is built again, and the build leaves nothing beside it', async () => {
  assert.ok(files.every(existsSync), 'dist is built');
  const build = spawn(process.execPath, ['scripts/build.mjs'], { cwd: projectRoot, stdio: 'ignore' });
  let [looks, gaps] = [0, 0];
  while (build.exitCode === null && build.signalCode === null) {
    looks += 1;
    if (!files.every(existsSync)) gaps += 1;
    await wait(20);
  }
  assert.equal(build.exitCode, 0);
  assert.ok(looks > 50, `${looks} looks`);
  assert.ok(gaps <= 1, `${gaps} of ${looks} looks found files missing`); // One may fall between the two renames.
  assert.deepEqual(
    readdirSync(projectRoot).filter((name) => name.startsWith('dist-')),
    [],
  );
  return `${looks} looks`;
});
finish();
