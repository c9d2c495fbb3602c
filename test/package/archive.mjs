// The archive of many scans: its Python tests, in the Python of VOLUME_VIEW_PYTHON, else in a virtual environment that is made for them. Where
// there is no Python, or its packages can not be had, that is said.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

const folder = join(projectRoot, 'packages/archive');
const work = mkdtempSync(join(tmpdir(), 'volume-view-python-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));

/** What the tests need, in the versions that they were written with: a new one of another project must not change what they say. */
const packages = [
  ...['distributed==2026.8.0', 'fsspec==2026.9.0', 'pydicom==3.0.2', 's3fs==2026.9.0', 'boto3==1.43.117'],
  ...['moto[server]==5.2.5', 'pystac==1.15.2', 'jsonschema==4.26.0'],
];

/** @param {string} program @param {string[]} args */
const run = (program, args) =>
  spawnSync(program, args, {
    cwd: folder,
    encoding: 'utf8',
    timeout: 600_000,
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

const python = findPython();
if (!python)
  console.log('left out: the tests of the archive; there is no Python 3 with venv, or its packages can not be had');
else
  await check('the Python tests of the archive pass', () => {
    const { status, stderr } = run(python, ['-m', 'unittest', 'discover', '-v', 'tests']);
    assert.equal(status, 0, stderr);
    // Where nobody may mount a small disk, that test is left out, and that is said.
    return [/Ran \d+ tests/.exec(stderr)?.[0], ...(stderr.match(/skipped .*/g) ?? [])].join('; ');
  });
finish();
