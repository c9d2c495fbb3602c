// `npm run bench -- controller`: how well the quality controller keeps its promises while a camera goes around for ten
// seconds, and after. SIZES are pixels along each side; SECONDS=2 makes a quick run.
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { readSizes } from './knobs.mjs';
import { printTable } from './table.mjs';

const seconds = Number(process.env.SECONDS ?? 10);
const targetFps = Number(process.env.TARGET_FPS ?? 30);

/** Three narrow peaks, which take many steps. */
const peaks =
  '19.5% #48c 0, 20% #48c 60%, 20.5% #48c 0, 44.5% #f93 0, 45% #f93 60%, 45.5% #f93 0, 69.5% white 0, 70% white 60%, 70.5% white 0';

/** Cheap, ten times as many pixels, and ten times as many steps on these. */
function listScenes() {
  const [small, large] = readSizes([256, 800]);
  const mri = { src: '/demos/data/mni152-t1.nii.gz', targetFps, seconds };
  return [
    { name: 'MRI, smooth', scene: { ...mri, transferFunction: 'mri', size: small } },
    { name: 'MRI, smooth', scene: { ...mri, transferFunction: 'mri', size: large ?? small } },
    { name: 'MRI, three peaks', scene: { ...mri, transferFunction: peaks, size: large ?? small } },
  ];
}

export async function run() {
  await measureSource(async ({ machine, openPage }) => {
    const rows = [];
    for (const { name, scene } of listScenes()) {
      const page = await openPage('test/accuracy/page.html');
      const result = await page.evaluate(
        async ({ module, asked }) => {
          const { measureController } = /** @type {typeof import('./controller-page.ts')} */ (await import(module));
          return measureController(asked, (what) => /** @type {any} */ (window).sayProgress(what));
        },
        { module: '/test/bench/controller-page.ts', asked: scene },
      );
      await page.close();
      rows.push({
        scene: `${name}, ${scene.size} x ${scene.size}`,
        'at rest, ms (steps)': `${result.atRestMs.toFixed(0)} (${result.atRestSteps})`,
        frames: result.frames,
        'a second': result.framesPerSecond.toFixed(1),
        'within 115 % of budget': `${(result.inBudget * 100).toFixed(0)} %`,
        'median, ms': result.medianMs.toFixed(1),
        'pixels, rays, steps': `${(result.medianPixels * 100).toFixed(0)} %, ${(result.medianRays * 100).toFixed(0)} %, ${result.medianSteps}`,
        'error, 1/255 (max)': `${result.medianError.toFixed(1)} (${result.largestError.toFixed(1)})`,
        'to final, ms': result.convergedMs.toFixed(0),
        'idle: frames, callbacks': `${result.idleFrames}, ${result.idleCallbacks}`,
      });
    }
    console.log(`\n${nameMachine(machine)}, target-fps ${targetFps}: ${(1000 / targetFps).toFixed(1)} ms a frame\n`);
    printTable(`An orbit of ${seconds} s, and what comes after`, rows);
  });
}
