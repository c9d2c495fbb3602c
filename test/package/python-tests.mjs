// The Python tests of a package: in the Python of VOLUME_VIEW_PYTHON, else in a virtual environment that is made for them. Where there is no Python,
// that is said, and nothing fails. Packages that pip can not have in time are left out on a developer's machine, and fail in CI, which has a registry:
// else a run would pass without these tests.
import { spawnSync } from 'node:child_process';
import { closeSync, mkdtempSync, openSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check } from './checks.mjs';

/** @typedef {(...options: string[]) => { status: number | null, stderr: string }} Run - the tests, with options of unittest */

/**
 * One check: the Python tests of a package.
 * @param {string} title
 * @param {object} tests
 * @param {string} tests.name - a folder of `packages`, with `src` and `tests`
 * @param {string[]} tests.packages - what the tests need, in the versions that they were written with: a new one of another project must not
 *   change what they say
 * @param {number} tests.timeout - of each step, ms
 * @param {(run: Run) => string} body - runs the tests; throws where they fail, and may return a remark
 */
export async function checkPython(title, tests, body) {
  const { run, missing, isFault } = prepare(tests);
  if (run) await check(title, () => body(run));
  else if (isFault && process.env.CI) await check(title, () => Promise.reject(new Error(missing)));
  else console.log(`left out: ${title}; ${missing}`);
}

/**
 * @param {{ name: string, packages: string[], timeout: number }} tests
 * @returns {{ run?: Run, missing?: string, isFault?: boolean }} `missing`: why there is nothing to run; `isFault`: there is a Python, but it was too slow, or pip failed
 */
function prepare({ name, packages, timeout }) {
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
    return { status, stderr: readFileSync(join(work, 'said.txt'), 'utf8') + late, isLate: signal !== null };
  };
  const tryTests =
    (/** @type {string} */ python) =>
    (/** @type {string[]} */ ...options) =>
      run(python, ['-m', 'unittest', 'discover', ...options, 'tests']);
  const given = process.env.VOLUME_VIEW_PYTHON;
  if (given) return { run: tryTests(given) };
  const made = run('python3', ['-m', 'venv', join(work, 'venv')]);
  if (made.status !== 0)
    return { missing: `there is no Python 3 with venv${made.isLate ? ' in time' : ''}`, isFault: made.isLate };
  const python = join(work, 'venv/bin/python');
  // Of all that the packages have, the tests import little: without --no-compile, compiling the rest takes 24 of 61 seconds of a processor.
  const options = ['--quiet', '--disable-pip-version-check', '--no-compile'];
  const installed = run(python, ['-m', 'pip', 'install', ...options, ...packages]);
  if (installed.status === 0) return { run: tryTests(python) };
  return { missing: `pip can not have its packages: ${installed.stderr.trim().slice(-1000)}`, isFault: true };
}
