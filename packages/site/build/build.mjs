// Builds the site: a static folder, which any web server can serve and which opens from a disk. The element and the studio have been built before.
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import MiniSearch from 'minisearch';
import { build, runnerImport } from 'vite';
import { writeGallery } from './gallery.mjs';
import { renderPage } from './markdown.mjs';
import { addressOf, linksOf, listPages, listShelves, writePage } from './pages.mjs';
import { imagesOfManifests, sampleFiles } from './sample-files.mjs';
import { searchFields } from '../src/search-fields.mjs';

/** @param {string} path @param {string | Uint8Array} content */
function write(path, content) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, content);
}

/** A file as a script, for pages from a disk, which may read no files. @param {string} name @param {string} url */
const asScript = (name, url) => `(window.sampleFiles ??= {})[${JSON.stringify(name)}] = ${JSON.stringify(url)};\n`;

/** @param {Uint8Array} bytes @param {string} type */
const toDataUrl = (bytes, type) => `data:${type};base64,${Buffer.from(bytes).toString('base64')}`;

/** The samples, by the names that the examples give them, and as scripts. @param {string} root @param {string} out */
function writeSamples(root, out) {
  const read = (/** @type {string} */ name) => readFileSync(join(root, 'demos/data', name));
  for (const name of imagesOfManifests) write(join(out, 'examples', name), read(name));
  for (const [name, file] of Object.entries(sampleFiles)) {
    const bytes = read(file);
    write(join(out, 'examples', name), bytes);
    const isManifest = file.endsWith('.json');
    const whole = isManifest
      ? bytes
          .toString('utf8')
          .replaceAll(/"([\w-]+\.png)"/g, (_, image) => JSON.stringify(toDataUrl(read(image), 'image/png')))
      : '';
    const url = isManifest
      ? toDataUrl(Buffer.from(whole), 'application/json')
      : toDataUrl(bytes, 'application/octet-stream');
    write(join(out, 'examples/from-disk', `${name}.js`), asScript(name, url));
  }
}

/** The script of the pages. @param {string} folder - packages/site @param {string} out */
async function writeScript(folder, out) {
  await build({
    configFile: false,
    root: folder,
    publicDir: false,
    logLevel: 'warn',
    build: {
      outDir: out,
      emptyOutDir: false,
      target: 'es2022',
      lib: { entry: join(folder, 'src/main.ts'), formats: ['iife'], name: 'site', fileName: () => 'site.js' },
    },
  });
}

/**
 * @param {object} places
 * @param {string} places.root - of the project
 * @param {string} places.folder - packages/site
 * @param {string} places.out - is replaced
 * @returns {Promise<{ pages: number, examples: number, live: number }>}
 */
export async function buildSite({ root, folder, out }) {
  rmSync(out, { recursive: true, force: true });
  /** @type {{ module: typeof import('../../lesson-writers/src/image-size.ts') }} */
  const {
    module: { readImageSize },
  } = await runnerImport(join(root, 'packages/lesson-writers/src/image-size.ts'));
  const pages = listPages(root);
  const known = new Set(pages);
  const shelves = listShelves(root);
  const images = new Set();
  /** @type {{ id: string, page: string, heading: string, text: string }[]} */
  const found = [];
  const counts = { pages: 0, examples: 0, live: 0 };
  for (const page of pages) {
    const address = addressOf(page);
    const resolve = linksOf(root, page, known, (file) => images.add(file));
    const sizeOf = (/** @type {string} */ image) => readImageSize(readFileSync(join(root, dirname(page), image)));
    const { title, html, sections, examples } = renderPage(readFileSync(join(root, page), 'utf8'), resolve, sizeOf);
    write(join(out, address), writePage({ address, title, body: html, shelves }));
    counts.pages += 1;
    counts.examples += examples.length;
    counts.live += examples.filter(({ reason }) => !reason).length;
    if (/^(README|docs\/(guide|reference|README))/.test(page))
      for (const { anchor, heading, text } of sections)
        found.push({ id: `${address}${anchor && `#${anchor}`}`, page: title, heading, text });
  }
  const gallery = writeGallery(root);
  write(
    join(out, 'gallery.html'),
    writePage({ address: 'gallery.html', title: 'Gallery', body: gallery.html, shelves }),
  );
  for (const file of [...images, ...gallery.images]) write(join(out, file), readFileSync(join(root, file)));
  const index = new MiniSearch(searchFields);
  index.addAll(found);
  write(join(out, 'search-index.js'), `window.searchIndex = ${JSON.stringify(JSON.stringify(index))};\n`);
  writeSamples(root, out);
  const isShown = (/** @type {string} */ path) => !/[\\/]dist[\\/](esm|types|from-disk.*)$/.test(path);
  cpSync(join(root, 'dist'), join(out, 'examples/dist'), { recursive: true, filter: isShown });
  cpSync(join(root, 'packages/studio/dist'), join(out, 'studio'), { recursive: true });
  cpSync(join(folder, 'src/site.css'), join(out, 'site.css'));
  await writeScript(folder, out);
  return counts;
}
