// The site of the docs: all its links lead somewhere, each example has a picture or says why not, and its pages are read, searched and changed in a browser.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, posix } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from '@playwright/test';
import { parse } from 'parse5';
import { createServer, runnerImport } from 'vite';
import { buildSite } from '../../packages/site/build/build.mjs';
import { exampleOf } from '../../packages/site/build/examples.mjs';
import { pagesOfDemos, writeGallery } from '../../packages/site/build/gallery.mjs';
import { renderPage } from '../../packages/site/build/markdown.mjs';
import { findBrowser, listTestArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { startStaticServer } from '../../scripts/static-server.mjs';
import { check, finish } from './checks.mjs';

/** @type {{ module: typeof import('../../packages/site/src/frame-document.ts') }} */
const {
  module: { frameDocument },
} = await runnerImport(join(projectRoot, 'packages/site/src/frame-document.ts'));

const out = mkdtempSync(join(tmpdir(), 'volume-view-site-'));
process.on('exit', () => rmSync(out, { recursive: true, force: true }));
const built = await buildSite({ root: projectRoot, folder: join(projectRoot, 'packages/site'), out });

/** @param {any} node @returns {Generator<{ name: string, attributes: Record<string, string> }>} */
function* elementsOf(node) {
  if (node.tagName)
    yield {
      name: node.tagName,
      attributes: Object.fromEntries(node.attrs.map((/** @type {any} */ { name, value }) => [name, value])),
    };
  for (const child of node.childNodes ?? []) yield* elementsOf(child);
}

/** The elements of each page, by address. */
const pages = new Map(
  readdirSync(out, { recursive: true })
    .map((name) => String(name).replaceAll('\\', '/'))
    .filter((name) => name.endsWith('.html') && !/^(studio|examples)\//.test(name))
    .map((name) => [name, [...elementsOf(parse(readFileSync(join(out, name), 'utf8')))]]),
);

await check('every link, picture, style and script of a page is there, and so is the heading', () => {
  let links = 0;
  const broken = [...pages].flatMap(([from, elements]) =>
    elements.flatMap(({ attributes: { href, src } }) => {
      const target = href ?? src;
      if (target === undefined || /^[a-z]+:/.test(target)) return [];
      links += 1;
      const [path, anchor] = target.split('#');
      const to = path ? posix.normalize(posix.join(dirname(from), path)) : from;
      const hasAnchor = !anchor || pages.get(to)?.some(({ attributes }) => attributes.id === anchor);
      return existsSync(join(out, to)) && hasAnchor ? [] : [`${from}: ${target}`];
    }),
  );
  assert.deepEqual(broken, []);
  assert.ok(links > 3000, `${links} links`);
  return `${pages.size} pages, ${links} links`;
});

await check('a page keeps the text of a link to what is not in the site, and no HTML of its own', () => {
  const { html, sections } = renderPage('# One `a<b>`\n[x](no.ts) <b>y</b>\n## Two\n![p](p.png)', (to) =>
    to.endsWith('.ts') ? null : to,
  );
  assert.match(html, /<h1 id="one-ab">One <code>a&lt;b&gt;<\/code><\/h1>\n<p>x &lt;b&gt;y&lt;\/b&gt;<\/p>/);
  assert.deepEqual(
    sections.map(({ anchor, heading }) => [anchor, heading]),
    [
      ['', 'One a<b>'],
      ['two', 'Two'],
    ],
  );
});

/** The blocks of the pages, with the page that has them. */
const blocks = ['README.md', ...readdirSync(join(projectRoot, 'docs/guide')).map((name) => `docs/guide/${name}`)]
  .filter((page) => page.endsWith('.md'))
  .flatMap((page) => {
    const { examples } = renderPage(readFileSync(join(projectRoot, page), 'utf8'), (to) => to);
    return examples.map((example, i) => ({ ...example, name: `${page} ${i + 1}` }));
  });

await check('each example has its files among the samples, or says why there is no picture', () => {
  assert.deepEqual(
    blocks
      .filter(({ reason }) => reason.includes('not among the samples'))
      .map(({ name, reason }) => `${name}: ${reason}`),
    [],
  );
  assert.match(exampleOf('<volume-view src="x.nii"></volume-view>')?.reason ?? '', /x\.nii is not among the samples/);
  assert.equal(exampleOf('<volume-label value="1"></volume-label>')?.reason, 'It is a part of a page.');
  assert.equal(exampleOf('<p>Text</p>'), null);
  const live = blocks.filter(({ reason }) => !reason).length;
  assert.ok(live >= 65, `${live} are live`);
  return `${live} of ${blocks.length} are live`;
});

await check('the gallery has every demo but those for developers', () => {
  const { left, images } = writeGallery(projectRoot);
  assert.deepEqual(left, ['no-bundler', 'mosaic', 'trade', 'accuracy']);
  assert.equal(images.length, Object.keys(pagesOfDemos).length);
});

await check('the page of an example has the scripts of the element once, next to a script of its own too', () => {
  const scriptsOf = (/** @type {string} */ code, isFromDisk = false) =>
    [...frameDocument(code, { base: 'examples/', isFromDisk }).matchAll(/src="(dist\/[^"]*)"/g)].map(([, src]) => src);
  const view = '<volume-view src="head.nii.gz"></volume-view>';
  const withElement = `<script type="module" src="dist/volume-view.js"></script>${view}`;
  assert.deepEqual(scriptsOf(view), ['dist/volume-view.iife.js']);
  assert.deepEqual(scriptsOf(`${view}<script type="module">document.title</script>`), ['dist/volume-view.iife.js']);
  assert.deepEqual(scriptsOf(withElement), ['dist/volume-view.js']);
  assert.deepEqual(scriptsOf(withElement, true), ['dist/volume-view.iife.js']);
});

/** Pages by path. @type {Record<string, () => Uint8Array>} */
const made = {};
const server = await startStaticServer({ root: out, made });
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listTestArgs() });

