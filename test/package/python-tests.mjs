// The Python tests of a package: in the Python of VOLUME_VIEW_PYTHON, else in a virtual environment that is made for them.
import { spawnSync } from 'node:child_process';
import { closeSync, mkdtempSync, openSync, readFileSync, rmSync } from 'node:fs';
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
  const run = (program, args) => {
    // A file, not a pipe: a process that outlives its parent would hold a pipe open, and this call would never end.
    const said = openSync(join(work, 'said.txt'), 'w');
    const { status, signal } = spawnSync(program, args, {
      cwd: folder,
      stdio: ['ignore', 'ignore', said],
      timeout,
      killSignal: 'SIGKILL',
      env: {
        ...process.env,
        PYTHONPATH: join(folder, 'src'),
        // Nothing is left in the checkout, and what is imported is compiled once, also where the machine asks Python not to keep that.
        PYTHONPYCACHEPREFIX: join(work, 'compiled'),
        PYTHONDONTWRITEBYTECODE: '',
        PYTHONWARNINGS: 'ignore',
      },
    });
    closeSync(said);
    const late = signal ? `\nended by ${signal}, at the latest after ${timeout / 1000} s` : '';
    return { status, stderr: readFileSync(join(work, 'said.txt'), 'utf8') + late };
  };
  const findPython = () => {
    const given = process.env.VOLUME_VIEW_PYTHON;
    if (given) return given;
    const made = run('python3', ['-m', 'venv', join(work, 'venv')]);
    if (made.status !== 0) return null;
    const python = join(work, 'venv/bin/python');
    // Of all that the packages have, the tests import little: without --no-compile, compiling the rest takes 24 of 61 seconds of a processor.
    const options = ['--quiet', '--disable-pip-version-check', '--no-compile'];
    const installed = run(python, ['-m', 'pip', 'install', ...options, ...packages]);
    return installed.status === 0 ? python : null;
  };
  const python = findPython();
  if (!python) return null;
  return (...options) => run(python, ['-m', 'unittest', 'discover', ...options, 'tests']);
}
