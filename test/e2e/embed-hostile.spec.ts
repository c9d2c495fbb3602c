// The page for frames under attack: made messages and addresses, the same in every run, in a real browser. The page's own Content-Security-Policy
// is switched off here, so that what an attacker brings in would run: the page has to hold without it.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join } from 'node:path';
import type { Frame, Page } from '@playwright/test';
import { viewAttributes } from '../../packages/embed/src/view-attributes.ts';
import { eventTypes } from '../../packages/embed/src/protocol.ts';
import { findFile, projectRoot } from '../../scripts/shared-data.mjs';
import { randomNumbers } from '../helpers/synthetic.ts';
import { compare, expect, fieldUrl, test } from './helpers/harness.ts';
import { decodePicture } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';

/** What must not happen, and has. */
let faults: string[] = [];
/** Pages that a test has written, by path. */
const made: Record<string, string> = {};
const mimeTypes: Record<string, string> = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css' };

/** @param hasElement - whether the script of the element is the built one, and not an empty file */
function startServer({ hasElement = true } = {}): Server {
  const bodyOf = (path: string): string | Buffer | undefined => {
    if (path.endsWith('/volume-view.iife.js') && !hasElement) return '';
    const file = path.endsWith('/field.nii.gz') ? join(projectRoot, fieldUrl) : findFile(projectRoot, path);
    return made[path] ?? (file ? readFileSync(file) : undefined);
  };
  return createServer({ maxHeaderSize: 200_000 }, (request, response) => {
    const path = new URL(request.url ?? '/', 'http://x').pathname;
    if (path.startsWith('/canary')) faults.push(`the browser asked for ${path}`);
    const body = bodyOf(path);
    const headers = {
      'content-type': mimeTypes[extname(path)] ?? 'application/octet-stream',
      'access-control-allow-origin': '*',
      'cache-control': path.startsWith('/dist/') ? 'max-age=3600' : 'no-cache',
    };
    response.writeHead(path === '/favicon.ico' ? 204 : body === undefined ? 404 : 200, headers).end(body);
  });
}

/** Four origins: of the page for frames, of the same page without the element, of the attacker, and of the one site that the page's server lists. */
const servers = [startServer(), startServer({ hasElement: false }), startServer(), startServer()];
let [site, quickSite, attacker, friend] = ['', '', '', ''];
test.beforeAll(async () => {
  await Promise.all(servers.map((one) => new Promise<void>((resolve) => void one.listen(0, '127.0.0.1', resolve))));
  [site, quickSite, attacker, friend] = servers.map((one) => `http://127.0.0.1:${(one.address() as AddressInfo).port}`);
  const listed = `<meta name="volume-view-parents" content="${friend}"><title>`;
  made['/dist/listed.html'] = readFileSync(join(projectRoot, 'dist/embed.html'), 'utf8').replace('<title>', listed);
});
test.afterAll(() => {
  for (const one of servers) {
    one.closeAllConnections();
    one.close();
  }
});

// ---- What an attacker writes ----

const random = randomNumbers(3903);
const below = (count: number): number => Math.floor(random() * count);
const pick = <T>(list: readonly T[]): T => list[below(list.length)];
const listOf = <T>(min: number, max: number, make: () => T): T[] =>
  Array.from({ length: min + below(max - min + 1) }, make);

