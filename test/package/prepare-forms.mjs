// `volume-view-prepare FOLDER --out SITE --as FORM` in each form: what is written, what the pages show in a browser beside the picture of the
// original file, and what is left when the program is ended at any moment. `--kills 50` ends it more often; `--forms mosaic,cmi5` tries these;
// `--pictures FOLDER` keeps the pictures of the pages.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import {
  copyFileSync,
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { encode } from 'fast-png';
import { unzipSync } from 'fflate';
import { findBrowser, listTestArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';
import { openLessonPage, pictureOf, serveFiles } from './lesson-pages.mjs';

const { values } = parseArgs({
  options: { kills: { type: 'string', default: '2' }, forms: { type: 'string' }, pictures: { type: 'string' } },
});
const program = join(projectRoot, 'packages/prepare/dist/volume-view-prepare.js');
const work = mkdtempSync(join(tmpdir(), 'volume-view-forms-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));

/** @typedef {'mosaic' | 'ome-zarr' | 'video' | 'single-file' | 'embed' | 'scorm' | 'scorm-2004' | 'cmi5' | 'h5p'} Form */
const credits = ['--licence', 'CC0', '--credits', 'Made by a program'];
/** The options of each form. @type {Record<Form, string[]>} */
const options = {
  mosaic: [],
  'ome-zarr': [],
  video: [],
  'single-file': [],
  embed: [...credits, '--address', 'https://example.org/site'],
  scorm: credits,
  'scorm-2004': credits,
  cmi5: credits,
  h5p: credits,
};
// Mosaics have a test of their own, prepare-folder.mjs; scorm-2004 and cmi5 are written like scorm.
const forms = /** @type {Form[]} */ ((values.forms ?? 'ome-zarr,video,single-file,embed,scorm,h5p').split(','));

const folder = join(work, 'in');
mkdirSync(join(folder, 'radar'), { recursive: true });
copyFileSync(join(projectRoot, 'test/e2e/pages/data/field.nii.gz'), join(folder, 'field.nii.gz'));
/** A heart that beats: 8 times every 0.1 seconds. */
function putHeart() {
  const [n, times] = [20, 8];
  const header = Buffer.alloc(352);
  header.writeInt32LE(348, 0);
  [4, n, n, n, times, 1, 1, 1].forEach((value, i) => header.writeInt16LE(value, 40 + 2 * i));
  header.writeInt16LE(2, 70);
  header.writeInt16LE(8, 72);
  [1, 2, 2, 2, 0.1, 1, 1, 1].forEach((value, i) => header.writeFloatLE(value, 76 + 4 * i));
  header.writeFloatLE(352, 108);
  header[123] = 2 + 8;
  header.writeInt16LE(1, 254);
  [2, 0, 0, -19, 0, 2, 0, -19, 0, 0, 2, -19].forEach((value, i) => header.writeFloatLE(value, 280 + 4 * i));
  header.write('n+1\0', 344, 'latin1');
  const data = Buffer.alloc(n ** 3 * times);
  for (let at = 0, t = 0; t < times; t++)
    for (let z = 0; z < n; z++)
      for (let y = 0; y < n; y++)
        for (let x = 0; x < n; x++) {
          const r = Math.hypot(x - 9.5, y - 9.5, z - 9.5) - 5 - 2 * Math.sin((2 * Math.PI * t) / times);
          data[at++] = Math.max(0, Math.min(200, Math.round(110 - 40 * Math.abs(r))));
        }
  writeFileSync(join(folder, 'heart.nii'), Buffer.concat([header, data]));
}
putHeart();
// One radar, a day later: the file says its times as text.
const odim = readFileSync(join(projectRoot, 'test/fixtures/radar/odim-2.2.h5'));
writeFileSync(join(folder, 'radar/b.h5'), odim);
const later = odim.toString('latin1').replaceAll('20240517', '20240518');
writeFileSync(join(folder, 'radar/a.h5'), Buffer.from(later, 'latin1'));
writeFileSync(join(folder, 'radar/cut.h5'), odim.subarray(0, 3000));

/** @param {Form} form @param {string} site @param {...string} more */
const argsOf = (form, site, ...more) => [
  ...[program, folder, '--out', site, '--as', form, '--jobs', '2', '--poster', form === 'embed' ? '32' : '0'],
  ...options[form],
  ...more,
];

/** @param {Form} form @param {string} site @param {...string} more */
function run(form, site, ...more) {
  const { status, stdout, stderr } = spawnSync(process.execPath, argsOf(form, site, ...more), { encoding: 'utf8' });
  const lines = stdout.split('\n').filter(Boolean);
  return { status, stderr, lines: lines.map((line) => JSON.parse(line)) };
}

/** All files of a folder, by their names. @param {string} path */
function filesIn(path) {
  const names = readdirSync(path, { recursive: true, encoding: 'utf8' });
  names.sort();
  return names.filter((name) => statSync(join(path, name)).isFile());
}

const scanFolder = /^[0-9a-f]{16}(-\d+)?(-scans)?$/;

/** What a folder of a form has. @type {Record<Form, (names: string[]) => void>} */
const contents = {
  mosaic: (names) => assert.deepEqual(names, ['index.html', 'volume.json', 'volume.png']),
  'ome-zarr': (names) => {
    for (const name of ['index.html', 'volume.ome.zarr/zarr.json', 'volume.ome.zarr/0/zarr.json'])
      assert.ok(names.includes(name), `${name} of ${names.join()}`);
  },
  video: (names) => assert.deepEqual(names, ['index.html', 'volume.json', 'volume.webm']),
  'single-file': (names) => assert.deepEqual(names, ['index.html']),
  embed: (names) => {
    for (const name of [
      'index.html',
      'embed.html',
      'embed-lesson.html',
      'oembed.json',
      'data/volume.json',
      'poster.png',
    ])
      assert.ok(names.includes(name), `${name} of ${names.join()}`);
    assert.ok(!names.some((name) => name.startsWith('volume-view')), 'all scans share the element');
  },
  scorm: (names) => assert.deepEqual(names, ['scorm.zip']),
  'scorm-2004': (names) => assert.deepEqual(names, ['scorm-2004.zip']),
  cmi5: (names) => assert.deepEqual(names, ['cmi5.zip']),
  h5p: (names) => assert.deepEqual(names, ['scan.h5p']),
};

/** The first line of the heart, the field and the first radar scan. @param {any[]} lines */
function linesOf(lines) {
  const done = lines.filter(({ status }) => status !== 'failed');
  const find = (/** @type {(line: any) => boolean} */ test) => done.find(test);
  return {
    heart: find(({ time }) => time === '0 s'),
    field: find(({ time, dimensions }) => time === undefined && dimensions[0] < 100),
    radar: find(({ time }) => time?.startsWith('2024-05-17')),
  };
}

/** @type {Map<Form, ReturnType<typeof run>['lines']>} */
const made = new Map();
/** Milliseconds. @type {Map<Form, number>} */
const took = new Map();
const siteOf = (/** @type {Form} */ form) => join(work, form);

for (const form of forms)
  await check(`--as ${form}: each volume gets its form, a broken file is listed, and a second run does nothing`, () => {
    const began = performance.now();
    const { status, stderr, lines } = run(form, siteOf(form));
    took.set(form, performance.now() - began);
    made.set(form, lines);
    assert.equal(status, 2, stderr);
    const failed = lines.filter((line) => line.status === 'failed');
    const { heart, field, radar } = linesOf(lines);
    // OME-Zarr has no gates of radars.
    assert.equal(failed.length, form === 'ome-zarr' ? 3 : 1, JSON.stringify(failed));
    if (form === 'ome-zarr')
      assert.match(failed.map(({ message }) => message).join(), /a radar scan, which has no voxels/);
    for (const line of [heart, field, ...(form === 'ome-zarr' ? [] : [radar])]) {
      // A volume of one time is no video.
      const wanted = form === 'video' && line === field ? 'mosaic' : form;
      assert.equal(line.form, wanted);
      const at = join(siteOf(form), line.id);
      contents[wanted](filesIn(at).filter((name) => form === 'embed' || name !== 'poster.png'));
      assert.ok(existsSync(join(siteOf(form), line.page)), line.page);
      assert.ok(line.bytes > 0 && line.error.max >= line.error.rms, JSON.stringify(line));
    }
    if (form === 'video') {
      const frames = lines.filter(({ id }) => id === radar.id);
      assert.deepEqual(
        frames.map(({ time }) => time),
        ['2024-05-17T11:59:51Z', '2024-05-18T11:59:51Z'],
        'the scans of one radar in the order of time, whatever their files are called',
      );
      assert.equal(lines.filter(({ id }) => id === heart.id).length, 8);
    }
    const index = readFileSync(join(siteOf(form), 'index.html'), 'utf8');
    assert.ok(index.includes(`href="${heart.scans ?? heart.page}"`), 'the index leads to it');
    const texts = filesIn(siteOf(form)).map((name) => name + readFileSync(join(siteOf(form), name), 'latin1'));
    for (const word of ['field.nii', 'heart.nii', 'a.h5', folder])
      assert.ok(!texts.some((text) => text.includes(word)), `${word} is in the site`);
    const before = filesIn(siteOf(form)).map((name) => `${name} ${statSync(join(siteOf(form), name)).mtimeMs}`);
    const second = run(form, siteOf(form));
    assert.deepEqual(
      filesIn(siteOf(form)).map((name) => `${name} ${statSync(join(siteOf(form), name)).mtimeMs}`),
      before,
    );
    assert.equal(second.lines.filter((line) => line.status === 'done').length, 0);
    return `${(took.get(form) ?? 0).toFixed(0)} ms`;
  });

const h5pPlayer = join(projectRoot, 'test/h5p/node_modules/h5p-standalone/dist');
if (forms.includes('h5p') && !existsSync(h5pPlayer))
  await check('the player of H5P is installed', () => {
    const { status, stderr } = spawnSync('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], {
      cwd: join(projectRoot, 'test/h5p'),
      encoding: 'utf8',
      shell: process.platform === 'win32',
    });
    assert.equal(status, 0, stderr);
  });

/** The pages of original files, packages that were unpacked, and the player of H5P, by the first part of their address. @type {Record<string, (path: string) => Uint8Array | string>} */
const places = {
  dist: (path) => readFileSync(join(projectRoot, 'dist', path)),
  in: (path) => readFileSync(join(folder, path)),
  player: (path) => readFileSync(join(h5pPlayer, path)),
  site: (path) => readFileSync(join(work, path)),
  original: (path) =>
    `<!doctype html><title>x</title><script src="/dist/volume-view.iife.js"></script><volume-view src="/in/${path}"></volume-view>`,
  frame: (path) =>
    `<!doctype html><title>x</title><iframe sandbox="allow-scripts" style="border: 0; width: 440px; height: 600px" src="/site/${path}"></iframe>`,
  host: (path) =>
    `<!doctype html><title>x</title><style>body { margin: 0 } #place { width: 440px }</style><div id="place"></div><script src="/player/main.bundle.js"></script>
    <script>new H5PStandalone.H5P(document.getElementById('place'), { id: 'one', h5pJsonPath: '/site/${path}', frameJs: '/player/frame.bundle.js', frameCss: '/player/styles/h5p.css' });</script>`,
};
const { origin, close } = await serveFiles((address) => {
  const [, place, ...rest] = address.split('/');
  return places[place]?.(rest.join('/'));
});
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listTestArgs() });