/** @param {import('@playwright/test').BrowserContextOptions} [options] */
async function newPage(options) {
  const page = await browser.newPage(options);
  page.setDefaultTimeout(120_000);
  /** @type {string[]} */
  const problems = [];
  page.on('console', (message) => {
    // A driver in software says that reading pixels takes long.
    if (/^(error|warning)$/.test(message.type()) && !/GPU stall/.test(message.text())) problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(String(error)));
  return { page, problems };
}

/** The share of the picture in which something is seen, once it is there. @param {import('@playwright/test').Frame} frame */
const shareShown = (frame) =>
  frame.evaluate(async () => {
    /** @type {any} */
    const view = document.querySelector('volume-view, volume-slice-view');
    const late = new Promise((_, reject) => setTimeout(() => reject(new Error('no picture in 120 s')), 120_000));
    const shown = customElements.whenDefined(view.localName).then(() => view.whenRendered());
    await Promise.race([shown, late]);
    if (view.localName === 'volume-slice-view') return 1;
    const bitmap = await createImageBitmap(await view.toBlob({ width: 80, height: 60 }));
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(80, 60).getContext('2d'));
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, 80, 60);
    return data.filter((alpha, i) => i % 4 === 3 && alpha > 64).length / (80 * 60);
  });

const axePath = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

