// Apps that use the package as npm gives it, one for each bundler and framework: built, served and looked at in Chromium.
// `npm run test:bundlers [-- --only vite,next]`. What they need is a package of its own, which is installed here alone.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs, promisify } from 'node:util';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from '../package/checks.mjs';
import { apps } from './apps.mjs';
import { checkDocs } from './check-docs.mjs';
import { checkMessage } from './check-message.mjs';
import { checkPicture, closeBrowser, openApp } from './open-app.mjs';
import { checkTypes } from './check-types.mjs';
import { checkDevelopment } from './check-development.mjs';

const { values: options } = parseArgs({
  options: { only: { type: 'string' }, keep: { type: 'boolean', default: false } },
});
const here = join(projectRoot, 'test/bundlers');
const built = join(here, 'dist');
const chosen = apps.filter(({ name }) => !options.only || options.only.split(',').includes(name));

/** @param {number} start */
const secondsSince = (start) => `${((Date.now() - start) / 1000).toFixed(1)} s`;

/**
 * Run a program; throws what it wrote where it ends badly.
 * @param {string} program @param {string[]} args @param {string} cwd
 */
async function run(program, args, cwd) {
  const env = {
    ...process.env,
    CI: 'true',
    NO_COLOR: '1',
    FORCE_COLOR: '0',
    NEXT_TELEMETRY_DISABLED: '1',
    PARCEL_WORKERS: '1',
  };
  try {
    const { stdout } = await promisify(execFile)(program, args, {
      cwd,
      env,
      shell: process.platform === 'win32',
      maxBuffer: 1 << 26,
    });
    return stdout;
  } catch (error) {
    const { stdout, stderr, message } = /** @type {{ stdout?: string, stderr?: string, message: string }} */ (error);
    throw new Error(`${message}\n${stdout ?? ''}\n${stderr ?? ''}`.slice(0, 4000), { cause: error });
  }
}

/** The package as it would be published, and beside it what it needs, as this folder's lockfile has it. */
async function install() {
  await run('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], here);
  rmSync(built, { recursive: true, force: true });
  mkdirSync(built);
  const packed = await run('npm', ['pack', '--json', '--ignore-scripts', '--pack-destination', built], projectRoot);
  const [{ filename }] = Object.values(JSON.parse(packed)); // an array, or from npm 12 on an object by name
  const installed = join(here, 'node_modules/volume-view');
  rmSync(installed, { recursive: true, force: true });
  mkdirSync(installed);
  await run('tar', ['-xzf', join(built, filename), '-C', installed, '--strip-components=1'], here);
}

/** @param {import('./apps.mjs').App} app */
async function buildApp({ name, from = name, command }) {
  const folder = join(built, name);
  cpSync(join(here, 'apps', from), folder, { recursive: true });
  const [program, ...args] = command.split(' ');
  await run(join(here, 'node_modules/.bin', program), args, folder);
}

await check('the apps are installed, with the package from its tarball', async () => {
  const own = JSON.parse(readFileSync(join(projectRoot, 'package.json'), 'utf8'));
  const apart = JSON.parse(readFileSync(join(here, 'package.json'), 'utf8'));
  assert.deepEqual(
    apart.dependencies,
    own.dependencies,
    'test/bundlers/package.json depends on what the package depends on',
  );
  assert.doesNotMatch(readFileSync(join(here, 'package-lock.json'), 'utf8'), /"resolved": *"http/);
  const start = Date.now();
  if (!options.keep) await install();
  return secondsSince(start);
});

// While one app is looked at, the next ones are built.
let building = Promise.resolve('');
const builds = chosen.map((app) => {
  const own = building.then(async () => {
    const start = Date.now();
    await buildApp(app);
    return secondsSince(start);
  });
  building = own.catch(() => '');
  return { app, own };
});
for (const { app, own } of builds) {
  const folder = join(built, app.name, app.serve);
  await check(`${app.name} builds: ${app.command}`, () => own);
  await check(`${app.name} shows the volume, and finds its parts`, () =>
    openApp(folder, async (open) => {
      const start = Date.now();
      const remark = await checkPicture(open);
      await app.look?.(open);
      return `${remark}, ${secondsSince(start)}`;
    }),
  );
  if (app.message) await check(`${app.name}: the message of x3dom says where to put it`, () => checkMessage(folder));
}
if (chosen.some(({ name }) => name === 'vite')) {
  await check('vite shows the volume while it is developed: vite', () => checkDevelopment(join(built, 'vite')));
}
await closeBrowser();
if (!options.only) {
  await check('types of the tags in JSX: what is wrong is refused', () =>
    checkTypes(join(built, 'react'), 'wrong.tsx'),
  );
  await check('types of the tags in Vue: what is wrong is refused', () => checkTypes(join(built, 'vue'), 'tags.ts'));
  await check('types of the elements in Angular: what is wrong is refused', () =>
    checkTypes(join(built, 'angular'), 'wrong.ts'),
  );
  await check('the docs show what was built', checkDocs);
}
finish();