/** Texts that would run or load something where they become HTML, CSS or a script. */
const payloads: readonly string[] = [
  '<img src="/canary/image" onerror="hostile = 1">',
  '"><script>hostile = 1; fetch("/canary/script")</script>',
  `' onload='hostile = 1' onmouseover=hostile=1 autofocus onfocus="hostile = 1" x='`,
  '<svg><script>hostile = 1</script><animate onbegin="hostile = 1" attributeName="x" dur="1s"/></svg>',
  '<iframe srcdoc="<script>parent.hostile = 1</script>" src="/canary/frame"></iframe>',
  '</style><style>@import url(/canary/style);</style>',
  'red; background: url(/canary/color)',
  'url("/canary/url")',
  'gray 0, url(/canary/stop) 1',
  '{{constructor.constructor("hostile = 1")()}}',
  '${hostile = 1}',
  '"); hostile = 1; ("',
  '<base href="/canary/"><meta http-equiv="refresh" content="0; url=/canary/refresh">',
  '/canary/plain.nii',
  '\0',
  '\u202e\ud800',
  '-1',
  '1e309 NaN -0 1e-320',
  '99999999999999999999deg 1e99rad Infinity%',
  '0 0 0 0 0 0',
  'x'.repeat(15_000),
  'x'.repeat(20_000),
  '9 '.repeat(5000),
  '('.repeat(5000),
  '__proto__',
  'constructor',
];
/** Addresses that are no address of a file on a server. */
const badAddresses: readonly string[] = [
  'javascript:hostile=1',
  ' java\tscript:hostile=1//x.nii',
  'JAVASCRIPT:hostile=1//%0a.nii',
  'data:text/html,<script>hostile=1</script>',
  'data:image/svg+xml,<svg xmlns="http://www.w3.org/2000/svg" onload="hostile=1"/>',
  'data:application/json,{"image":"/canary/manifest.png"}',
  'blob:http://127.0.0.1/1-2',
  'file:///etc/passwd',
  'vbscript:hostile',
  'http://user:secret@127.0.0.1/canary/login',
  'https://',
  '/field.nii.gz javascript:hostile=1',
  'http://a http://[',
];
/** Addresses of a server, some of which can't be put together. */
const addresses: readonly string[] = [
  ...['/field.nii.gz', '/field.nii.gz', '/missing.nii', '/field.nii.gz#<img>', '//127.0.0.1:1/a b', 'http://a b', ''],
  ...[
    '/%zz.nii',
    '/%ff.dcm',
    '/%zz.mhd',
    '/%zz.zarr',
    '/%zz/',
    '/a.nii#%zz',
    '/<b>.json',
    '/field.nii.gz /field.nii.gz',
    'a?%zz',
  ],
];
const badNames: readonly string[] = [
  ...['onload', 'onclick', 'onerror', 'onfocus', 'ONLOAD', 'style', 'id', 'class', 'slot', 'is', 'part', 'srcdoc'],
  ...['href', 'SRC', 'innerHTML', '__proto__', 'constructor', 'toString', 'hasOwnProperty', 'crossorigin', 'authoring'],
  ...[
    'link-state',
    'width',
    '',
    ' ',
    'x y',
    'x"><img src=/canary/name onerror=hostile=1>',
    '\u202egnp',
    'x'.repeat(9999),
  ],
];
const names = [...viewAttributes];

/** What is written into an attribute. */
function textFor(name: string): string {
  if (name !== 'src' && name !== 'poster') return pick(payloads);
  return random() < 0.3 ? pick(addresses) : pick(badAddresses);
}

/** Values that are no texts, as source. */
const oddValues: readonly string[] = [
  ...['NaN', '-1', '0', '1e9', '-Infinity', '1.5', '10n', 'true', 'false', 'null', 'undefined', '[]', '[[["x"]]]'],
  ...['new Map([["src", "x"]])', 'new Set([1])', 'new Date(NaN)', '/x/', 'new Error("x")', 'new Uint8Array(9)'],
  ...['new Blob(["x"])', '{}', '{ toString: "x", valueOf: [] }', '{ length: 1e9, 0: "load" }', '"next"', '"1"'],
  ...['JSON.parse(\'{"__proto__": {"polluted": 1}, "src": "/field.nii.gz"}\')', 'new Array(1e5).fill("load")'],
  ...['"x".repeat(1e6)', 'nested(500)', 'many(1000)', 'new ArrayBuffer(8)', '[,]', 'Object("load")'],
];

const sourceOf = (entries: readonly (readonly [string, string])[]): string =>
  `{ ${entries.map(([name, value]) => `[${JSON.stringify(name)}]: ${value}`).join(', ')} }`;

function makeSet(): string {
  const isLikely = random() < 0.7;
  const entries = listOf(1, 4, (): [string, string] => {
    const name = random() < 0.15 ? pick(['src', 'poster']) : isLikely || random() < 0.5 ? pick(names) : pick(badNames);
    return [name, random() < 0.9 ? JSON.stringify(textFor(name)) : pick(oddValues)];
  });
  return sourceOf(entries);
}

