import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';

/**
 * The checkout's files of a kind, with those that are not yet committed.
 * @param {RegExp} kind - of their paths
 * @returns {string[]} relative to the project's root
 */
export function listCode(kind) {
  const git = spawnSync('git', ['ls-files', '--cached', '--others', '--exclude-standard'], {
    cwd: projectRoot,
    encoding: 'utf8',
  });
  assert.equal(git.status, 0, `git ls-files: ${git.stderr}`);
  return git.stdout.split('\n').filter((path) => kind.test(path) && existsSync(join(projectRoot, path)));
}