/** Unpacks the package of a line next to it. @param {Form} form @param {any} line */
function unpack(form, line) {
  const target = `${form}-unpacked/${line.id}`;
  for (const [name, bytes] of Object.entries(unzipSync(new Uint8Array(readFileSync(join(siteOf(form), line.page)))))) {
    if (name.endsWith('/')) continue;
    mkdirSync(dirname(join(work, target, name)), { recursive: true });
    writeFileSync(join(work, target, name), bytes);
  }
  return target;
}

/** Opens what a line says, and gives the place of the element. @param {import('@playwright/test').Page} page @param {Form} form @param {any} line */
async function openForm(page, form, line) {
  if (form === 'single-file') await page.goto(pathToFileURL(join(siteOf(form), line.page)).href);
  else if (form === 'embed') {
    await page.goto(`${origin}/frame/${form}/${line.id}/embed.html`);
    await page.frameLocator('iframe').locator('.poster a').click();
    return page.frameLocator('iframe');
  } else if (form === 'h5p') {
    await page.goto(`${origin}/host/${unpack(form, line)}`);
    return page.frameLocator('iframe');
  } else if (form.startsWith('scorm')) await page.goto(`${origin}/site/${unpack(form, line)}/index.html`);
  else await page.goto(`${origin}/site/${form}/${line.scans ?? line.page}`);
  return page;
}

