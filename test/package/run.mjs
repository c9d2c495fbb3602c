// The package as npm would publish it. `npm run test:package` builds it first; `npm test` has built it already.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  realpathSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { createContext, runInContext } from 'node:vm';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { measureBytes, measureClassic, sumOwnBytes } from '../bench/measure-bytes.mjs';
import { check, finish } from './checks.mjs';
import { checkShortShaders } from './short-shaders.mjs';
import { checkTagData } from './tag-data.mjs';

/**
 * Run a program of node_modules; returns what it wrote, throws it where the program ends badly.
 * @param {string} script
 * @param {string[]} args
 */
function runTool(script, args) {
  const options = {
    cwd: projectRoot,
    encoding: /** @type {const} */ ('utf8'),
    env: { ...process.env, NO_COLOR: '1', FORCE_COLOR: '0' },
  };
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    [join(projectRoot, 'node_modules', script), ...args],
    options,
  );
  assert.equal(status, 0, stdout + stderr);
  return stdout;
}

/** @param {string} path */
const read = (path) => readFileSync(join(projectRoot, path), 'utf8');
const manifest = JSON.parse(read('package.json'));

/** The tarball, unpacked, with this checkout's dependencies in reach. */
function unpack() {
  mkdirSync(installed, { recursive: true });
  const { status } = spawnSync('tar', ['-xzf', tarball, '-C', installed, '--strip-components=1']);
  assert.equal(status, 0, 'tar unpacks the package');
  symlinkSync(join(projectRoot, 'node_modules'), join(installed, 'node_modules'), 'junction');
}

/** @type {{ path: string, size: number }[]} */
let files = [];

// Packed once, into a folder of its own, as if a consumer had installed it there.
const consumer = realpathSync(mkdtempSync(join(tmpdir(), 'volume-view-consumer-')));
const installed = join(consumer, 'node_modules', manifest.name);
let tarball = '';

