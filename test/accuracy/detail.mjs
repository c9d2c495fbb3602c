// `npm run accuracy -- detail`: what a picture in bricks says of the error that coarse bricks leave, against the true one, in 200 random views. In Node. `TABLES=yes`:
// only with the table of the pyramid's writer; `no`: only without.
import { loadModule } from '../bench/load-module.mjs';
import { printTable } from '../bench/table.mjs';

/** Errors below this, in 1/255, can not be seen: a ratio of them says nothing. */
const seen = 0.5;

/** @param {{ quick: boolean }} options */
export async function run({ quick }) {
  /** @type {typeof import('./detail-views.ts')} */
  const { measureViews } = await loadModule('test/accuracy/detail-views.ts');
  for (const hasTable of (process.env.TABLES ?? 'no,yes').split(',').map((name) => name === 'yes')) {
    console.log(hasTable ? "With the table of the pyramid's writer:" : 'Without a table:');
    /** @type {import('./detail-views.ts').DetailView[]} */
    const views = [];
    for await (const view of measureViews(quick ? 24 : 200, hasTable)) {
      log(view);
      views.push(view);
    }
    tabulate(views);
  }
}

/** @param {import('./detail-views.ts').DetailView} view */
function log({ field, look, maxError, share, said, true: truth }) {
  console.log(
    `${field}, look ${look}, max-error ${maxError}, ${(100 * share).toFixed(0)} % of the bricks: says ${said.toFixed(2)}, is ${truth.rms.toFixed(2)} (largest ${truth.max.toFixed(0)})`,
  );
}

/** @param {import('./detail-views.ts').DetailView[]} views */
function tabulate(views) {
  const quantile = (/** @type {number[]} */ all, /** @type {number} */ share) => {
    const sorted = [...all];
    sorted.sort((a, b) => a - b);
    return sorted[Math.min(all.length - 1, Math.floor(share * all.length))];
  };
  const rows = [...new Set(views.map(({ field }) => field)), 'all'].map((name) => {
    const own = views.filter(({ field, true: truth }) => (name === 'all' || field === name) && truth.rms >= seen);
    const ratios = own.map(({ said, true: truth }) => said / truth.rms);
    const near = ratios.filter((ratio) => ratio >= 0.5 && ratio <= 2).length;
    const [low, middle, high] = [0.05, 0.5, 0.95].map((share) => quantile(ratios, share)?.toFixed(2) ?? '-');
    return {
      volume: name,
      views: own.length,
      'within a factor of two': `${((100 * near) / own.length).toFixed(0)} %`,
      'kept within twice max-error': `${own.filter(({ true: truth, maxError }) => truth.rms <= 2 * maxError).length}`,
      '5 %': low,
      median: middle,
      '95 %': high,
      least: Math.min(...ratios).toFixed(2),
      most: Math.max(...ratios).toFixed(2),
    };
  });
  printTable(`Views whose true error is at least ${seen}; stated / true:`, rows);
}
