// The build, as a part of `npm test`: a page that is served from dist finds its files while dist is built.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

const dist = join(projectRoot, 'dist');
const files = ['volume-view.js', 'volume-view.iife.js', 'x3dom.js', 'decode-worker.js', 'embed.html'].map((name) =>
  join(dist, name),
);

/** The text of a file where nothing has been built before. */
const standIn = '// This file waits for the build.\n';
const isFirst = !files.every(existsSync);
if (isFirst) {
  mkdirSync(dist, { recursive: true });
  for (const file of files) writeFileSync(file, standIn);
}

const build = spawn(process.execPath, ['scripts/build.mjs'], { cwd: projectRoot, stdio: 'inherit' });
let [looks, gaps] = [0, 0];
while (build.exitCode === null && build.signalCode === null) {
  looks += 1;
  if (!files.every(existsSync)) gaps += 1;
  await wait(20);
}
await check('the package is built', () => assert.equal(build.exitCode, 0));
if (build.exitCode !== 0 && isFirst) rmSync(dist, { recursive: true });

await check('dist is whole while it is built again, and the build leaves nothing next to it', () => {
  assert.ok(looks > 50, `${looks} looks`);
  assert.ok(gaps <= 1, `${gaps} of ${looks} looks found files missing`); // One may fall between the two renames.
  for (const file of files) assert.notEqual(readFileSync(file, 'utf8'), standIn, `${file} is new`);
  assert.deepEqual(
    readdirSync(projectRoot).filter((name) => name.startsWith('dist-')),
    [],
  );
  return `${looks} looks`;
});
finish();