const makeRequest: Readonly<Record<string, () => string>> = {
  set: () => (random() < 0.93 ? makeSet() : pick(oddValues)),
  step: () => pick([...oddValues, JSON.stringify(pick(payloads)), '"previous"', '3']),
  events: () => {
    const types = listOf(0, 25, () =>
      JSON.stringify(pick([...eventTypes, 'click', 'message', '__proto__', ...badNames])),
    );
    return random() < 0.3
      ? pick(oddValues)
      : random() < 0.3
        ? JSON.stringify(listOf(0, 5, () => pick(eventTypes)))
        : `[${types.join(', ')}]`;
  },
  get: () => pick(oddValues),
};
const otherKinds = [
  'eval',
  'html',
  'navigate',
  'location',
  'attributes',
  'constructor',
  '__proto__',
  'then',
  'message',
];

/** The source of a message. @param id - that the answer has */
function makeMessage(id: number): string {
  const form = random();
  if (form < 0.04) return pick(oddValues);
  const entries: [string, string][] = [
    ['volumeView', random() < 0.95 ? '1' : pick([...oddValues, '2', '"1"'])],
    ['id', random() < 0.9 ? String(id) : pick(oddValues)],
  ];
  const kinds = form < 0.7 ? ['set'] : form < 0.92 ? [pick(['step', 'events', 'get'])] : Object.keys(makeRequest);
  for (const kind of kinds.filter(() => kinds.length === 1 || random() < 0.5))
    entries.push([kind, makeRequest[kind]()]);
  if (random() < 0.1) entries.push([pick(otherKinds), pick([...oddValues, JSON.stringify(pick(payloads))])]);
  return sourceOf(entries);
}