/** All pictures have one size. @param {import('@playwright/test').Page | import('@playwright/test').FrameLocator} place */
const shape = (place) =>
  place
    .locator('volume-view')
    .first()
    .evaluate((view) => {
      for (const [name, value] of Object.entries({ width: '200px', height: '200px', 'aspect-ratio': 'auto' }))
        /** @type {HTMLElement} */ (view).style.setProperty(name, value, 'important');
    });

/** @type {Record<string, any>} */
const originals = {};
/** @param {string} name */
async function originalOf(name) {
  if (originals[name]) return originals[name];
  const { page, problems } = await openLessonPage(browser, origin);
  await page.goto(`${origin}/original/${name}`);
  await shape(page);
  originals[name] = await pictureOf(page);
  assert.deepEqual(problems, []);
  await page.context().close();
  return originals[name];
}

/** What a pixel adds to the page: its colour times its opacity, and the opacity. The colour of a pixel that is almost clear is mere rounding. @param {any} picture */
const seen = ({ data }) =>
  Float64Array.from(data, (x, i) => (i % 4 === 3 ? x : (x * data[4 * Math.floor(i / 4) + 3]) / 255));

/** Root mean square and largest difference of what two pictures show, of 255. @param {any} a @param {any} b */
function compare(a, b) {
  assert.deepEqual([a.width, a.height, a.channels, b.channels], [b.width, b.height, 4, 4]);
  const [one, other] = [seen(a), seen(b)];
  const off = one.map((x, i) => Math.abs(x - other[i]));
  return {
    rms: Math.sqrt(off.reduce((sum, x) => sum + x ** 2, 0) / off.length),
    max: off.reduce((most, x) => Math.max(most, x)),
  };
}

