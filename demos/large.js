// A stone that no server has: workers compute each chunk that the element asks for. On a web server, `src` alone would do.
import { startWorkers } from './large/ask-workers.js';

const view = document.querySelector('#stone');
const state = document.querySelector('#state');
const fields = new Map([...document.querySelectorAll('[data-stat]')].map((cell) => [cell.dataset.stat, cell]));

const folder = new URL('stone.ome.zarr/', location.href).href;
const counts = { chunks: 0, bytes: 0 };

const { ask } = startWorkers(Math.min(4, Math.max(1, (navigator.hardwareConcurrency ?? 2) - 1)));

/** Answers as a web server with the folder would. */
async function compute(url, { signal } = {}) {
  const path = String(url).slice(folder.length);
  const body = await ask(path, signal);
  if (path.includes('/c/')) counts.chunks++;
  counts.bytes += body?.length ?? 0;
  return new Response(body, { status: body ? 200 : 404 });
}

view.fetch = (url, options) => (String(url).startsWith(folder) ? compute(url, options) : fetch(url, options));

const places = {
  stone: { 'camera-target': null, 'camera-orbit': '30deg 68deg 72%' },
  side: { 'camera-target': '-5.222 -1.368 3.131', 'camera-orbit': '30deg 68deg 18%' },
  grain: { 'camera-target': '-5.222 -1.368 3.131', 'camera-orbit': '30deg 68deg 4%' },
};

const settings = {
  place: (name) => {
    for (const [attribute, value] of Object.entries(places[name]))
      if (value === null) view.removeAttribute(attribute);
      else view.setAttribute(attribute, value);
  },
  bytes: (value) => view.setAttribute('max-gpu-bytes', value),
  error: (value) => view.setAttribute('max-error', value),
};

for (const input of document.querySelectorAll('.choices input')) {
  if (input.checked) settings[input.name](input.value);
  input.addEventListener('change', () => settings[input.name](input.value));
}
view.setAttribute('src', folder);

const megabytes = (bytes) => `${(bytes / 1e6).toFixed(1)} MB`;
const inShades = (error) => (error ? `${error.rms.toFixed(2)} / 255` : '…');

function show() {
  const { bricks, error, converged } = view.renderStats ?? {};
  fields.get('chunks').textContent = counts.chunks.toLocaleString('en');
  fields.get('read').textContent = megabytes(counts.bytes);
  fields.get('bricks').textContent = (bricks?.count ?? 0).toLocaleString('en');
  fields.get('bytes').textContent = bricks ? megabytes(bricks.bytes) : '–';
  fields.get('steps').textContent = inShades(error?.parts?.steps);
  fields.get('detail').textContent = inShades(error?.parts?.detail);
  state.textContent = converged ? 'This is the final picture of this view.' : 'Bricks are being computed …';
}

view.addEventListener('render', show);
setInterval(show, 500);