/** The part of an address after the name of the page. */
function makeQuery(): string {
  const own = ['lesson', 'lang', 'parent', 'legend', 'readout', 'timeline'];
  const encode = (text: string): string => {
    const whole = text.replace(/[\ud800-\udfff]/g, '\ufffd');
    // Some are not encoded, and some badly.
    return random() < 0.2
      ? whole.replace(/[&#\0\t\n]/g, '') + pick(['', '%', '%zz', '%ff%fe', '%u0041', '%00'])
      : encodeURIComponent(whole);
  };
  const parts = listOf(1, 6, () => {
    const name = pick([pick(names), pick(names), pick(own), pick(badNames).slice(0, 200), pick(['src', 'poster'])]);
    const text = name === 'lesson' ? pick([...badAddresses, ...addresses]) : textFor(name);
    return `${encode(name)}=${encode(text)}`;
  });
  // Most name a file, so that there is a view which could be given what is hostile.
  if (random() < 0.7) parts.unshift('src=/field.nii.gz');
  if (random() < 0.2) parts.push(...listOf(1, 40, () => parts[0]));
  const hash = pick([
    '',
    '',
    '#?secret=a1',
    '#<img src=/canary/hash onerror=hostile=1>',
    '#javascript:hostile=1',
    '#%zz',
    '#volume-view=x',
  ]);
  return `?${parts.join(pick(['&', '&', '&', '&&', '&amp;', ';'])).slice(0, 60_000)}${hash}`;
}

/** A lesson of which a part is hostile. */
function makeLesson(): string {
  const text = pick(payloads);
  const address = pick([...badAddresses, 'https://attacker.example/a.nii', '../../a.nii']);
  const part = pick([
    ...[text, `<p title='${text}'>x</p>`, `<p ${pick(badNames)}="hostile = 1">x</p>`, `<a href="${address}">x</a>`],
    ...[`<img src="${address}" alt='${text}'>`, `<volume-note for="v" label='${text}'><p>${text}</p></volume-note>`],
    ...[
      '<math><mtext><table><mglyph><style><img src=/canary/math onerror=hostile=1></style></mglyph></table></mtext></math>',
    ],
    ...['<form id="v"><input name="attributes"><input name="childNodes"><img src=x onerror="hostile = 1"></form>'],
    ...[
      '<template><img src=/canary/template onerror=hostile=1></template>',
      '<noscript><img src=/canary/no onerror=hostile=1></noscript>',
    ],
    ...[
      '<p id="x3dom"></p><p id="define"></p><p id="exports"></p><p id="module"></p><p id="process"></p><p id="require"></p>',
    ],
    ...[
      `<volume-labels src="${address}"></volume-labels>`,
      '<div class="poster"><a href="https://attacker.example/">x</a></div>',
    ],
    ...[
      '<object data="javascript:hostile=1"></object>',
      '<link rel="stylesheet" href="/canary/link">',
      '<p is="x-y" slot="poster">x</p>',
    ],
  ]);
  const view = `<volume-view id="v" src="field.nii.gz" ${random() < 0.5 ? `${pick(names)}='${text.replaceAll("'", '')}'` : ''}></volume-view>`;
  return `<!doctype html><html lang='${pick(['de', text.replaceAll("'", '')])}'><title>${text}</title><body ${pick(['', 'onload="hostile = 1"', 'class="x"'])}>${view}${part}`;
}

// ---- What is watched ----

/** Runs in each frame before its page: notes what must not be in the page for frames, whenever it is there, and sends `shown` with the number of views. */
function watch(): void {
  if (!/\/(?:embed|listed)\.html$/.test(location.pathname)) return;
  const note = (text: string): void =>
    void (window as unknown as { noteFault(text: string): Promise<void> }).noteFault(text);
  addEventListener('error', ({ message }) => message && note(`error: ${message}`));
  const noteInternal = ({ detail }: CustomEvent<{ code?: string; message?: string } | null>): void =>
    void (detail?.code === 'internal' && note(`a mistake of the element: ${detail.message}`));
  document.addEventListener('error', (event) => noteInternal(event as unknown as CustomEvent), true);
  addEventListener('unhandledrejection', ({ reason }) => note(`rejection: ${String(reason)}`));
  Object.defineProperty(window, 'hostile', {
    set: () => {
      note('a script of the attacker ran');
    },
  });
  const isLesson = /[?&]lesson=/.test(location.search);
  const isFrom = (address: string, folder: string): boolean =>
    new URL(address, location.href).href.startsWith(new URL(folder, location.href).href);
  const isAllowed = (element: Element): boolean => {
    if (element instanceof HTMLScriptElement) return isFrom(element.src, '.');
    if (element instanceof HTMLLinkElement) return isFrom(element.href, '.');
    if (!(element instanceof HTMLImageElement)) return false;
    return (
      element.className === 'poster' || element.closest('.poster') !== null || (isLesson && isFrom(element.src, '/'))
    );
  };
  const check = (element: Element): void => {
    const { localName } = element;
    const isRisk = /^(?:script|iframe|frame|object|embed|base|meta|form|img|link|animate|template)$/.test(localName);
    if (isRisk && !isAllowed(element) && !element.matches('head > meta')) note(`<${localName}>`);
    for (const { name, value } of element.attributes) {
      const start = value.replace(/[\t\n\r]/g, '').trimStart();
      const isScript = name.startsWith('on') || /^(?:javascript|vbscript|data|file|blob):/i.test(start);
      const isStyle = name === 'style' && value.includes('canary');
      const isOther = localName === 'volume-view' && !isLesson && /^(?:style|id|class|slot|is|part)$/.test(name);
      if (isScript || isStyle || isOther) note(`<${localName} ${name}="${value.slice(0, 50)}">`);
    }
  };
  const observer = new MutationObserver((changes) => {
    for (const { target, addedNodes } of changes)
      for (const one of [target, ...addedNodes])
        if (one instanceof Element) [one, ...(one === target ? [] : one.querySelectorAll('*'))].forEach(check);
  });
  const observe = (root: Node): void => observer.observe(root, { subtree: true, childList: true, attributes: true });
  observe(document);
  const { attachShadow } = Element.prototype;
  Element.prototype.attachShadow = function (this: Element, options) {
    const root = attachShadow.call(this, options);
    observe(root);
    return root;
  };
  const sendShown = async (): Promise<void> => {
    const wait = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));
    while (!document.querySelector('main > *')) await wait(2);
    document.querySelector<HTMLElement>('.poster > button')?.click();
    await wait(0);
    const view = document.querySelector<HTMLElementTagNameMap['volume-view']>('volume-view:defined');
    if (view) await Promise.race([view.whenRendered().catch(() => {}), wait(100)]);
    parent.postMessage(`shown ${document.querySelectorAll('volume-view').length}`, '*');
  };
  addEventListener('load', () => void sendShown());
}

