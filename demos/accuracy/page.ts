// The accuracy page: shows stored results first, and measures and draws when the reader asks for it.
import type { StudyMethod } from '../../src/renderer/study.ts';
import { showChart } from './charts.ts';
import type { ChartLine } from './charts.ts';
import { comparePictures } from './compare-pictures.ts';
import { describeResults } from './findings.ts';
import type { StudyPictures } from './pictures.ts';
import { methodNames } from './results.ts';
import type { FunctionResults, SceneResults, StudyResults } from './results.ts';
import { studyMethods, studySteps } from './scene-setup.ts';
import storedResults from './results.json';
import { error, listTables, toCsv } from './tables.ts';
import type { Table } from './tables.ts';

const stored = storedResults as StudyResults;

/** Pixels along each side of the pictures, and of a measurement on this device. */
const pictureSize = 256;
const measureSizes = { size: 128, timeSize: 256 } as const;

/** What comes with the package; larger data may lie beside the checkout. */
const ownScenes = ['mni152', 'ct-phantom'] as const;

/** The volume of the pictures that come with the page. */
const storedScene = 'mni152';

const dashes: Readonly<Record<StudyMethod, readonly number[]>> = { printed: [2, 4], plain: [8, 5], shipped: [] };

const state = { results: stored, scene: storedScene as string, fn: 'smooth', method: 'shipped' as StudyMethod };
let takeDown: (() => void)[] = [];
let pictures: StudyPictures | null = null;
let drawing: AbortController | null = null;
let measuring: AbortController | null = null;

function find<T extends HTMLElement = HTMLElement>(id: string): T {
  return document.querySelector<T>(`#${id}`)!;
}

/** Radio buttons in the style of the other pages. */
function offer(
  id: string,
  choices: readonly { id: string; name: string }[],
  chosen: string,
  choose: (id: string) => void,
): void {
  find(id).replaceChildren(
    ...choices.map((choice) => {
      const label = document.createElement('label');
      label.className = 'choice';
      const input = Object.assign(document.createElement('input'), { type: 'radio', name: id, value: choice.id });
      input.checked = choice.id === chosen;
      input.addEventListener('change', () => choose(choice.id));
      label.append(input, Object.assign(document.createElement('span'), { textContent: choice.name }));
      return label;
    }),
  );
}

function currentScene(): { scene: SceneResults; fn: FunctionResults } | null {
  const { scenes } = state.results;
  const scene = scenes.find(({ id }) => id === state.scene) ?? scenes[0];
  const fn = scene?.functions.find(({ id }) => id === state.fn);
  return scene && fn ? { scene, fn } : null;
}

function showAll(): void {
  const { results } = state;
  find('headline').textContent = describeResults(results);
  const { browser, renderer, software, threads, note } = results.where;
  find('where').textContent =
    `${results === stored ? 'Stored results, measured' : 'Measured here'} with ${browser}, ${renderer}` +
    `${software ? `, which is a graphics processor in software on ${threads} threads: its times tell proportions, not what your device takes` : ''}. ` +
    `Errors at ${results.size} × ${results.size} pixels, times at ${results.timeSize} × ${results.timeSize}.${note ? ` ${note}` : ''}`;
  offer('volumes', results.scenes, currentScene()?.scene.id ?? '', (id) => {
    state.scene = id;
    find('trio').hidden = true;
    showScene();
  });
  find('tables').replaceChildren(...listTables(results).map(showTable));
  showScene();
}

function showScene(): void {
  for (const end of takeDown) end();
  takeDown = [];
  const current = currentScene();
  if (!current) return;
  const { scene, fn } = current;
  state.scene = scene.id;
  offer('functions', scene.functions, fn.id, (id) => {
    state.fn = id;
    showScene();
  });
  const errors = lines((method) =>
    fn.errors.filter((row) => row.method === method).map(({ steps, rms }) => [steps, Math.max(rms, 1e-3)]),
  );
  takeDown.push(
    showChart(find('error-chart'), {
      xLabel: 'steps',
      yLabel: 'error, 1/255',
      lines: errors,
      description: `Error against steps, ${scene.name}, ${fn.name}; the same numbers are in the tables below`,
    }),
  );
  showTimes(scene, fn);
  showStored();
  if (pictures) void drawPictures();
}

/** The pictures that come with the page stand there for no other volume, and until others are drawn. */
function showStored(): void {
  find('sheet').hidden = state.scene !== storedScene || !find('trio').hidden;
}

function showTimes(scene: SceneResults, fn: FunctionResults): void {
  const timeOf = (method: StudyMethod, steps: number): number | undefined =>
    scene.times.find((row) => row.percent === 100 && row.method === method && row.steps === steps)?.ms;
  if (scene.times.length === 0) {
    for (const id of ['time-chart', 'trade-chart']) find(id).textContent = 'This volume was not timed.';
    return;
  }
  const times = lines((method) =>
    scene.times.filter((row) => row.method === method && row.percent === 100).map(({ steps, ms }) => [steps, ms]),
  );
  const trade = lines((method) =>
    fn.errors.flatMap(({ method: of, steps, rms }): [number, number][] => {
      const ms = of === method ? timeOf(method, steps) : undefined;
      return ms === undefined ? [] : [[ms, Math.max(rms, 1e-3)]];
    }),
  );
  takeDown.push(
    showChart(find('time-chart'), {
      xLabel: 'steps',
      yLabel: 'time, ms',
      lines: times,
      description: `Time against steps, ${scene.name}`,
    }),
    showChart(find('trade-chart'), {
      xLabel: 'time, ms',
      yLabel: 'error, 1/255',
      lines: trade,
      description: `Error against time, ${scene.name}, ${fn.name}`,
    }),
  );
}

