// `npm run accuracy -- claims`: the tests that leave cases out (see test/helpers/cases.ts), with all of their cases.
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';

/** @param {{ quick: boolean }} options - quick: only the cases that the tests take, too */
export async function run({ quick }) {
  const env = { ...process.env, VOLUME_VIEW_ALL_CASES: quick ? '' : '1' };
  const files = readdirSync(join(projectRoot, 'test'), { recursive: true, encoding: 'utf8' })
    .map((name) => `test/${name.replaceAll('\\', '/')}`)
    .filter(
      (name) =>
        name.endsWith('.test.ts') &&
        /\/helpers\/cases\.ts'|\bwalksOf\b/.test(readFileSync(join(projectRoot, name), 'utf8')),
    );
  const inNode = files.filter((name) => name.startsWith('test/unit/'));
  const inBrowser = files.filter((name) => !inNode.includes(name));
  const runs = [
    ...(inNode.length > 0 ? [['scripts/test-fast.mjs', ...inNode]] : []),
    ...(inBrowser.length > 0 ? [['node_modules/@web/test-runner/dist/bin.js', '--files', ...inBrowser]] : []),
  ];
  for (const args of runs) {
    const { status } = spawnSync(process.execPath, args, { cwd: projectRoot, env, stdio: 'inherit' });
    if (status !== 0) process.exitCode = 1;
  }
}
