// The archive of many scans: its Python tests.
import assert from 'node:assert/strict';
import { finish } from './checks.mjs';
import { checkPython } from './python-tests.mjs';

const packages = [
  ...['distributed==2026.8.0', 'fsspec==2026.9.0', 'pydicom==3.0.2', 's3fs==2026.9.0', 'boto3==1.43.117'],
  ...['moto[server]==5.2.5', 'pystac==1.15.2', 'jsonschema==4.26.0'],
];

await checkPython('the Python tests of the archive pass', { name: 'archive', packages, timeout: 400_000 }, (run) => {
  const { status, stderr } = run('-v');
  assert.equal(status, 0, stderr);
  // Where nobody may mount a small disk, that test is left out, and that is said.
  return [/Ran \d+ tests/.exec(stderr)?.[0], ...(stderr.match(/skipped .*/g) ?? [])].join('; ');
});
finish();
