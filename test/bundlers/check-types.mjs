// The types of the tags: what is right passes, and each line that is marked as wrong is refused.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';

/**
 * @param {string} folder - with a tsconfig.json, below the packages that its files import
 * @param {string} name - of the file with the marks
 */
export function checkTypes(folder, name) {
  const { stdout } = spawnSync(
    process.execPath,
    [join(projectRoot, 'node_modules/typescript/bin/tsc'), '-p', folder, '--pretty', 'false'],
    { cwd: folder, encoding: 'utf8' },
  );
  const found = [...stdout.matchAll(/^(\S+)\((\d+),\d+\): error/gm)].map(([, file, line]) => `${file}:${line}`);
  const lines = readFileSync(join(folder, name), 'utf8').split('\n');
  const expected = lines.flatMap((line, index) => (line.includes('// wrong:') ? [`${name}:${index + 1}`] : []));
  assert.ok(expected.length > 2);
  assert.deepEqual([...new Set(found)], expected, stdout);
  return `${expected.length} lines refused`;
}