await check('npm pack finds every file that the package names', () => {
  // --ignore-scripts: npm would build again, and write the build's words into the JSON.
  const npm = spawnSync('npm', ['pack', '--json', '--ignore-scripts', '--pack-destination', consumer], {
    cwd: projectRoot,
    encoding: 'utf8',
    shell: process.platform === 'win32',
  });
  assert.equal(npm.status, 0, npm.stderr);
  const packs = Object.values(JSON.parse(npm.stdout)); // an array, or from npm 12 on an object by name
  files = packs[0].files;
  tarball = join(consumer, packs[0].filename);
  unpack();
  const paths = new Set(files.map((file) => file.path));
  const targets = Object.values(manifest.exports).flatMap((target) =>
    typeof target === 'string' ? [target] : Object.values(target),
  );
  const named = [
    ...targets,
    manifest.customElements,
    'README.md',
    'LICENSE',
    'dist/decode-worker.js',
    'dist/THIRD-PARTY-LICENSES.txt',
  ];
  const missing = named
    .map((path) => path.replace(/^\.\//, ''))
    .filter((path) => !path.includes('*') && !paths.has(path));
  assert.deepEqual(missing, []);
});

await check('npm pack leaves sources, tests and demos at home', () => {
  const allowed =
    /^(dist\/|schema\/|package\.json$|README\.md$|LICENSE$|CREDITS\.md$|custom-elements\.json$|vscode\.html-custom-data\.json$|web-types\.json$)/;
  assert.deepEqual(
    files.map((file) => file.path).filter((path) => !allowed.test(path)),
    [],
  );
});

await check('the colour tables are what their source gives', () => {
  const { status, stderr } = spawnSync(
    process.execPath,
    [join(projectRoot, 'scripts/make-color-tables.mjs'), '--check'],
    { encoding: 'utf8' },
  );
  assert.equal(status, 0, stderr);
});

await check('the map under radars is what its source gives', () => {
  const { status, stderr } = spawnSync(process.execPath, [join(projectRoot, 'scripts/make-map-data.mjs'), '--check'], {
    encoding: 'utf8',
  });
  assert.equal(status, 0, stderr);
});

await check('publint finds nothing', () => void runTool('publint/src/cli.js', ['--strict', tarball]));

await check('are-the-types-wrong finds nothing', () => {
  // The classic scripts and the style sheet have no module interface, hence no types.
  const scripts = [
    './volume-view.iife.js',
    './x3dom.js',
    './volume-view.css',
    './custom-elements.json',
    './vscode.html-custom-data.json',
    './web-types.json',
    './schema/manifest.json',
  ];
  runTool('@arethetypeswrong/cli/dist/index.js', [
    tarball,
    '--profile',
    'esm-only',
    '--exclude-entrypoints',
    ...scripts,
  ]);
});

await check('imports in Node, which has no DOM', () => {
  for (const name of [manifest.name, `${manifest.name}/volume-view.js`]) {
    const code = `if (globalThis.document) throw new Error('there is a DOM'); console.log(Object.keys(await import('${name}')).join())`;
    const { status, stdout, stderr } = spawnSync(process.execPath, ['--input-type=module', '-e', code], {
      cwd: consumer,
      encoding: 'utf8',
    });
    assert.equal(status, 0, stderr);
    assert.match(stdout, /\bVolumeView\b/, name);
  }
});

/** @param {string} path */
const load = (path) => import(pathToFileURL(join(projectRoot, path)).href);

await check(
  'every element has an entry that defines it and one that does not, by a pattern of the package',
  async () => {
    const tags = readdirSync(join(projectRoot, 'components')).filter(
      (name) => name !== 'internal' && existsSync(join(projectRoot, 'components', name, 'define.ts')),
    );
    const { elements } = await load('dist/esm/components/internal/elements.js');
    assert.deepEqual(
      new Set(tags),
      new Set([...Object.keys(elements), 'volume-view']),
      'a folder of components is a line of the table',
    );
    for (const tag of tags) {
      for (const path of [`${manifest.name}/${tag}.js`, `${manifest.name}/elements/${tag}.js`]) {
        const code = `console.log(import.meta.resolve('${path}'), Object.keys(await import('${path}')).join())`;
        const { status, stdout, stderr } = spawnSync(process.execPath, ['--input-type=module', '-e', code], {
          cwd: consumer,
          encoding: 'utf8',
        });
        assert.equal(status, 0, stderr);
        const className = stdout
          .trim()
          .split(' ')[1]
          .split(',')
          .find((name) => /^Volume[A-Z]\w+$/.test(name) && name !== 'VolumeViewError');
        assert.equal(className?.toLowerCase(), tag.replaceAll('-', ''), `${path} is ${stdout}`);
      }
      for (const file of [`dist/types/components/${tag}/define.d.ts`, `dist/types/components/${tag}/${tag}.d.ts`])
        assert.ok(existsSync(join(projectRoot, file)), file);
    }
    return `${tags.length} elements`;
  },
);

/** What a bundler keeps of a module that imports something of the package. @param {string} code */
async function bundle(code) {
  writeFileSync(join(consumer, 'entry.js'), code);
  const result = await build({
    root: consumer,
    configFile: false,
    logLevel: 'error',
    build: {
      write: false,
      minify: false,
      lib: { entry: 'entry.js', formats: ['es'] },
      rolldownOptions: { external: /^(lit|@shoelace)/ },
    },
  });
  const [{ output }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  return output
    .filter((part) => part.type === 'chunk')
    .map((part) => part.code)
    .join('\n');
}

const definesLegend = /define\("volume-legend"/;

await check('a class alone defines nothing, and is left out where it is not used', async () => {
  const used = await bundle(
    `import { VolumeLegend } from '${manifest.name}/elements/volume-legend.js'; console.log(VolumeLegend);`,
  );
  assert.match(used, /VolumeLegend = class/);
  assert.doesNotMatch(used, definesLegend);
  const unused = await bundle(
    `import { VolumeLegend } from '${manifest.name}/elements/volume-legend.js'; console.log(1);`,
  );
  assert.doesNotMatch(unused, /VolumeLegend/);
});

await check('an element imported alone is defined, without <volume-view>', async () => {
  const code = await bundle(`import '${manifest.name}/volume-legend.js';`);
  assert.match(code, definesLegend);
  assert.doesNotMatch(code, /VolumeView = class/);
});

await check('the version of the elements is that of the package', async () => {
  assert.equal((await load('dist/esm/components/internal/version.js')).version, manifest.version);
});

await check(
  "consumers' bundlers can see the worker and x3dom, and those that do not look for them next to the bundle",
  () => {
    // Beside the file that names them, hence beside the bundle where a bundler leaves the address as it is.
    assert.match(
      read('dist/create-worker.js'),
      /new Worker\(new URL\("\.\/decode-worker\.js", import\.meta\.url\), \{ type: "module" \}\)/,
    );
    assert.match(read('dist/x3dom-url.js'), /new URL\("\.\/x3dom\.js", import\.meta\.url\)/);
    const others = files.filter(
      ({ path }) =>
        path.startsWith('dist/esm/') &&
        path.endsWith('.js') &&
        read(path)
          .replace(/\/\*[^]*?\*\//g, '')
          .includes('import.meta.url'),
    );
    assert.deepEqual(others, []);
  },
);

await check('a bundler takes the worker and x3dom along', async () => {
  writeFileSync(join(consumer, 'index.html'), '<script type="module" src="./main.js"></script>');
  writeFileSync(join(consumer, 'main.js'), `import '${manifest.name}';`);
  await build({ root: consumer, configFile: false, logLevel: 'error' });
  const assets = readdirSync(join(consumer, 'dist/assets'));
  for (const name of ['decode-worker', 'x3dom'])
    assert.ok(
      assets.some((asset) => asset.startsWith(name)),
      `${name} is not in ${assets.join()}`,
    );
});

await check('x3dom is in no module and in no script but its own', () => {
  // The text is loaded where a bundler has left the file behind.
  const own = ['dist/x3dom.js', 'dist/esm/src/built/x3dom.js'];
  const holding = files.filter(
    (file) => file.path.endsWith('.js') && !own.includes(file.path) && read(file.path).includes('x3dom.X3DCanvas='),
  );
  assert.deepEqual(holding, []);
});

await check('declarations import .js, not .ts', () => {
  const wrong = files.filter(
    (file) => file.path.endsWith('.d.ts') && /(from|import)\s*\(?\s*['"]\.[^'"]*\.ts['"]/.test(read(file.path)),
  );
  assert.deepEqual(wrong, []);
});

await check('the custom-elements manifest describes <volume-view>', () => {
  const { modules } = JSON.parse(read(manifest.customElements));
  const names = modules.flatMap((/** @type {any} */ module) =>
    module.declarations.map((/** @type {any} */ one) => one.tagName),
  );
  assert.ok(names.includes('volume-view'));
});

await check('types and data for editors name all tags and attributes', checkTagData);

await check('shaders have shorter names inside of functions only, and each name stays one name', checkShortShaders);

await check('the lockfile and the settings name no registry', () => {
  for (const folder of ['', 'test/bundlers/']) {
    assert.doesNotMatch(read(`${folder}package-lock.json`), /"resolved": *"http/);
    assert.doesNotMatch(read(`${folder}.npmrc`), /registry *=/);
  }
});

rmSync(consumer, { recursive: true });

console.log('\nsize        gzipped  file');
for (const { path, size } of files.filter((file) => /^dist\/(chunks\/)?[^/]+\.js$/.test(file.path))) {
  const zipped = gzipSync(readFileSync(join(projectRoot, path)), { level: 9 }).length;
  console.log(`${String(size).padStart(8)} ${String(zipped).padStart(10)}  ${path}`);
}
// All that is loaded at once counts, and the worker's reader of NIfTI.
await check('all scripts are in ASCII: a page without a character set reads them right too', () => {
  const scripts = readdirSync(join(projectRoot, 'dist'), { recursive: true })
    .map(String)
    .filter((name) => name.endsWith('.js') && !name.startsWith('types'));
  assert.ok(scripts.length > 20);
  const others = scripts.filter((name) => /[^\0-\x7f]/.test(readFileSync(join(projectRoot, 'dist', name), 'utf8')));
  assert.deepEqual(others, []);
});

await check('the studio carries the licences of what is bundled into it', async () => {
  const text = readFileSync(join(projectRoot, 'packages/studio/dist/LICENSES.txt'), 'utf8');
  for (const library of ['lit', 'parse5', 'fast-png', 'fflate', 'CharLS', 'OpenJPEG'])
    assert.match(text, new RegExp(`^${library} .*\\((MIT|BSD-[23]-Clause)\\)`, 'm'), `the licence of ${library}`);
});

await check('our own code for a page with a NIfTI file is below 68.26 kB gzipped', async () => {
  const bytes = sumOwnBytes(await measureBytes());
  assert.ok(bytes < 68_260, `${bytes} bytes`);
  return `${bytes} bytes`;
});

await check(
  'the classic script for a page with a NIfTI file is below 77 kB gzipped: few parts of it come at once',
  () => {
    const [atOnce, worker] = measureClassic();
    const bytes = atOnce.gzipped + worker.gzipped;
    assert.ok(bytes < 77_000, `${bytes} bytes`);
    return `${bytes} bytes`;
  },
);

await check(
  "the classic script's worker for NIfTI makes a volume fit by itself, as each one has to in WebGL 1",
  async () => {
    const folder = join(projectRoot, 'dist/classic');
    const part = readdirSync(folder)
      .map((name) => readFileSync(join(folder, name), 'utf8'))
      .find((text) => text.includes('left out of this worker'));
    /** @type {Record<string, any>} */
    const world = createContext({
      fetch,
      Response,
      URL,
      TextDecoder,
      DecompressionStream,
      ReadableStream,
      DOMException,
      AbortController,
      performance,
      setTimeout,
      clearTimeout,
      console,
      location: { href: 'http://localhost/' },
      origin: 'http://localhost',
    });
    const reported = new Promise((resolve) => {
      world.postMessage = (/** @type {{ type: string }} */ message) =>
        ['ready', 'progress'].includes(message.type) || resolve(message);
    });
    // Where there is no document the part is the worker.
    world.self = world;
    runInContext(part ?? '', world);
    const url = `data:application/octet-stream;base64,${readFileSync(join(projectRoot, 'test/fixtures/nifti/v1-le-i2.nii')).toString('base64')}`;
    world.onmessage({ data: { request: { url }, pageOrigin: 'http://localhost' } });
    world.onmessage({ data: { limits: { maxVoxelsPerAxis: 3, maxAtlasSize: 4096, maxBytes: 2 ** 30 } } });
    const { type, message, volume } = await reported;
    assert.equal(type, 'done', message);
    assert.deepEqual([...volume.reduced.to], [3, 2, 3]);
  },
);

finish();
