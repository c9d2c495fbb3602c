// `npm run bench -- notes`: what notes cost while the camera turns. Two views that are alike, one of them with notes, are turned by the same
// steps, one after the other. The ratio of their frames, and of what the page's own thread does for them, says more than the times: those
// are of a machine that may be busy.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { median, printTable } from './table.mjs';

const [counts, turns] = [[5, 100, 400], 40];

/**
 * In the page: two views, and notes in the second.
 * @param {number} count
 */
async function openViews(count) {
  await customElements.whenDefined('volume-view');
  document.body.replaceChildren();
  const views = [0, count].map((notes) => {
    const view = document.createElement('volume-view');
    for (const [name, value] of Object.entries({ src: '/demos/data/mni152-t1.nii.gz', steps: '60', alt: 'A brain' }))
      view.setAttribute(name, value);
    view.style.cssText = 'width: 640px; height: 480px';
    for (let i = 0; i < notes; i++) {
      const note = document.createElement('volume-note');
      const [x, y, z] = [50 * Math.sin(5 * i), 70 * Math.sin(3 * i + 1), 50 * Math.sin(7 * i + 2)];
      note.setAttribute('position', `${x} ${y} ${z}`);
      note.setAttribute('label', `Place ${i}`);
      view.append(note);
    }
    document.body.append(view);
    return view;
  });
  for (const view of views) await view.whenRendered();
  // All notes have been looked at: the camera has rested.
  const isSeen = () => [...document.querySelectorAll('volume-note')].every((one) => one.transmittance !== null);
  while (!isSeen()) await new Promise((resolve) => setTimeout(resolve, 50));
}

/**
 * In the page: turn one view. @param {{ n: number, theta: number }} step
 * @returns how long the frame took, ms
 */
async function turnInPage({ n, theta }) {
  const view = document.querySelectorAll('volume-view')[n];
  const began = performance.now();
  const moved = new Promise((resolve) => view.addEventListener('render', resolve, { once: true }));
  view.setAttribute('camera-orbit', `${theta}deg 75deg auto`);
  await moved;
  view.shadowRoot?.querySelector('.picture')?.getBoundingClientRect();
  return performance.now() - began;
}

export async function run() {
  await measurePackage(async ({ machine, openPage }) => {
    console.log(nameMachine(machine));
    const rows = [];
    for (const count of counts) {
      const page = await openPage('test/bench/empty.html', { width: 700, height: 1000 });
      await page.addScriptTag({ url: '/dist/volume-view.js', type: 'module' });
      await page.evaluate(openViews, count);
      const session = await page.context().newCDPSession(page);
      await session.send('Performance.enable', { timeDomain: 'threadTicks' });
      /** Time in which the page's thread was at work, s. */
      const readWork = async () => {
        const { metrics } = await session.send('Performance.getMetrics');
        return metrics.find(({ name }) => name === 'TaskDuration')?.value ?? NaN;
      };
      /** @type {number[][]} */
      const [frames, works] = [
        [[], []],
        [[], []],
      ];
      for (let turn = 0; turn < turns; turn++)
        for (const n of turn % 2 ? [1, 0] : [0, 1]) {
          const before = await readWork();
          frames[n].push(await page.evaluate(turnInPage, { n, theta: 3 * turn }));
          works[n].push(1000 * ((await readWork()) - before));
        }
      await page.close();
      const [without, withNotes] = frames.map((times) => median(times));
      const [workWithout, workWith] = works.map((times) => median(times));
      rows.push({
        notes: count,
        'frame, ms': `${without.toFixed(1)} / ${withNotes.toFixed(1)}`,
        ratio: (withNotes / without).toFixed(2),
        "the page's thread, ms": `${workWithout.toFixed(1)} / ${workWith.toFixed(1)}`,
        'its ratio': (workWith / workWithout).toFixed(2),
      });
    }
    printTable('A turn by 3 degrees, 640 x 480 pixels, without and with notes', rows);
  });
}