/** Everything of a page that must not be there becomes one of `faults`. */
async function watchPage(page: Page): Promise<void> {
  faults = [];
  page.on('dialog', (dialog) => (faults.push(`dialog: ${dialog.message()}`), void dialog.dismiss()));
  page.on('popup', (popup) => faults.push(`window: ${popup.url()}`));
  page.on('download', (download) => faults.push(`download: ${download.url()}`));
  page.on('pageerror', ({ message }) => faults.push(`page error: ${message}`));
  await page.exposeFunction('noteFault', (text: string) => void faults.push(text));
  await page.addInitScript(watch);
}

interface Answer {
  readonly id?: number;
  readonly ok?: boolean;
  readonly problem?: string;
  readonly attributes?: Record<string, string>;
  readonly event?: string;
}
interface ParentPage extends Window {
  messages: (() => unknown)[];
  heard: (Answer | string)[];
}

/** A page around frames: it keeps what it hears, and has what messages are made of. */
const makeParent = (frames: string, messages: readonly string[] = []): string => `<!doctype html>
<meta charset="utf-8"><title>A page around frames</title><script>
  const nested = (n) => (n === 0 ? 'x' : { a: nested(n - 1) });
  const many = (n) => Object.fromEntries(Array.from({ length: n }, (_, i) => ['x' + i, 'x']));
  var heard = [];
  var messages = [${messages
    .map((one) => `() => (${one})`)
    .join(',\n')
    .replaceAll('</', '<\\/')}];
  addEventListener('message', ({ data }) => heard.push(data));
</script>${frames}`;
const frameOf = (address: string, more = ''): string =>
  `<iframe src="${address}" width="120" height="90" style="border: 0" title="A frame" ${more}></iframe>`;

/** The messages that a page has heard, except those of these tests. */
const heardBy = async (frame: Frame | Page): Promise<Answer[]> =>
  (await frame.evaluate(() => (window as unknown as ParentPage).heard)).filter((one) => typeof one === 'object');

const waitShown = (frame: Frame | Page, count = 1): Promise<unknown> =>
  frame.waitForFunction(
    (expected) => (window as unknown as ParentPage).heard.filter((one) => typeof one === 'string').length >= expected,
    count,
  );

const viewIn = async (frame: Frame): Promise<Picture> => {
  const bytes = await frame.locator('volume-view').evaluate(async (element) => {
    const view = element as HTMLElementTagNameMap['volume-view'];
    await view.whenRendered();
    return [...new Uint8Array(await (await view.toBlob()).arrayBuffer())];
  });
  return decodePicture(Uint8Array.from(bytes));
};

/** Sends requests with ids from 1e6 to the frame of a page, and waits for the answer to the last one. */
const ask = (around: Frame | Page, requests: readonly object[]): Promise<Answer[]> =>
  around.evaluate(async (list) => {
    const own = window as unknown as ParentPage;
    const ids = list.map((_, i) => 1e6 + own.heard.length * 100 + i);
    list.forEach((one, i) => frames[0].postMessage({ volumeView: 1, id: ids[i], ...one }, '*'));
    const answers = (): Answer[] =>
      own.heard.filter((one): one is Answer => typeof one === 'object' && ids.includes(one.id!));
    while (answers().length < ids.length) await new Promise((resolve) => setTimeout(resolve, 5));
    return answers();
  }, requests);

test.use({ bypassCSP: true, allowedLines: /^(?!page error)/ });

const query = 'src=/field.nii.gz&alt=A+field&transfer-function=gray&steps=30';
/** All attributes of the view, as this address has them. */
const asAtFirst: Record<string, string | null> = {
  ...Object.fromEntries(names.map((name) => [name, null])),
  ...Object.fromEntries(new URLSearchParams(query)),
};

