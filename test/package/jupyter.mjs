// The widget for notebooks: its Python tests.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { buildJupyter } from '../../scripts/build-jupyter.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { finish } from './checks.mjs';
import { checkPython } from './python-tests.mjs';

const packages = [
  ...['anywidget==0.11.0', 'numpy==2.4.6', 'nibabel==5.4.2', 'pydicom==3.0.2', 'SimpleITK==2.5.7', 'xarray==2026.9.0'],
];

if (existsSync(join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js'))) buildJupyter();
await checkPython(
  'the Python tests of the widget for notebooks pass, and none is left out',
  { name: 'jupyter', packages, timeout: 400_000 },
  (run) => {
    const { status, stderr } = run();
    assert.equal(status, 0, stderr);
    assert.doesNotMatch(stderr, /skipped/);
    return /Ran \d+ tests/.exec(stderr)?.[0] ?? '';
  },
);
finish();
