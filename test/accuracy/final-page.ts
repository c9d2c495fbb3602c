// In the browser: whether a view has one final picture, whatever was shown before.
import { decode } from 'fast-png';
import type { VolumeView } from '../../components/volume-view/volume-view.ts';
import { canvasOf, placeElement, setSight, setSize, takeAtRest } from './element-picture.ts';
import type { ElementSetup, Sight } from './element-picture.ts';
import { loadHere, serveVolume, sightOf } from './small-page.ts';
import { realScenes, smallScenes } from './small-scenes.ts';

/** What an element went through before it shows the view. */
type History = (setup: ElementSetup) => Promise<VolumeView>;

/** Degrees from the view. */
const elsewhere: readonly number[] = [7, -23, 90];

async function viewFrom(element: VolumeView, sight: Sight, pixels: number): Promise<void> {
  setSight(element, sight);
  await takeAtRest(element, pixels);
}

/** By what the table calls them. */
const histories: Readonly<Record<string, History>> = {
  'once more': (setup) => Promise.resolve(placeElement(setup)),
  'after other views': async (setup) => {
    const element = placeElement(setup);
    for (const turn of elsewhere)
      await viewFrom(element, { ...setup.sight, theta: setup.sight.theta + turn, phi: 70 }, setup.pixels);
    setSight(element, setup.sight);
    return element;
  },
  'after views near and far': async (setup) => {
    const element = placeElement({ ...setup, sight: { ...setup.sight, radius: setup.sight.radius * 0.5 } });
    await takeAtRest(element, setup.pixels);
    await viewFrom(element, { ...setup.sight, radius: setup.sight.radius * 3 }, setup.pixels);
    setSight(element, setup.sight);
    return element;
  },
  'in a larger window first': async (setup) => {
    const element = placeElement({ ...setup, pixels: setup.pixels * 2 });
    await takeAtRest(element, setup.pixels * 2);
    setSize(element, setup.pixels, setup.ratio);
    return element;
  },
  'in a smaller window first': async (setup) => {
    const element = placeElement({ ...setup, pixels: setup.pixels / 2 });
    await takeAtRest(element, setup.pixels / 2);
    setSize(element, setup.pixels, setup.ratio);
    return element;
  },
  'with another max-error first': async (setup) => {
    const element = placeElement({ ...setup, attributes: { ...setup.attributes, 'max-error': '8' } });
    await takeAtRest(element, setup.pixels);
    element.removeAttribute('max-error');
    return element;
  },
};

/** The size of the picture has to have followed that of the element. */
async function takeSettled(element: VolumeView, pixels: number): Promise<Uint8Array> {
  for (let tries = 0; canvasOf(element)?.width !== pixels && tries < 500; tries++)
    await new Promise((resolve) => setTimeout(resolve, 20));
  return (await takeAtRest(element, pixels)).data;
}

function largestDifference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  if (a.length !== b.length) throw new Error(`pictures of ${a.length} and ${b.length} bytes`);
  let max = 0;
  for (let i = 0; i < a.length; i++) max = Math.max(max, Math.abs(a[i] - b[i]));
  return max;
}

/** Of a PNG file: premultiplied, as colours of what is almost clear say little. */
async function decodeBlob(blob: Blob): Promise<number[]> {
  const { data, channels } = decode(new Uint8Array(await blob.arrayBuffer()));
  const alphaOf = (i: number): number => (channels === 4 ? data[i - (i % 4) + 3] : 255);
  return Array.from(data, (x, i) => (channels === 4 && i % 4 === 3 ? x : Math.round((x * alphaOf(i)) / 255)));
}

/** The file of `toBlob` against one of what stands on the screen. */
async function compareFile(element: VolumeView): Promise<number> {
  const screen = await new Promise<Blob | null>((resolve) => canvasOf(element).toBlob(resolve));
  if (!screen) throw new Error('the canvas gives no file');
  return largestDifference(await decodeBlob(await element.toBlob()), await decodeBlob(screen));
}

/** Scenes whose views are taken. */
const names = [
  'Specks of 1 voxel in a veil, large',
  'Wires of 1 voxel',
  'Threshold on a smooth map, zoomed in',
  'CT phantom',
];

/**
 * Largest differences of bytes from the first picture of each view.
 * @param count - of scenes @param notify - what is being done
 */
export async function compareFinals(
  count: number,
  notify: (what: string) => void,
): Promise<Record<string, string | number>[]> {
  const rows: Record<string, string | number>[] = [];
  for (const name of names.slice(0, count)) {
    const scene = smallScenes.find((one) => one.name === name);
    const { view, transferFunction, url } = scene
      ? { ...scene, url: null }
      : realScenes.find((one) => one.name === name)!;
    const volume = scene ? scene.make().block.toVolume() : await loadHere(url!);
    const attributes: Record<string, string> =
      transferFunction === null ? {} : { 'transfer-function': transferFunction };
    const setup = { src: url ?? serveVolume(volume), sight: sightOf(volume, view, 0), attributes, ...view };
    const first = placeElement(setup);
    const picture = await takeSettled(first, view.pixels);
    const row: Record<string, string | number> = { scene: name };
    for (const [history, show] of Object.entries(histories)) {
      notify(`${name}, ${history}`);
      const element = await show(setup);
      row[history] = largestDifference(await takeSettled(element, view.pixels), picture);
      element.remove();
    }
    row['toBlob() and the screen'] = await compareFile(first);
    first.remove();
    rows.push(row);
  }
  return rows;
}