function lines(pointsOf: (method: StudyMethod) => [number, number][]): ChartLine[] {
  return studyMethods.map((method) => ({
    name: methodNames[method],
    color: `--${method}`,
    dash: dashes[method],
    points: pointsOf(method),
  }));
}

function showTable(table: Table): HTMLElement {
  const details = document.createElement('details');
  details.open = table.id === 'one-step-a-voxel';
  const element = document.createElement('table');
  const head = element.createTHead().insertRow();
  for (const column of table.columns) {
    head.append(Object.assign(document.createElement('th'), { scope: 'col', textContent: column }));
  }
  const body = element.createTBody();
  for (const row of table.rows) {
    const line = body.insertRow();
    for (const cell of row) line.insertCell().textContent = String(cell);
  }
  const scroll = Object.assign(document.createElement('div'), { className: 'scroll', tabIndex: 0 });
  scroll.setAttribute('role', 'region');
  scroll.setAttribute('aria-label', table.title);
  scroll.append(element);
  const buttons = Object.assign(document.createElement('div'), { className: 'buttons' });
  const save = Object.assign(document.createElement('button'), { type: 'button', textContent: 'Download as CSV' });
  save.addEventListener('click', () => saveCsv(table));
  buttons.append(save);
  details.append(Object.assign(document.createElement('summary'), { textContent: table.title }), scroll, buttons);
  return details;
}

function saveCsv(table: Table): void {
  const url = URL.createObjectURL(new Blob([toCsv(table)], { type: 'text/csv' }));
  Object.assign(document.createElement('a'), { href: url, download: `${table.id}.csv` }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

function chosenSteps(): number {
  return studySteps[Number(find<HTMLInputElement>('steps').value)];
}

async function drawPictures(): Promise<void> {
  drawing?.abort();
  const own = (drawing = new AbortController());
  const message = find('picture-message');
  message.textContent = 'Drawing …';
  try {
    const { StudyPictures } = await import('./pictures.ts');
    // A slider moves fast, and what is being drawn can't be stopped.
    await new Promise((resolve) => setTimeout(resolve, 150));
    own.signal.throwIfAborted();
    pictures ??= new StudyPictures(pictureSize);
    const { scene, fn, method } = state;
    const steps = chosenSteps();
    const drawn = await pictures.draw({ scene, fn, method, steps }, own.signal);
    for (const name of ['picture', 'limit', 'difference'] as const) {
      const canvas = find<HTMLCanvasElement>(name);
      canvas.width = canvas.height = pictureSize;
      canvas.getContext('2d')!.putImageData(drawn[name], 0, 0);
    }
    find('trio').hidden = false;
    showStored();
    const { rms, p99 } = comparePictures(...drawn.floats);
    message.textContent = `${methodNames[method]}, ${steps} steps: root mean square ${error(rms)}, 99th percentile ${error(p99)}, in 1/255.`;
  } catch (cause) {
    if (own.signal.aborted) return;
    message.textContent = sayWhy(cause);
    find('trio').hidden = true; // It may show another volume.
    showStored();
  }
}

async function measure(): Promise<void> {
  const own = (measuring = new AbortController());
  const progress = find<HTMLProgressElement>('progress');
  const message = find('measure-message');
  const buttons = { start: find<HTMLButtonElement>('measure'), stop: find('stop'), stored: find('stored') };
  buttons.start.disabled = true;
  buttons.stop.hidden = progress.hidden = false;
  try {
    const { runStudy } = await import('./study.ts');
    state.results = await runStudy({
      scenes: ownScenes,
      timed: ownScenes,
      ...measureSizes,
      repeats: 5,
      signal: own.signal,
      onProgress: (share, what) => {
        progress.value = share;
        message.textContent = what;
      },
    });
    message.textContent = 'Done: the charts and tables show the numbers of this device.';
    buttons.stored.hidden = false;
    showAll();
  } catch (cause) {
    message.textContent = own.signal.aborted ? 'Stopped.' : sayWhy(cause);
  } finally {
    buttons.start.disabled = false;
    buttons.stop.hidden = progress.hidden = true;
  }
}

function sayWhy(cause: unknown): string {
  return cause instanceof Error ? cause.message : String(cause);
}

function showSteps(): void {
  const text = `${chosenSteps()}`;
  find('steps-shown').textContent = text;
  find('steps').setAttribute('aria-valuetext', `${text} steps`);
}

offer(
  'methods',
  studyMethods.map((id) => ({ id, name: methodNames[id] })),
  state.method,
  (id) => {
    state.method = id as StudyMethod;
    if (pictures) void drawPictures();
  },
);
find('steps').addEventListener('input', () => {
  showSteps();
  if (pictures) void drawPictures();
});
find('draw').addEventListener('click', () => void drawPictures());
find('measure').addEventListener('click', () => void measure());
find('stop').addEventListener('click', () => measuring?.abort());
find('stored').addEventListener('click', () => {
  state.results = stored;
  find('stored').hidden = true;
  showAll();
});
showSteps();
showAll();
