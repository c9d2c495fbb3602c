// `npm run bench -- notes`: what notes cost while the camera turns. Two views that are alike, one of them with notes, turn in turns. The
// ratios say more than the times: those are of a machine that may be busy. REPEATS=1 NOTES=100 make a quick run.
import { measurePackage, nameMachine } from '../helpers/measure-in-browser.mjs';
import { repeats } from './knobs.mjs';
import { median, printTable } from './table.mjs';

const counts = process.env.NOTES?.split(',').map(Number) ?? [5, 100, 400];

/** Turns of each view in one repeat, frames of each turn, and frames before them. */
const [turns, frames, warmUp] = [2, 20, 3];

/**
 * In the page: two views, and notes in the second.
 * @param {number} count
 */
async function openViews(count) {
  await customElements.whenDefined('volume-view');
  const views = [0, count].map((notes) => {
    const view = document.createElement('volume-view');
    const attributes = { src: '/demos/data/mni152-t1.nii.gz', steps: '20', alt: 'A brain', 'interpolation-decay': '0' };
    for (const [name, value] of Object.entries(attributes)) view.setAttribute(name, value);
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
}

/**
 * In the page: drag one view by 3 degrees a frame, as a hand does: a picture at rest would measure its error first.
 * @param {{ n: number, frames: number, warmUp: number }} turn
 * @returns ms for a frame
 */
async function turnInPage({ n, frames, warmUp }) {
  const view = document.querySelectorAll('volume-view')[n];
  const picture = /** @type {HTMLElement} */ (view.shadowRoot?.querySelector('.picture'));
  picture.setPointerCapture = () => {}; // A made event has no pointer to capture.
  let clientX = 100;
  /** @param {string} type */
  const point = (type) =>
    picture.dispatchEvent(
      new PointerEvent(type, { pointerId: 1, isPrimary: true, buttons: 1, bubbles: true, clientX, clientY: 100 }),
    );
  const step = async () => {
    const isDrawn = new Promise((resolve) => view.addEventListener('render', resolve, { once: true }));
    clientX += 3 * (480 / 1.2 / 180); // 1 / 1.2 of the height is half a turn.
    point('pointermove');
    await isDrawn;
    // The browser has put the picture, and what is over it, on the screen.
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
  };
  point('pointerdown');
  for (let i = 0; i < warmUp; i++) await step();
  const began = performance.now();
  for (let i = 0; i < frames; i++) await step();
  const time = (performance.now() - began) / frames;
  point('pointerup');
  return time;
}

/**
 * In the page: show one of the views alone, as the other one draws and casts rays when it comes to rest.
 * @param {{ n: number, what: string }} view - what: is measured next
 */
async function showInPage({ n, what }) {
  await /** @type {any} */ (window).sayProgress(what);
  const views = [...document.querySelectorAll('volume-view')];
  const isDrawn = new Promise((resolve) => views[n].addEventListener('render', resolve, { once: true }));
  views.forEach((view, i) => (view.hidden = i !== n));
  await Promise.race([isDrawn, new Promise((resolve) => setTimeout(resolve, 2000))]);
}

export async function run() {
  await measurePackage(async ({ machine, openPage }) => {
    console.log(nameMachine(machine));
    const rows = [];
    for (const count of counts) {
      const page = await openPage('test/bench/empty.html', { width: 700, height: 1000 });
      const session = await page.context().newCDPSession(page);
      // Software GL takes seconds for a picture of this size: with a sixteenth of its pixels it takes what a graphics card may.
      const metrics = { width: 700, height: 1000, deviceScaleFactor: 0.25, mobile: false };
      await session.send('Emulation.setDeviceMetricsOverride', metrics);
      await page.addScriptTag({ url: '/dist/volume-view.js', type: 'module' });
      await page.evaluate(openViews, count);
      await session.send('Performance.enable', { timeDomain: 'threadTicks' });
      /** Time in which the page's thread was at work, ms. */
      const readWork = async () => {
        const { metrics } = await session.send('Performance.getMetrics');
        return 1000 * (metrics.find(({ name }) => name === 'TaskDuration')?.value ?? NaN);
      };
      /** For each view: of a frame, ms. @type {{ times: number[], works: number[] }[]} */
      const measured = [0, 1].map(() => ({ times: [], works: [] }));
      for (let turn = 0; turn < turns * repeats; turn++)
        for (const n of turn % 2 ? [1, 0] : [0, 1]) {
          await page.evaluate(showInPage, {
            n,
            what: `${count} notes, turn ${turn + 1} of ${turns * repeats}, ${n ? 'with' : 'without'}`,
          });
          const before = await readWork();
          measured[n].times.push(await page.evaluate(turnInPage, { n, frames, warmUp }));
          measured[n].works.push(((await readWork()) - before) / (frames + warmUp));
        }
      await page.close();
      const [without, withNotes] = measured;
      /** @param {readonly number[]} a @param {readonly number[]} b */
      const ratio = (a, b) => median(b.map((value, i) => value / a[i])).toFixed(2);
      rows.push({
        notes: count,
        'frame, ms': `${median(without.times).toFixed(1)} / ${median(withNotes.times).toFixed(1)}`,
        ratio: ratio(without.times, withNotes.times),
        "the page's thread, ms": `${median(without.works).toFixed(1)} / ${median(withNotes.works).toFixed(1)}`,
        'its ratio': ratio(without.works, withNotes.works),
      });
    }
    printTable('A frame of a turn, 640 x 480 pixels, without / with notes; medians', rows);
  });
}
