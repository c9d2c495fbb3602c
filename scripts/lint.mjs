// `npm run lint`: oxlint with the compiler's types, and whether the formatter would change a file. Further arguments (files)
// are passed on to oxlint; `--fix` also formats.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/** @param {string} tool - its name in node_modules @param {readonly string[]} args @returns {boolean} whether it found nothing */
function run(tool, args) {
  const path = join(projectRoot, 'node_modules', tool, 'bin', tool);
  return spawnSync(process.execPath, [path, ...args], { cwd: projectRoot, stdio: 'inherit' }).status === 0;
}

const given = process.argv.slice(2);
const isFormatted = run('oxfmt', [given.includes('--fix') ? '--write' : '--check', projectRoot]);
if (!isFormatted) console.log('The formatter would change the files above. Run: npm run format');
const isClean = run('oxlint', ['--type-aware', '--deny-warnings', ...given]);
process.exitCode = isFormatted && isClean ? 0 : 1;
