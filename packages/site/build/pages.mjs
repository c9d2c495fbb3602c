// Which pages the site has, where they lie, and what leads to them.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { escapeHtml } from './markdown.mjs';

/** Pages outside of docs. */
const otherPages = [
  'README.md',
  'CHANGELOG.md',
  'CREDITS.md',
  'GLOSSARY.md',
  'CONTRIBUTING.md',
  'demos/data/LICENSES.md',
];

/** @param {string} root - of the project @returns {string[]} all pages, as paths from there with `/` */
export function listPages(root) {
  const docs = readdirSync(join(root, 'docs'), { recursive: true })
    .map((name) => `docs/${String(name).replaceAll('\\', '/')}`)
    .filter((name) => name.endsWith('.md'));
  return [...otherPages, ...docs];
}

/** Where a page lies in the site: the README of a folder is its index. @param {string} page */
export const addressOf = (page) => page.replace(/README\.md$/, 'index.md').replace(/\.md$/, '.html');

/**
 * A function for the links of a page.
 * @param {string} root - of the project
 * @param {string} from - the page
 * @param {ReadonlySet<string>} pages
 * @param {(file: string) => void} addFile - for files that the site then has to have
 * @returns {(target: string) => string | null}
 */
export function linksOf(root, from, pages, addFile) {
  return (target) => {
    if (/^(https?:|mailto:|#)/.test(target)) return target;
    const [path, anchor] = target.split('#');
    const to = posix.normalize(posix.join(dirname(from), path));
    const end = anchor === undefined ? '' : `#${anchor}`;
    if (pages.has(to)) return addressOf(path) + end;
    if (!/\.(webp|png|svg)$/.test(to) || !existsSync(join(root, to))) return null;
    addFile(to);
    return target;
  };
}

/**
 * @typedef {object} Shelf
 * @property {string} title
 * @property {{ page: string, title: string }[]} pages - paths from the root of the project
 */

/** The title of a page, without what it explains after a colon. @param {string} root @param {string} page */
function titleOf(root, page) {
  const [, heading] = /^# (.+)$/m.exec(readFileSync(join(root, page), 'utf8')) ?? [];
  return (heading ?? page).split(':')[0].replaceAll('`', '');
}

/** What the index of docs lists, heading by heading. @param {string} root @returns {Shelf[]} */
export function listShelves(root) {
  /** @type {Shelf[]} */
  const shelves = [];
  const seen = new Set();
  for (const line of readFileSync(join(root, 'docs/README.md'), 'utf8').split('\n')) {
    const heading = /^##+ (.+)$/.exec(line);
    if (heading) shelves.push({ title: heading[1], pages: [] });
    if (!line.startsWith('|') && !line.startsWith('Begin with')) continue;
    for (const [, target] of line.matchAll(/\[[^\]]+\]\(([^)#]+\.md)(?:#[^)]*)?\)/g)) {
      const page = posix.join('docs', target);
      if (seen.has(page) || target.startsWith('..')) continue;
      seen.add(page);
      shelves.at(-1)?.pages.push({ page, title: titleOf(root, page) });
    }
  }
  return shelves.filter(({ pages }) => pages.length > 0);
}

/**
 * A page of the site.
 * @param {object} page
 * @param {string} page.address - in the site
 * @param {string} page.title
 * @param {string} page.body - HTML
 * @param {Shelf[]} page.shelves
 */
export function writePage({ address, title, body, shelves }) {
  const root = '../'.repeat(address.split('/').length - 1);
  const link = (/** @type {string} */ to, /** @type {string} */ text) =>
    `<a href="${root}${to}"${to === address ? ' aria-current="page"' : ''}>${escapeHtml(text)}</a>`;
  const lists = shelves.map((shelf) => {
    const isOpen = shelf.pages.some(({ page }) => addressOf(page) === address);
    const items = shelf.pages.map((one) => `<li>${link(addressOf(one.page), one.title)}</li>`).join('');
    return `<details${isOpen ? ' open' : ''}><summary>${escapeHtml(shelf.title)}</summary><ul>${items}</ul></details>`;
  });
  const name = '<volume-view>';
  return `<!doctype html>
<html lang="en" data-root="${root}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>${escapeHtml(address === 'index.html' ? `${name}: an HTML tag for volumes` : `${title} · ${name}`)}</title>
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<link rel="stylesheet" href="${root}site.css">
<script defer src="${root}site.js"></script>
</head>
<body>
<a class="skip" href="#content">To the text</a>
<header>
${link('index.html', name)}
<nav aria-label="Main">${link('gallery.html', 'Gallery')} ${link('docs/guide/cookbook.html', 'Cookbook')} ${link('docs/index.html', 'All pages')} ${link('docs/reference.html', 'Reference')} <a href="${root}studio/index.html">Lesson studio</a></nav>
<form role="search"><label>Search <input type="search" name="words" autocomplete="off"></label><div class="found" role="status" aria-live="polite"></div></form>
</header>
<div class="page">
<main id="content">
${body}</main>
<nav class="shelves" id="pages" aria-label="Pages">${lists.join('')}</nav>
</div>
<footer>The data in the examples: ${link('demos/data/LICENSES.html', 'whose they are')}. Some are synthetic. Not a medical device.</footer>
</body>
</html>
`;
}

/** The page with a link to the demos, for the server that has them too. @param {string} html */
export const addDemosLink = (html) =>
  html.replace('<nav aria-label="Main">', '<nav aria-label="Main"><a href="/demos/">Demos</a> ');
