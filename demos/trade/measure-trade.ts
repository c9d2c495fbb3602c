// Measures on the reader's device what an error that may be left saves in time, beside two methods that take the same steps on every ray.
import { showChart } from '../accuracy/charts.ts';
import type { ChartLine } from '../accuracy/charts.ts';
import { background, StudyPictures } from '../accuracy/pictures.ts';
import { median } from '../accuracy/time-pictures.ts';
import { compareImages, readPicture } from './compare-images.js';

/** The volume and the look that all methods can draw, in the same view. */
const scene = { study: { scene: 'mni152', fn: 'smooth' }, src: '/demos/data/mni152-t1.nii.gz' } as const;

/** What is measured. */
export interface TradePlan {
  /** Pixels along each side. */
  readonly size: number;
  /** Values of `max-error`. */
  readonly errors: readonly number[];
  /** How often the volume is turned for each. */
  readonly turns: number;
  /** Of the two other methods. */
  readonly steps: readonly number[];
}

export const wholePlan: TradePlan = {
  size: 256,
  errors: [32, 16, 8, 4, 2, 1, 0.5],
  turns: 3,
  steps: [10, 20, 40, 80, 200, 400, 800],
};

const bytes = background.map((channel) => Math.round(255 * channel));

type Point = readonly [number, number];
type Element = HTMLElement & {
  cameraOrbit: string;
  maxError: number;
  whenRendered(): Promise<void>;
};

/**
 * Draw a chart of error against time, line by line as they are measured.
 * @param onProgress - share of the work, 0..1, and what is being done
 * @returns the lines: times in ms, errors in 1/255
 */
export async function measureTrade(
  container: HTMLElement,
  signal: AbortSignal,
  onProgress: (share: number, what: string) => void,
  { size, errors, turns, steps }: TradePlan = wholePlan,
): Promise<readonly ChartLine[]> {
  const lines: ChartLine[] = [];
  let takeDown = (): void => {};
  const show = (line: Omit<ChartLine, 'points'>, points: Point[]): void => {
    points.sort(([a], [b]) => a - b);
    lines.push({ ...line, points });
    takeDown();
    takeDown = showChart(container, {
      xLabel: 'time, ms',
      yLabel: 'error, 1/255',
      lines,
      description: `Error against time. ${lines.map(describe).join(' ')}`,
    });
  };
  const pictures = new StudyPictures(size);
  const limit = (await pictures.draw({ ...scene.study, method: 'plain', steps: 10 }, signal)).limit;
  let done = 0;
  const tell = (what: string): void => onProgress(done++ / (2 * errors.length + 2 * steps.length), what);
  try {
    const methods = [
      { method: 'printed', name: '2011 paper, as printed', color: '--printed', dash: [2, 4] },
      { method: 'plain', name: 'Plain samples', color: '--plain', dash: [8, 5] },
    ] as const;
    for (const { method, ...line } of methods) {
      const points: Point[] = [];
      for (const count of steps) {
        tell(`${line.name}, ${count} steps`);
        await pause(signal);
        const asked = { ...scene.study, method, steps: count };
        const { picture } = await pictures.draw(asked, signal);
        points.push([await pictures.time(asked, signal), errorOf(picture, limit)]);
      }
      show(line, points);
    }
    const element = placeView(container, size);
    try {
      for (const detail of ['keep', 'free']) {
        const points: Point[] = [];
        element.setAttribute('detail', detail);
        for (const error of errors) {
          tell(`volume-view, ${detail === 'free' ? 'small things may be lost' : 'small things kept'}, error ${error}`);
          points.push(await measurePoint(element, { error, turns, limit }, signal));
        }
        const name = `volume-view, detail="${detail}"`;
        show({ name, color: `--${detail}` }, points);
      }
    } finally {
      element.remove();
    }
    onProgress(1, 'Done.');
    return lines;
  } finally {
    pictures.dispose();
  }
}

/** Time from a turn to the picture at rest, and the error of this picture. */
async function measurePoint(
  element: Element,
  { error, turns, limit }: { error: number; turns: number; limit: ImageData },
  signal: AbortSignal,
): Promise<Point> {
  const times: number[] = [];
  element.maxError = error;
  for (let turn = 0; turn <= turns; turn++) {
    await pause(signal);
    element.cameraOrbit = `${200 + 9 * turn}deg 70deg 100%`;
    await element.whenRendered();
    const began = performance.now();
    element.cameraOrbit = studyOrbit;
    await element.whenRendered();
    if (turn > 0) times.push(performance.now() - began); // The first one may load code and compile programs.
  }
  return [median(times), errorOf(await readPicture(element, bytes), limit)];
}

/** The camera of the study. */
const studyOrbit = '30deg 75deg 100%';

/** Two pictures that are equal in 8 bits still have an error, below what can be seen: the axis is logarithmic. */
const errorOf = (picture: ImageData, limit: ImageData): number =>
  Math.max(0.05, compareImages(picture, limit, bytes, 1).rms);

/** A view of the size of the study's pictures, below the chart, in sight. */
function placeView(container: HTMLElement, size: number): Element {
  const element = document.createElement('volume-view') as Element;
  const side = `${size / devicePixelRatio}px`;
  const attributes = { src: scene.src, look: 'flat', 'transfer-function': 'mri', alt: 'The view that is measured' };
  for (const [name, value] of Object.entries({ ...attributes, 'camera-orbit': studyOrbit, interaction: 'none' }))
    element.setAttribute(name, value);
  element.setAttribute('interpolation-decay', '0');
  element.style.cssText = `inline-size: ${side}; block-size: ${side}; max-block-size: none; aspect-ratio: auto`;
  container.after(element);
  return element;
}

function describe({ name, points }: ChartLine): string {
  return `${name}: ${points.map(([ms, error]) => `${error.toPrecision(2)} in ${ms.toPrecision(2)} ms`).join(', ')}.`;
}

/** Let the page draw, and end where the reader stopped. */
async function pause(signal: AbortSignal): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve));
  signal.throwIfAborted();
}
