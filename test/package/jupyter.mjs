// The widget for notebooks: its Python tests. Where there is no Python, or its packages can not be had, that is said.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { buildJupyter } from '../../scripts/build-jupyter.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';
import { preparePythonTests } from './python-tests.mjs';

const packages = [
  ...['anywidget==0.11.0', 'numpy==2.4.6', 'nibabel==5.4.2', 'pydicom==3.0.2', 'SimpleITK==2.5.7', 'xarray==2026.9.0'],
];

if (existsSync(join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js'))) buildJupyter();
const run = preparePythonTests('jupyter', packages, 400_000);
if (!run)
  console.log(
    'left out: the tests of the widget for notebooks; there is no Python 3 with venv, or its packages can not be had',
  );
else
  await check('the Python tests of the widget for notebooks pass, and none is left out', () => {
    const { status, stderr } = run();
    assert.equal(status, 0, stderr);
    assert.doesNotMatch(stderr, /skipped/);
    return /Ran \d+ tests/.exec(stderr)?.[0] ?? '';
  });
finish();