for (const [address, title] of [
  ['index.html', '<volume-view>'],
  ['docs/guide/labels.html', 'Labels: names for the parts of a volume'],
  ['gallery.html', 'Gallery'],
  ['docs/reference/volume-view.html', '<volume-view>'],
]) {
  await check(`${address} fits a phone, is small, does not jump, and axe finds nothing`, async () => {
    const { page, problems } = await newPage({ viewport: { width: 390, height: 844 }, deviceScaleFactor: 0.5 });
    /** @type {Promise<Buffer>[]} */
    const bodies = [];
    page.on('response', (response) => {
      if (!/\/(examples|demos\/images|docs\/images)\//.test(response.url())) bodies.push(response.body());
    });
    await page.addInitScript(() => {
      /** @type {any} */ (window).jumps = 0;
      new PerformanceObserver((list) => {
        for (const entry of list.getEntries()) /** @type {any} */ (window).jumps += /** @type {any} */ (entry).value;
      }).observe({ type: 'layout-shift', buffered: true });
    });
    await page.goto(`${server.url}/${address}`);
    assert.equal(await page.locator('h1').textContent(), title);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0, 'it fits');
    await page.addScriptTag({ path: axePath });
    const faults = await page.evaluate(async () => {
      const { violations } = await /** @type {any} */ (window).axe.run(document, { iframes: false });
      return violations.map((/** @type {any} */ { id, nodes }) => `${id}: ${nodes[0].html}`);
    });
    assert.deepEqual(faults, []);
    await page.evaluate(() => new Promise((end) => setTimeout(end, 300)));
    assert.equal(await page.evaluate('jumps'), 0);
    const bytes = (await Promise.all(bodies)).reduce((sum, { length }) => sum + length, 0);
    assert.ok(bytes > 20_000 && bytes < 200_000, `${bytes} bytes before a volume`);
    assert.deepEqual(problems, []);
    await page.close();
    return `${bytes} bytes before a volume`;
  });
}

await check('the search finds a page by words of its text, by keys alone', async () => {
  const { page, problems } = await newPage();
  await page.goto(`${server.url}/docs/guide/projection.html`);
  await page.getByRole('searchbox').focus();
  await page.keyboard.type('isosurface');
  await page.locator('.found a').first().waitFor();
  await page.keyboard.press('Enter');
  await page.waitForURL(/iso-surfaces\.html/);
  await page.getByRole('searchbox').fill('qqqxyz');
  await page.getByText('Nothing was found for “qqqxyz”.').waitFor();
  await page.keyboard.press('Escape');
  assert.equal(await page.getByRole('searchbox').inputValue(), '');
  assert.deepEqual(problems, []);
  await page.close();
});

await check('an example has its picture when it is in sight, follows what is written, and goes back', async () => {
  const { page, problems } = await newPage({ viewport: { width: 1000, height: 600 }, deviceScaleFactor: 0.5 });
  await page.goto(`${server.url}/docs/guide/lighting.html`);
  const first = page.locator('figure.example').first();
  const frameOf = async () => {
    const handle = await first.locator('iframe').elementHandle();
    return /** @type {import('@playwright/test').Frame} */ (await handle?.contentFrame());
  };
  const shading = async () => {
    const frame = await frameOf();
    await frame.waitForFunction(() => document.querySelector('volume-view'));
    return frame.locator('volume-view').getAttribute('shading');
  };
  assert.ok((await shareShown(await frameOf())) > 0.05);
  assert.equal(await shading(), 'lit');
  const old = await first.locator('iframe').elementHandle();
  await first.locator('pre').fill('<volume-view src="brain.nii.gz" alt="Brain" shading="unlit"></volume-view>');
  await page.waitForFunction((one) => !one?.isConnected, old);
  assert.equal(await shading(), 'unlit');
  await first.getByRole('button', { name: 'As it was' }).click();
  assert.match((await first.locator('pre').textContent()) ?? '', /shading="lit"/);
  await page.waitForFunction(() =>
    document.querySelector('figure iframe')?.getAttribute('srcdoc')?.includes('shading="lit"'),
  );
  // Only a few pictures are alive, however far a reader scrolls.
  const examples = await page.locator('figure.example').all();
  for (const example of examples) {
    await example.scrollIntoViewIfNeeded();
    await example.locator('iframe').waitFor();
  }
  assert.ok(examples.length > 4);
  await page.waitForFunction(() => document.querySelectorAll('figure iframe').length <= 4);
  assert.deepEqual(problems, []);
  await page.close();
});

