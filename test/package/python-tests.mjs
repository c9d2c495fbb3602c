// The Python tests of a package: in the Python of VOLUME_VIEW_PYTHON, else in a virtual environment that is made for them.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';

/**
 * @param {string} name - a folder of `packages`, with `src` and `tests`
 * @param {string[]} packages - what the tests need, in the versions that they were written with: a new one of another project must not
 *   change what they say
 * @param {number} timeout - of each step, ms
 * @returns {((...options: string[]) => { status: number | null, stderr: string }) | null} runs the tests; null where there is no Python,
 *   or its packages can not be had
 */
export function preparePythonTests(name, packages, timeout) {
  const folder = join(projectRoot, 'packages', name);
  const work = mkdtempSync(join(tmpdir(), 'volume-view-python-'));
  process.on('exit', () => rmSync(work, { recursive: true, force: true }));
  /** @param {string} program @param {string[]} args */
  const run = (program, args) =>
    spawnSync(program, args, {
      cwd: folder,
      encoding: 'utf8',
      timeout,
      env: { ...process.env, PYTHONPATH: join(folder, 'src'), PYTHONDONTWRITEBYTECODE: '1', PYTHONWARNINGS: 'ignore' },
    });
  const findPython = () => {
    const given = process.env.VOLUME_VIEW_PYTHON;
    if (given) return given;
    const made = run('python3', ['-m', 'venv', join(work, 'venv')]);
    if (made.status !== 0) return null;
    const python = join(work, 'venv/bin/python');
    const installed = run(python, ['-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', ...packages]);
    return installed.status === 0 ? python : null;
  };
  const python = findPython();
  if (!python) return null;
  return (...options) => run(python, ['-m', 'unittest', 'discover', ...options, 'tests']);
}
