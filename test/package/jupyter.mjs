// The widget for notebooks: its Python tests, in the Python of VOLUME_VIEW_PYTHON, else in a virtual environment that is made for them. Where
// there is no Python, or its packages can not be had, that is said.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { buildJupyter } from '../../scripts/build-jupyter.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

const folder = join(projectRoot, 'packages/jupyter');
const work = mkdtempSync(join(tmpdir(), 'volume-view-python-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));

/** What the tests need, in the versions that they were written with: a new one of another project must not change what they say. */
const packages = [
  ...['anywidget==0.11.0', 'numpy==2.4.6', 'nibabel==5.4.2', 'pydicom==3.0.2', 'SimpleITK==2.5.7', 'xarray==2026.9.0'],
];

/** @param {string} program @param {string[]} args */
const run = (program, args) =>
  spawnSync(program, args, {
    cwd: folder,
    encoding: 'utf8',
    timeout: 180_000,
    env: { ...process.env, PYTHONPATH: join(folder, 'src'), PYTHONDONTWRITEBYTECODE: '1', PYTHONWARNINGS: 'ignore' },
  });

/** @returns {string | null} a Python that has the packages */
function findPython() {
  const given = process.env.VOLUME_VIEW_PYTHON;
  if (given) return given;
  const made = run('python3', ['-m', 'venv', join(work, 'venv')]);
  if (made.status !== 0) return null;
  const python = join(work, 'venv/bin/python');
  const installed = run(python, ['-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', ...packages]);
  return installed.status === 0 ? python : null;
}

if (existsSync(join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js'))) buildJupyter();
const python = findPython();
if (!python)
  console.log(
    'left out: the tests of the widget for notebooks; there is no Python 3 with venv, or its packages can not be had',
  );
else
  await check('the Python tests of the widget for notebooks pass, and none is left out', () => {
    const { status, stderr } = run(python, ['-m', 'unittest', 'discover', 'tests']);
    assert.equal(status, 0, stderr);
    assert.doesNotMatch(stderr, /skipped/);
    return /Ran \d+ tests/.exec(stderr)?.[0] ?? '';
  });
finish();
