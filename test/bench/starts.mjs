// `npm run bench -- starts`: from a page with nothing but data in memory to the first and to the finished picture, the library included: ours and
// other renderers' of the npm registry, which are not the project's, see peers/README.md. Each load is a new page, in turns.
import { measurePackage, measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes, repeats } from './knobs.mjs';
import { peerNames, preparePeers } from './peers/build.mjs';
import { median, printTable } from './table.mjs';

const url = '/demos/data/mni152-t1.nii.gz';

/** The element's own for an MRI. */
const appearance = process.env.LOOK ?? 'mri';

const peers = process.env.PEERS?.split(',') ?? peerNames;

export async function run() {
  if (!(await preparePeers())) return;
  const [pixels] = readSizes([512]);
  const sent = await measureSource(async ({ openPage }) => {
    const page = await openPage('test/accuracy/page.html');
    return page.evaluate(
      async ({ from, what }) => {
        const { sendScene } = /** @type {typeof import('./starts-page.ts')} */ (await import(from));
        return sendScene(what.url, what.look);
      },
      { from: '/test/bench/starts-page.ts', what: { url, look: appearance } },
    );
  });
  await measurePackage(async ({ url: at, machine, openPage }) => {
    /** @type {Record<string, { first: number, finished: number }[]>} */
    const loads = Object.fromEntries(['ours', ...peers].map((name) => [name, []]));
    for (let i = 0; i < repeats; i++) {
      for (const [name, list] of Object.entries(loads)) {
        const page = await openPage(`${at}test/bench/empty.html`);
        const load = name === 'ours' ? startOurs : startPeer;
        list.push(
          await page.evaluate(load, { sent, pixels, look: appearance, module: `/test/bench/peers/dist/${name}.js` }),
        );
        await page.close();
      }
    }
    console.log(
      `\n${nameMachine(machine)}, medians of ${repeats}, ${pixels} x ${pixels} pixels, MRI of 197 x 233 x 189\n`,
    );
    const of = (/** @type {string} */ name, /** @type {'first' | 'finished'} */ key) =>
      median(loads[name].map((load) => load[key]));
    printTable(
      'From the script on, ms. Peers draw one step a voxel at once; ours keeps max-error, and measures it',
      Object.keys(loads).map((name) => ({
        renderer: name,
        'first picture': of(name, 'first').toFixed(0),
        finished: of(name, 'finished').toFixed(0),
        'finished, to ours': (of(name, 'finished') / of('ours', 'finished')).toFixed(2),
      })),
    );
  });
}

/** @typedef {{ sent: import('./starts-page.ts').SentScene, pixels: number, look: string, module: string }} Asked */

/** In the page. @param {Asked} asked */
async function startPeer({ sent: { scene, samples, stepLength }, pixels, module }) {
  const host = document.createElement('div');
  document.body.append(host);
  const given = {
    ...scene,
    samples: Uint8Array.from(atob(samples), (c) => c.charCodeAt(0)),
    table: Float32Array.from(scene.table),
  };
  const began = performance.now();
  const { start } = await import(module);
  const peer = await start(host, given);
  peer.setSize(pixels);
  peer.draw(stepLength);
  peer.gl.readPixels(0, 0, 1, 1, peer.gl.RGBA, peer.gl.UNSIGNED_BYTE, new Uint8Array(4));
  const took = performance.now() - began;
  return { first: took, finished: took };
}

/** In the page. @param {Asked} asked */
async function startOurs({ sent: { file }, pixels, look: transferFunction }) {
  const bytes = Uint8Array.from(atob(file), (c) => c.charCodeAt(0));
  const src = URL.createObjectURL(new Blob([bytes]));
  const began = performance.now();
  document.head.append(
    Object.assign(document.createElement('script'), { type: 'module', src: '/dist/volume-view.js' }),
  );
  const element = document.createElement('volume-view');
  element.setAttribute('src', src);
  element.setAttribute('transfer-function', transferFunction);
  element.style.cssText = `display: block; width: ${pixels}px; height: ${pixels}px; max-height: none; aspect-ratio: auto`;
  let first = 0;
  element.addEventListener('render', () => (first ||= performance.now() - began));
  document.body.append(element);
  await customElements.whenDefined('volume-view');
  await element.whenRendered();
  return { first, finished: performance.now() - began };
}
