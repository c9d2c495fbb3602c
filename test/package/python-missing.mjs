// What the Python parts say where their tests can not run, with a Python that is a script of this test.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

const folder = mkdtempSync(join(tmpdir(), 'volume-view-no-python-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
const python = join(folder, 'python3');
/** Called as `python3 -m venv FOLDER`, `python -m pip …` and `python -m unittest …`. @param {Record<'venv' | 'pip' | 'unittest', string>} steps */
function writePython({ venv, pip, unittest }) {
  const make = 'mkdir -p "$3/bin" && cp "$0" "$3/bin/python"';
  const cases = `venv) ${venv || make};; pip) ${pip};; unittest) ${unittest};;`;
  writeFileSync(python, `#!/bin/sh\ncase "$2" in ${cases} esac\n`);
  chmodSync(python, 0o755);
}

const program = `
  import { checkPython } from ${JSON.stringify(join(projectRoot, 'test/package/python-tests.mjs'))};
  import { finish } from ${JSON.stringify(join(projectRoot, 'test/package/checks.mjs'))};
  const tests = { name: 'archive', packages: ['x==1'], timeout: 2000 };
  await checkPython('the tests of x pass', tests, (run) => {
    const { status, stderr } = run();
    if (status !== 0) throw new Error(stderr.trim());
    return stderr.trim();
  });
  finish();`;
/** @param {string} CI */
function runPart(CI) {
  const { VOLUME_VIEW_PYTHON: _, ...env } = process.env;
  const { stdout, status } = spawnSync(process.execPath, ['--input-type=module', '--eval', program], {
    encoding: 'utf8',
    env: { ...env, CI, PATH: [folder, env.PATH].join(delimiter) },
  });
  return { stdout, status };
}

await check('with its packages the tests run, and count', () => {
  writePython({ venv: '', pip: 'exit 0', unittest: 'echo Ran 3 tests >&2' });
  assert.deepEqual(runPart('true'), {
    stdout: 'ok: the tests of x pass (Ran 3 tests)\n1 passed, 0 failed\n',
    status: 0,
  });
  writePython({ venv: '', pip: 'exit 0', unittest: 'echo one is wrong >&2; exit 1' });
  assert.deepEqual(runPart(''), {
    stdout: 'FAILED: the tests of x pass\none is wrong\n0 passed, 1 failed\n',
    status: 1,
  });
});

await check('packages that pip can not have fail in CI, and are left out elsewhere', () => {
  writePython({ venv: '', pip: 'echo no answer >&2; exit 1', unittest: 'exit 0' });
  const words = 'pip can not have its packages: no answer';
  assert.deepEqual(runPart('true'), {
    stdout: `FAILED: the tests of x pass\n${words}\n0 passed, 1 failed\n`,
    status: 1,
  });
  assert.deepEqual(runPart(''), { stdout: `left out: the tests of x pass; ${words}\n0 passed, 0 failed\n`, status: 0 });
});

await check('so do packages that come too late', () => {
  writePython({ venv: '', pip: 'exec sleep 20', unittest: 'exit 0' });
  const { stdout, status } = runPart('true');
  assert.match(
    stdout,
    /^FAILED: .*\npip can not have its packages: ended by SIGKILL, at the latest after 2 s\n0 passed, 1 failed\n$/,
  );
  assert.equal(status, 1);
  writePython({ venv: 'exec sleep 20', pip: 'exit 0', unittest: 'exit 0' });
  assert.match(runPart('true').stdout, /there is no Python 3 with venv in time\n0 passed, 1 failed\n$/);
});

await check('where there is no Python with venv, the tests are left out, also in CI', () => {
  writePython({ venv: 'exit 1', pip: 'exit 0', unittest: 'exit 0' });
  const words = 'left out: the tests of x pass; there is no Python 3 with venv\n0 passed, 0 failed\n';
  assert.deepEqual(runPart('true'), { stdout: words, status: 0 });
});
finish();