test('1,000 messages of a hostile page run nothing and bring nothing in, and the frame goes on', async ({ page }) => {
  await watchPage(page);
  const messages = Array.from({ length: 1000 }, (_, i) => makeMessage(i + 1));
  made['/hostile.html'] = makeParent(frameOf(`${site}/dist/embed.html?${query}`, 'sandbox="allow-scripts"'), messages);
  await page.goto(`${attacker}/hostile.html`);
  await waitShown(page);
  const [, frame] = page.frames();
  const before = await viewIn(frame);
  expect(before.data.some((x) => x > 80)).toBe(true);
  page.on('framenavigated', (moved) => faults.push(`${moved.url()} was opened`));

  // Some at a time, so that the view draws with what it got.
  for (let i = 0; i < messages.length; i += 40) {
    await page.evaluate((first) => {
      for (const make of (window as unknown as ParentPage).messages.slice(first, first + 40))
        frames[0].postMessage(make(), '*');
    }, i);
    await ask(page, [{ get: true }]);
    await frame.evaluate(() => new Promise((resolve) => setTimeout(resolve, 30)));
  }
  const answers = (await heardBy(page)).filter(({ id = 0 }) => Number.isInteger(id) && id > 0 && id <= 1000);
  expect(new Set(answers.map(({ id }) => id)).size).toBe(answers.length);
  expect(answers.filter(({ ok }) => ok).length).toBeGreaterThan(300);
  expect(answers.filter(({ problem }) => typeof problem === 'string').length).toBeGreaterThan(300);

  const [, { attributes }] = await ask(page, [{ set: asAtFirst }, { get: true }]);
  expect(attributes).toMatchObject(Object.fromEntries(new URLSearchParams(query)));
  expect(compare(await viewIn(frame), before).worst).toBe(0);
  expect(faults).toEqual([]);
});

test('a frame that talks with one site hears no other one, and answers no other one', async ({ page }) => {
  await watchPage(page);
  const address = `${site}/dist/listed.html?${query}&parent=${friend}`;
  const messages = Array.from({ length: 200 }, (_, i) => makeMessage(i));
  made['/friend.html'] = makeParent(frameOf(address));
  made['/third.html'] = makeParent('', messages);
  made['/hostile.html'] = makeParent(
    [address, `${friend}/friend.html`, `${attacker}/third.html`].map((one) => frameOf(one)).join(''),
    messages,
  );
  await page.goto(`${attacker}/hostile.html`);
  const [around, third] = ['/friend.html', '/third.html'].map((path) =>
    page.frames().find((one) => one.url().endsWith(path))!,
  );
  await waitShown(page);
  await waitShown(around);
  const [own, framed] = [page.mainFrame(), around].map((one) => one.childFrames()[0]);
  const before = await viewIn(framed);

  // From the page around the one frame, and to the other one from the page around its friend and from a frame beside it.
  const wishes = [{ get: true }, { set: { steps: '3' } }, { events: eventTypes }, { step: 'next' }];
  const send = (from: Frame | Page, target: string): Promise<void> =>
    from.evaluate(
      ([path, list]) => {
        const to = path === 'own' ? frames[0] : top!.frames[1].frames[0];
        for (const make of (window as unknown as ParentPage).messages) to.postMessage(make(), '*');
        list.forEach((one, i) => to.postMessage({ volumeView: 1, id: i, ...one }, '*'));
      },
      [target, wishes] as const,
    );
  await Promise.all([send(page, 'own'), send(page, 'other'), send(third, 'other')]);
  // Events go to the friend alone.
  await ask(around, [{ events: eventTypes }, { set: { src: '/field.nii.gz?again' } }]);
  await around.waitForFunction(() =>
    (window as unknown as ParentPage).heard.some((one) => typeof one === 'object' && one?.event === 'load'),
  );
  for (const one of [page, third]) expect((await heardBy(one)).filter(({ event }) => event !== 'ready')).toEqual([]);
  for (const one of [own, framed]) await expect(one.locator('volume-view')).toHaveAttribute('steps', '30');

  const [, { attributes }] = await ask(around, [{ set: asAtFirst }, { get: true }]);
  expect(attributes).toMatchObject({ steps: '30', src: '/field.nii.gz' });
  for (const one of [own, framed]) expect(compare(await viewIn(one), before).worst).toBe(0);
  expect(faults).toEqual([]);
});