await check('from a disk a page has its pictures and its search too', async () => {
  const { page, problems } = await newPage({ viewport: { width: 1000, height: 600 }, deviceScaleFactor: 0.5 });
  await page.goto(pathToFileURL(join(out, 'docs/guide/scans-in-time.html')).href);
  const handle = await page.locator('figure.example iframe').first().elementHandle();
  assert.ok((await shareShown(/** @type {any} */ (await handle?.contentFrame()))) > 0.02);
  await page.getByRole('searchbox').fill('radar');
  await page.locator('.found a').first().waitFor();
  assert.deepEqual(problems, []);
  await page.close();
});

// Those of the README, of the first steps and of the lesson are opened word by word, as a new user has them, in test/e2e/readme.spec.ts.
const elsewhere = /^(README|docs\/guide\/(first-steps|lesson|embedding))\.md/;
const live = blocks.filter(({ name, reason, code }) => !reason && !elsewhere.test(name) && !code.includes('<iframe'));
const opened = process.argv.includes('--all') ? live : live.filter(({ name }) => name.endsWith(' 1'));
await check('the first live example of every other page has something in its picture, and no error', async () => {
  const { page, problems } = await newPage({ viewport: { width: 320, height: 560 }, deviceScaleFactor: 0.5 });
  const wrong = [];
  for (const { code, name } of opened) {
    made['/examples/page.html'] = () =>
      Buffer.from(frameDocument(code, { base: `${server.url}/examples/`, isFromDisk: false }));
    await page.goto(`${server.url}/examples/page.html`);
    const share = await shareShown(page.mainFrame()).catch((error) => String(error));
    const shown = await page.getByRole('alert').allTextContents();
    if (process.argv.includes('--all')) console.log(`${name}: ${share}`);
    if (typeof share === 'string' || share < 0.01 || shown.length + problems.length > 0)
      wrong.push(`${name}: ${share} ${shown.join(' ')} ${problems.splice(0).join(' ')}`);
  }
  assert.deepEqual(wrong, []);
  await page.close();
  return `${opened.length} of ${live.length} examples; --all opens all`;
});

await check(
  '`npm start` shows the site first, one click before demos and studio, and builds it again after a change',
  async () => {
    const vite = await createServer({
      root: projectRoot,
      logLevel: 'silent',
      server: { port: 0, open: false, hmr: false },
    });
    try {
      await vite.listen();
      const url = vite.resolvedUrls?.local[0] ?? '';
      const textOf = async (/** @type {string} */ path) => {
        const response = await fetch(url + path);
        return response.ok ? await response.text() : `status ${response.status}`;
      };
      const first = await textOf('');
      assert.match(first, /<h1 id="volume-view">/);
      const links = [...elementsOf(parse(first))].map(({ attributes }) => attributes.href);
      for (const [href, title] of [
        ['/demos/', 'Demos'],
        ['gallery.html', 'Gallery'],
        ['studio/index.html', 'Lesson studio'],
      ]) {
        assert.ok(links.includes(href), href);
        assert.match(await textOf(href.replace(/^\//, '')), new RegExp(`<title>${title}`));
      }
      for (const address of pages.keys())
        assert.match(await textOf(address), /<a href="\/demos\/">Demos<\/a>/, address);
      for (const file of [
        'site.js',
        'site.css',
        'search-index.js',
        'examples/head.nii.gz',
        'examples/dist/volume-view.js',
      ])
        assert.doesNotMatch(await textOf(file), /^(status|<)/, file);
      assert.match(await textOf('demos/one-tag.html'), /@vite\/client|demo\.js/);
      assert.equal(await textOf('docs/guide/missing.html'), 'status 404');
      const index = join(projectRoot, 'packages/site/dist/index.html');
      writeFileSync(index, 'old');
      assert.match(await textOf('index.html'), /^old/);
      vite.watcher.emit('all', 'change', join(projectRoot, 'README.md'));
      assert.match(await textOf('index.html'), /<h1 id="volume-view">/);
    } finally {
      await vite.close();
    }
  },
);

assert.equal(built.pages + 1, pages.size);
await browser.close();
server.close();
finish();
