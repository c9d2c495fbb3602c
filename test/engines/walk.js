// A random walk through an element's life: `walk.html?steps=60&seed=1`. After every 20 steps it has to be as a fresh one is; at the
// end nothing of it may be left in the page. The steps are in walk-steps.js; the same seed takes the same ones.
import { plain, steps } from './walk-steps.js';

const options = new URLSearchParams(location.search);
const length = Number(options.get('steps') ?? 60);
let state = Number(options.get('seed') ?? 1) >>> 0;
const limitMs = 30_000;
const between = 20;

const counts = window.__counts;
const smoke = (window.__smoke = { done: false, passed: [], failed: [], step: 0 });
const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const nextFrame = () => Promise.race([new Promise(requestAnimationFrame), sleep(100)]);

/** Marsaglia's xorshift: 0 to 1. */
function dice() {
  state ^= state << 13;
  state ^= state >>> 17;
  state ^= state << 5;
  state >>>= 0;
  return state / 2 ** 32;
}
dice((state ||= 1));
const pick = (list) => list[Math.floor(dice() * list.length)];

function withLimit(promise, what) {
  let timer;
  const late = new Promise(
    (_, reject) =>
      (timer = setTimeout(() => reject(new Error(`${what} did not settle within ${limitMs / 1000} s`)), limitMs)),
  );
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}

function makePlaces() {
  const main = document.createElement('main');
  main.innerHTML = '<div></div><dialog></dialog><details></details><p></p>';
  const [body, dialog, details, host] = main.children;
  document.body.append(main);
  let frame = null;
  return {
    main,
    body,
    dialog,
    details,
    shadow: host.attachShadow({ mode: 'open' }),
    frame() {
      if (!frame) main.append((frame = document.createElement('iframe')));
      return frame.contentDocument.body;
    },
    dropFrame() {
      frame?.remove();
      frame = null;
    },
  };
}

/** All that a page's author, a script or a hand did to it is undone. */
function makePlain(element) {
  for (const name of element.getAttributeNames()) if (!(name in plain)) element.removeAttribute(name);
  for (const [name, value] of Object.entries(plain))
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  element.pause();
  element.replaceChildren();
}

async function pictureOf(element) {
  element.scrollIntoView();
  await withLimit(element.whenRendered(), 'whenRendered()');
  const bitmap = await createImageBitmap(await withLimit(element.toBlob(), 'toBlob()'));
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext('2d');
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, bitmap.width, bitmap.height);
}

/** What helps to understand a wrong picture. */
function describe(element) {
  const { shadowRoot, renderStats, optics, clientWidth, clientHeight } = element;
  const parts = [...shadowRoot.querySelectorAll('canvas, .error')].map(
    (one) => `${one.localName} ${one.width ?? ''}x${one.height ?? ''} ${one.textContent.trim()}`,
  );
  const sheets = shadowRoot.adoptedStyleSheets.length;
  return JSON.stringify({
    markup: element.outerHTML,
    parts,
    sheets,
    renderStats,
    clientWidth,
    clientHeight,
    window: optics?.window,
  });
}

function compare(got, expected) {
  if (got.width !== expected.width || got.height !== expected.height)
    throw new Error(`${got.width} x ${got.height} pixels; a fresh one has ${expected.width} x ${expected.height}`);
  const worst = got.data.reduce((most, x, i) => Math.max(most, Math.abs(x - expected.data[i])), 0);
  if (worst > 1) throw new Error(`differs by ${worst}/255 from a fresh one`);
}

/** Wait until what comes later, as the garbage of a frame, is gone. */
async function comeToRest(wanted) {
  let now = counts.read();
  for (let i = 0; i < 40 && !Object.keys(wanted).every((name) => now[name] <= wanted[name]); i++) {
    await sleep(50);
    now = counts.read();
  }
  return now;
}

const heap = () => {
  window.gc?.();
  return window.gc ? performance.memory.usedJSHeapSize : 0;
};

const fresh = async () => {
  const element = document.createElement('volume-view');
  makePlain(element);
  document.body.append(element);
  const picture = await pictureOf(element);
  element.remove();
  await sleep(50);
  return picture;
};

const trail = [];
async function walkOn(places, elements, expected) {
  const asked = new Set();
  const ask = (promise) => {
    const settled = promise.catch(() => {}).then(() => asked.delete(settled));
    asked.add(settled);
  };
  for (let count = 1; count <= length; count++) {
    await sleep(0); // What follows a promise may be within a ResizeObserver's notification, where no layout may change.
    const name = pick(Object.keys(steps));
    const which = Math.floor(dice() * elements.length);
    trail.push(`${name} (${which})`);
    steps[name]({ element: elements[which], pick, places, counts, ask, count });
    smoke.step = count;
    const pause = dice();
    if (pause > 0.7) await sleep(pause * 60);
    else if (pause > 0.2) await nextFrame();
    if (count % between !== 0 && count !== length) continue;
    await sleep(0);
    counts.deaf = 0;
    delete window.devicePixelRatio;
    Object.defineProperty(window, 'devicePixelRatio', { configurable: true, value: 1 });
    places.dialog.close();
    places.body.append(...elements);
    for (const element of elements) element.setAttribute('camera-orbit', '0deg 0deg 100%'); // Another place: a hand's turns are given up.
    await Promise.all(elements.map((element) => element.updateComplete));
    elements.forEach(makePlain);
    await nextFrame();
    for (const [i, element] of elements.entries()) {
      try {
        compare(await pictureOf(element), expected);
      } catch (error) {
        throw new Error(`element ${i}: ${error.message}; ${describe(element)}`, { cause: error });
      }
    }
    await withLimit(Promise.all(asked), 'a promise that was given out');
    trail.splice(0);
  }
}

async function walk() {
  await customElements.whenDefined('volume-view');
  Object.defineProperty(window, 'devicePixelRatio', { configurable: true, value: 1 });
  const expected = await fresh();
  if (!expected.data.some((x) => x > 80)) throw new Error('the fresh picture is empty');
  compare(await fresh(), expected);
  const before = await comeToRest(counts.read());
  const heapBefore = heap();
  let places = makePlaces();
  let elements = Array.from({ length: 3 }, () => document.createElement('volume-view'));
  places.body.append(...elements);
  await walkOn(places, elements, expected);
  smoke.passed.push(
    `${length} steps, seed ${options.get('seed') ?? 1}: the picture is that of a fresh element, and all promises settle`,
  );
  places.main.remove();
  elements = places = null;
  const after = await comeToRest(before);
  for (const name of Object.keys(before)) {
    if (after[name] <= before[name]) smoke.passed.push(`${name} are back at ${after[name]}`);
    else smoke.failed.push(`${name} are back: ${after[name]}, at first ${before[name]} (${counts.listeners()})`);
  }
  // What was compiled for the first time stays, and some garbage needs more than one round.
  let grown = Infinity;
  for (let i = 0; i < 10 && grown >= 12; i++) {
    await sleep(200);
    grown = (heap() - heapBefore) / 2 ** 20;
  }
  if (grown < 20)
    smoke.passed.push(
      `the heap has grown by ${grown.toFixed(1)} MB${window.gc ? '' : ' (not measured in this engine)'}`,
    );
  else smoke.failed.push(`the heap has grown by ${grown.toFixed(1)} MB`);
}

try {
  await walk();
} catch (error) {
  smoke.failed.push(`${error?.message ?? error}, after step ${smoke.step}: ${trail.join(', ')}`);
}
smoke.done = true;
