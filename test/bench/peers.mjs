// `npm run bench -- peers`: time to a picture of a given error, ours and other renderers' of the npm registry. Their packages
// are not the project's: see peers/README.md. Each volume's first transfer function is drawn lit, too, by those that light as we do; LIT=only
// leaves the others out, LIT=no leaves these out. PICTURES=folder writes what each shows at very many steps.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { errorSize, readScenes, readSizes, repeats } from './knobs.mjs';
import { peerNames, preparePeers } from './peers/build.mjs';
import { median, printTable } from './table.mjs';

const targets = [1, 4];

/** A peer counts whose picture at very many steps is no further from the reference: RMSE, 1/255. */
const maxFromReference = 4;

/** Peers that run; PEERS=three,vtk leaves some out. */
const peers = process.env.PEERS?.split(',') ?? peerNames;

export async function run() {
  if (!(await preparePeers())) return;
  const modules = Object.fromEntries(peers.map((name) => [name, `/test/bench/peers/dist/${name}.js`]));
  const lit = readLit(process.env.LIT);
  const options = { scenes: readScenes(), sizes: readSizes([512]), targets, repeats, errorSize, modules, lit };
  await measureSource(async ({ machine, openPage }) => {
    const page = await openPage('test/accuracy/page.html');
    const rows = await page.evaluate(
      async ({ module, asked }) => {
        const { comparePeers } = /** @type {typeof import('./peers-page.ts')} */ (await import(module));
        return comparePeers(asked, (what) => /** @type {any} */ (window).sayProgress(what));
      },
      { module: '/test/bench/peers-page.ts', asked: options },
    );
    console.log(
      `\n${nameMachine(machine)}, medians of ${repeats}. Errors: E of the colours over black, 8 bit: the larger of the RMSE over the pixels that are not black and an eighth of their 99.9th percentile, against each one's own picture at very many steps.\n`,
    );
    printTable(
      'From the float64 reference: RMSE, 1/255 (steps)',
      rows
        .filter(({ size }) => size === options.sizes[0])
        .map(({ volume, transferFunction, results }) => ({
          volume,
          'transfer function': transferFunction,
          ...Object.fromEntries(
            Object.entries(results).map(([name, { fromReference, limitSteps }]) => [
              name,
              `${fromReference.toFixed(2)} (${limitSteps === 1 ? 'fixed' : limitSteps})`,
            ]),
          ),
        })),
    );
    for (const size of options.sizes)
      for (const target of targets)
        printPeers(
          rows.filter((row) => row.size === size),
          { size, target },
        );
    if (process.env.PICTURES) writePictures(rows, process.env.PICTURES);
  });
}

/** @param {string | undefined} asked @returns {'only' | 'no' | 'too'} */
function readLit(asked) {
  return asked === 'only' || asked === 'no' ? asked : 'too';
}

/**
 * @param {import('./peers-page.ts').PeersRow[]} rows
 * @param {{ size: number, target: number }} what
 */
function printPeers(rows, { size, target }) {
  const ratios = rows.map((row) => compareFastest(row, target));
  printTable(
    `Time to an error of ${target}/255, ${size} x ${size} pixels: ms (steps, ours × the most substeps); in brackets what does not count, as it tends to another picture. What is lit counts: models of light differ`,
    rows.map(({ volume, transferFunction, results }, i) => ({
      volume,
      'transfer function': transferFunction,
      ...Object.fromEntries(
        Object.entries(results).map(([name, result]) => [name, notify(result, target, rows[i].isLit)]),
      ),
      'fastest peer / ours': ratios[i]?.toFixed(2) ?? 'none counts',
    })),
  );
  const known = ratios.filter((ratio) => ratio !== null);
  if (known.length === 0) return console.log('no peer counts in any scene\n');
  console.log(
    `fastest peer / ours: median ${median(known).toFixed(1)}, min ${Math.min(...known).toFixed(2)}, of ${known.length} of ${rows.length} scenes\n`,
  );
}

/** @param {import('./peers-page.ts').PeerResult} result @param {number} target @param {boolean} isLit */
function notify({ fromReference, reached, fixedMs }, target, isLit) {
  const one = reached[target];
  const text =
    fixedMs === null
      ? one
        ? `${one.ms.toFixed(0)} (${one.steps}${one.substeps ? ` × ${one.substeps}` : ''})`
        : 'never'
      : `${fixedMs.toFixed(0)} (fixed)`;
  return (isLit || fromReference <= maxFromReference) && fixedMs === null ? text : `[${text}]`;
}

/**
 * The fastest peer that counts and reaches the error, over ours; null where there is none.
 * @param {import('./peers-page.ts').PeersRow} row
 * @param {number} target
 */
function compareFastest({ isLit, results: { ours, ...others } }, target) {
  const own = ours.reached[target];
  const times = Object.values(others)
    .filter(({ fromReference }) => isLit || fromReference <= maxFromReference)
    .map(({ reached }) => reached[target]?.ms ?? Infinity);
  const fastest = Math.min(Infinity, ...times);
  return own && Number.isFinite(fastest) ? fastest / own.ms : null;
}

/** @param {import('./peers-page.ts').PeersRow[]} rows @param {string} folder */
function writePictures(rows, folder) {
  mkdirSync(folder, { recursive: true });
  for (const { volume, transferFunction, results } of rows) {
    for (const [name, { picture }] of Object.entries(results)) {
      const file = `${volume} ${transferFunction} ${name}`.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-');
      writeFileSync(join(folder, `${file}.png`), Buffer.from(picture.split(',')[1], 'base64'));
    }
  }
}