test('hundreds of hostile addresses and lessons run nothing and bring nothing in', async ({ page }) => {
  await watchPage(page);
  made['/hostile.html'] = makeParent('');
  await page.goto(`${attacker}/hostile.html`);
  const opened: string[] = [];
  page.on('framenavigated', (moved) => moved.url() !== 'about:blank' && opened.push(moved.url()));
  /** In frames of the attacker's page, one after the other. @returns how many of them have a view */
  const openAll = (addresses: readonly string[]): Promise<number> =>
    page.evaluate(async (list) => {
      let views = 0;
      for (const address of list) {
        const frame = document.createElement('iframe');
        frame.src = address;
        const shown = new Promise<unknown>((resolve, reject) => {
          window.onmessage = ({ data, source }) => {
            if (source === frame.contentWindow && typeof data === 'string') resolve(data);
          };
          setTimeout(() => reject(new Error(`it shows nothing: ${address}`)), 20_000);
        });
        document.body.append(frame);
        views += Number((await shown) !== 'shown 0');
        frame.remove();
      }
      return views;
    }, addresses);
  const lessons = Array.from({ length: 40 }, (_, i) => `/lessons/${i}.html`);
  for (const path of lessons) made[path] = makeLesson();
  // Without the element the page's own code makes the same tags, so these are quick; the element itself has met such texts in messages.
  const queries = Array.from({ length: 300 }, makeQuery);
  const ofLessons = lessons.map((path) => `?lesson=${path}`);
  const quick = `${quickSite}/dist/embed.html`;
  const whole = [...queries, ...ofLessons].filter((_, i) => i % 20 === 0).map((one) => `${site}/dist/embed.html${one}`);
  const views = {
    queries: await openAll(queries.map((one) => quick + one)),
    lessons: await openAll(ofLessons.map((one) => quick + one)),
    whole: await openAll(whole),
  };
  expect(faults).toEqual([]);
  expect(opened.filter((one) => new URL(one).pathname !== '/dist/embed.html')).toEqual([]);
  expect(opened.length).toBe(queries.length + lessons.length + whole.length);
  // Most addresses name a file, and some lessons have what a lesson may have.
  expect(views.queries).toBeGreaterThan(150);
  expect(views.lessons).toBeGreaterThan(4);
  expect(views.whole).toBeGreaterThan(5);
});

test.describe('a page that is broken into', () => {
  test.use({ allowedLines: /./ });

  test('has all that these tests look for', async ({ page }) => {
    await watchPage(page);
    made['/hostile.html'] = makeParent(
      frameOf(`${quickSite}/dist/embed.html?src=/field.nii.gz`, 'sandbox="allow-scripts"'),
    );
    await page.goto(`${attacker}/hostile.html`);
    await waitShown(page);
    await page.frames()[1].evaluate(() => {
      const main = document.querySelector('main')!;
      const shadow = main.appendChild(document.createElement('div')).attachShadow({ mode: 'open' });
      main.insertAdjacentHTML(
        'beforeend',
        '<img src="/canary/image" onerror="hostile = 1"><a href="javascript:hostile=1">x</a>',
      );
      shadow.innerHTML = '<iframe></iframe>';
      document.querySelector('volume-view')!.id = 'x';
      setTimeout(() => void Promise.reject(new Error('wrong')));
    });
    await expect
      .poll(() => [...new Set(faults)])
      .toEqual(
        expect.arrayContaining([
          '<a href="javascript:hostile=1">',
          '<iframe>',
          '<img onerror="hostile = 1">',
          '<img>',
          '<volume-view id="x">',
          'a script of the attacker ran',
          'page error: wrong',
          'rejection: Error: wrong',
          'the browser asked for /canary/image',
        ]),
      );
  });
});
