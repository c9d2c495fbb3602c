// What an error that may be left buys: the picture, the exact one, their difference, and what the element says about it.
import { compareImages, readPicture } from './trade/compare-images.js';

const scenes = {
  brain: { src: 'data/mni152-t1.nii.gz', 'camera-orbit': '30deg 70deg auto' },
  fog: { src: 'data/mni152-t1.nii.gz', look: 'flat', 'camera-orbit': '30deg 70deg auto' },
  bones: { src: 'data/ct-phantom.json', 'transfer-function': 'ct-bone', 'camera-orbit': '25deg 80deg auto' },
  storm: { src: 'data/storm-synthetic.json', 'camera-orbit': '30deg 75deg auto' },
};
const sceneAttributes = [...new Set(Object.values(scenes).flatMap(Object.keys))];

/** By how much the difference is multiplied before it is shown. */
const amplification = 16;
/** Each picture is read before this colour, whatever the page is like. */
const background = [0, 0, 0];

const view = document.querySelector('#picture');
const exact = document.querySelector('#exact');
const slider = document.querySelector('#max-error');
const found = document.querySelector('#found');
const number = new Intl.NumberFormat('en', { maximumFractionDigits: 2 });
const chosen = (name) => document.querySelector(`[name="${name}"]:checked`).value;
const maxError = () => 2 ** Number(slider.value);

function setStat(name, text) {
  document.querySelector(`[data-stat="${name}"]`).textContent = text;
}

/** Counts what was asked for: an answer to an older question is not shown. */
let asked = 0;

/** Draw the picture, then the exact one, and say how far they are apart. */
async function compare() {
  const own = ++asked;
  const since = performance.now();
  const isLoaded = view.volume !== null;
  found.textContent = 'The picture is being drawn …';
  await view.whenRendered();
  if (own !== asked || !view.renderStats) return;
  const ms = `${number.format(Math.round(performance.now() - since))} ms`;
  showStats(view.renderStats, isLoaded ? ms : `${ms}, with loading`);
  found.textContent = 'The exact picture is being drawn …';
  followScene();
  await exact.whenRendered();
  if (own !== asked) return;
  const [picture, all] = await Promise.all([readPicture(view, background), readPicture(exact, background)]);
  if (own !== asked) return;
  if (picture.width !== all.width || picture.height !== all.height) return void (found.textContent = '');
  const { rms, max, difference } = compareImages(picture, all, background, amplification);
  const canvas = document.querySelector('#missing');
  canvas.width = difference.width;
  canvas.height = difference.height;
  canvas.getContext('2d', { willReadFrequently: true }).putImageData(difference, 0, 0);
  setStat('true', `${number.format(rms)} / 255`);
  found.textContent = `The picture differs from the exact one by ${number.format(rms)} (root mean square); ${number.format(maxError())} was allowed. The pixel that is worst differs by ${max}.`;
}

/** @param rest - how long it took to this picture */
function showStats({ error, rays, steps, samples, width, height }, rest) {
  setStat('error', error ? `${number.format(error.rms)} / 255` : '–');
  setStat('true', '…');
  setStat('rest', rest);
  setStat('rays', rays === 1 ? 'all' : `${number.format(100 * rays)} %`);
  setStat('steps', number.format(steps));
  setStat('samples', `${number.format(samples / 1e6)} million`);
  setStat('size', `${width} × ${height} pixels`);
}

function setScene(element, attributes) {
  for (const name of sceneAttributes) {
    if (!(name in attributes)) element.removeAttribute(name);
    else if (element.getAttribute(name) !== attributes[name]) element.setAttribute(name, attributes[name]);
  }
}

/** The exact picture follows when the picture is at rest: it takes long, and would take time from it. */
function followScene() {
  const { orbit, target } = view.camera;
  setScene(exact, { ...scenes[chosen('scene')], 'camera-orbit': orbitOf(orbit) });
  exact.cameraTarget = target;
}

const orbitOf = ({ theta, phi, radius }) => `${theta}rad ${phi}rad ${radius}`;

function showScene() {
  setScene(view, scenes[chosen('scene')]);
  showChoice();
}

function showChoice() {
  const error = maxError();
  document.querySelector('#allowed').textContent = `${number.format(error)} / 255`;
  slider.setAttribute('aria-valuetext', `${number.format(error)} of 255`);
  view.setAttribute('max-error', error);
  view.setAttribute('detail', chosen('detail'));
  // All that makes the picture, so that the tag shows the same one in another page.
  const attributes = { ...scenes[chosen('scene')], 'max-error': number.format(error), detail: chosen('detail') };
  const written = Object.entries(attributes).map(([name, value]) => `${name}="${value}"`);
  document.querySelector('#tag').textContent = `<volume-view ${written.join('\n             ')}></volume-view>`;
  void compare();
}

view.addEventListener('camera-change', () => void compare());
for (const input of document.querySelectorAll('[name="scene"]')) input.addEventListener('change', showScene);
for (const input of document.querySelectorAll('[name="detail"]')) input.addEventListener('change', showChoice);
slider.addEventListener('input', showChoice);
new ResizeObserver(() => void compare()).observe(view);

const stop = document.querySelector('#stop');
const progress = document.querySelector('#progress');
const measured = document.querySelector('#measured');

document.querySelector('#measure').addEventListener('click', ({ currentTarget }) => void measure(currentTarget));

async function measure(button) {
  const aborter = new AbortController();
  stop.onclick = () => aborter.abort();
  button.disabled = true;
  stop.hidden = progress.hidden = false;
  try {
    // TypeScript, with parts of this project's study: it needs the server of `npm start`.
    const { measureTrade } = await import('./trade/measure-trade.ts');
    document.querySelector('#curve').hidden = false;
    await measureTrade(document.querySelector('#chart'), aborter.signal, (share, what) => {
      progress.value = share;
      measured.textContent = what;
    });
  } catch (cause) {
    measured.textContent = aborter.signal.aborted ? 'Stopped.' : `It could not be measured: ${cause.message}`;
  } finally {
    button.disabled = false;
    stop.hidden = progress.hidden = true;
  }
}

document.querySelector('#check').addEventListener('click', ({ currentTarget }) => void check(currentTarget));

async function check(button) {
  button.disabled = true;
  try {
    const result = await view.checkPicture();
    document.querySelector('#checked').textContent = result
      ? tell(result)
      : 'This device can not draw what is needed to check it.';
  } finally {
    button.disabled = false;
  }
}

/** Say how far the graphics processor is from the main one. */
function tell({ rays, off, max, agrees }) {
  const difference = `the largest difference of ${rays} rays is ${number.format(max)} of 255`;
  return agrees ? `It is: ${difference}.` : `It is not: ${off} are off, ${difference}.`;
}

showScene();