/** What is compared in each form. cmi5 needs a course that starts it: packages/lesson-writers has its own tests of that. */
const shown = { heart: 'heart.nii', field: 'field.nii.gz', radar: 'radar/b.h5' };
for (const form of forms.filter((one) => one !== 'cmi5' && made.has(one)))
  await check(`--as ${form}: pages show the pictures of the original files`, async () => {
    const lines = linesOf(made.get(form) ?? []);
    const remarks = [];
    for (const [what, name] of Object.entries(shown)) {
      const line = lines[/** @type {keyof typeof lines} */ (what)];
      if (!line) continue;
      const { page, problems } = await openLessonPage(browser, form === 'single-file' ? 'file:' : origin);
      const place = await openForm(page, form, line);
      await shape(place);
      const picture = await pictureOf(place);
      const original = await originalOf(name);
      if (values.pictures) {
        mkdirSync(values.pictures, { recursive: true });
        writeFileSync(join(values.pictures, `${form}-${what}.png`), encode(picture));
        await page.screenshot({ path: join(values.pictures, `${form}-${what}-page.png`) });
        writeFileSync(join(values.pictures, `original-${what}.png`), encode(original));
      }
      assert.ok(new Set(picture.data).size > 20, `${what}: a picture, and not one colour`);
      const { rms, max } = compare(picture, original);
      // Each of them may be max-error off, which is 1, as values of 8 bits have other steps of rays.
      assert.ok(rms < 1 && max < 8, `${what}: ${rms} of 255, at most ${max}`);
      remarks.push(`${what} ${rms.toFixed(2)} (at most ${max.toFixed(1)})`);
      assert.deepEqual(problems, [], what);
      await page.context().close();
    }
    return `rmse of 255: ${remarks.join(', ')}`;
  });
await check(
  'a volume that is larger than a mosaic becomes a pyramid by itself, and a phone gets a smaller one',
  async () => {
    const large = join(work, 'large');
    mkdirSync(large);
    // No image that a mosaic may be has a row of so many pixels.
    const [nx, ny, nz] = [8200, 20, 20];
    const header = `NRRD0004\ntype: uint8\ndimension: 3\nsizes: ${nx} ${ny} ${nz}\nspace: left-posterior-superior\nspace directions: (0.008,0,0) (0,2,0) (0,0,2)\nspace origin: (0,0,0)\nencoding: raw\n\n`;
    const data = Buffer.alloc(nx * ny * nz);
    for (let at = 0, z = 0; z < nz; z++)
      for (let y = 0; y < ny; y++) {
        const r = Math.hypot(y - 9.5, z - 9.5);
        for (let x = 0; x < nx; x++) data[at++] = r < 8 ? Math.round(120 + 60 * Math.sin(x / 500) + 6 * r) : 0;
      }
    writeFileSync(join(large, 'long.nrrd'), Buffer.concat([Buffer.from(header), data]));
    const lineFor = (/** @type {string[]} */ ...args) =>
      JSON.parse(
        spawnSync(process.execPath, [program, large, '--out', join(work, 'large-site'), '--poster', '0', ...args], {
          encoding: 'utf8',
        }).stdout,
      );
    const line = lineFor();
    assert.deepEqual(
      [line.form, line.dimensions, line.from, line.error],
      ['ome-zarr', [nx, ny, nz], undefined, { max: 0, rms: 0 }],
    );
    contents['ome-zarr'](filesIn(join(work, 'large-site', line.id)));
    const { page, problems } = await openLessonPage(browser, origin);
    await page.goto(`${origin}/site/large-site/${line.page}`);
    await shape(page);
    const picture = await pictureOf(page);
    assert.ok(new Set(picture.data).size > 20, 'a picture, and not one colour');
    assert.deepEqual(problems, []);
    await page.context().close();
    const phone = lineFor('--fit', 'phone');
    assert.deepEqual([phone.form, phone.from], ['mosaic', [nx, ny, nz]]);
    assert.ok(phone.error.max > 0);
  },
);
await browser.close();
close();

for (const form of forms)
  await check(
    `--as ${form}: ended at ${values.kills} moments it leaves no half file, and the next run goes on`,
    async () => {
      const killed = join(work, `killed-${form}`);
      const privateFolder = `${killed}.private`;
      let whole = 0;
      for (let i = 0; i < Number(values.kills); i++) {
        // With the same secret, a folder has the same name, and all its bytes can be compared.
        mkdirSync(privateFolder, { recursive: true });
        cpSync(join(`${siteOf(form)}.private`, 'salt'), join(privateFolder, 'salt'));
        const child = spawn(process.execPath, argsOf(form, killed), { stdio: 'ignore' });
        const ended = new Promise((resolve) => child.once('exit', resolve));
        await new Promise((resolve) =>
          setTimeout(resolve, ((took.get(form) ?? 0) * (i + Math.random())) / Number(values.kills)),
        );
        child.kill('SIGKILL');
        await ended;
        for (const name of existsSync(killed) ? readdirSync(killed) : []) {
          if (!scanFolder.test(name)) continue;
          const [own, wanted] = [join(killed, name), join(siteOf(form), name)];
          assert.deepEqual(filesIn(own), filesIn(wanted), name);
          for (const file of filesIn(own))
            assert.ok(readFileSync(join(own, file)).equals(readFileSync(join(wanted, file))), `${name}/${file}`);
          whole++;
        }
        // Some begin again from nothing, so that also the first files of a run are interrupted.
        if (i % 5 === 4) for (const path of [killed, privateFolder]) rmSync(path, { recursive: true, force: true });
      }
      const last = run(form, killed);
      assert.equal(last.status, 2, last.stderr);
      const ok = (/** @type {any[]} */ lines) => lines.filter(({ status }) => status !== 'failed').length;
      assert.equal(ok(last.lines), ok(made.get(form) ?? []));
      assert.deepEqual(
        readdirSync(killed).filter((name) => name.startsWith('.')),
        [],
      );
      return `${whole} whole folders seen`;
    },
  );

await check('what can not be done is said in words', () => {
  const site = join(work, 'none');
  for (const [args, words] of /** @type {[string[], RegExp][]} */ ([
    [['--as', 'tiff'], /expected mosaic, ome-zarr, video, single-file, embed/],
    [['--as', 'scorm'], /without --licence and --credits/],
    [['--as', 'embed', ...credits], /expected the one that it will have on your web server/],
    [['--as', 'h5p', ...credits, '--language', '12'], /expected one as HTML has it/],
    [['--as', 'scorm', ...credits, '--address', 'https://example.org/'], /expected it with --as embed/],
    [['--licence', 'CC0'], /expected them with --as embed, scorm or h5p/],
    [['--codec', 'av1'], /expected them with --as video/],
    [['--as', 'video', '--codec', 'h264'], /expected vp9 or av1/],
    [['--as', 'ome-zarr', '--watch'], /expected mosaic, or nothing/],
  ])) {
    const { status, stderr } = spawnSync(process.execPath, [program, folder, '--out', site, ...args], {
      encoding: 'utf8',
    });
    assert.equal(status, 1, args.join(' '));
    assert.match(stderr, words);
    assert.ok(!existsSync(site), 'nothing is written');
  }
});

finish();
