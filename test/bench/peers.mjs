// `npm run bench -- peers`: time to a picture of a given error, ours and other renderers' of the npm registry. Their packages
// are not the project's: see peers/README.md. Each volume's first transfer function is drawn lit, too, by those that light as we do; LIT=only
// leaves the others out, LIT=no leaves these out. PICTURES=folder writes what each shows at very many steps.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { errorSize, readScenes, readSizes, repeats } from './knobs.mjs';
import { peerNames, preparePeers } from './peers/build.mjs';
import { median, printTable } from './table.mjs';

const targets = [1, 2, 4];

/** The name of the target that E is at most 1 and nothing small is dimmed, see peers-page.ts. */
const keepsSmall = 'small';

/** The element, and what the other renderers are compared with, for each target. */
const ours = ['ours', 'ours, free'];

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
      for (const target of [...targets.map(String), keepsSmall])
        printPeers(
          rows.filter((row) => row.size === size && target in row.results.ours.reached),
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
 * @param {{ size: number, target: string }} what
 */
function printPeers(rows, { size, target }) {
  if (rows.length === 0) return;
  const ratios = ours.map((name) => rows.map((row) => compareFastest(row, name, target)));
  const what =
    target === keepsSmall ? 'E of 1, each small thing with three quarters of its contrast or more' : `E of ${target}`;
  printTable(
    `Time to ${what}, ${size} x ${size} pixels: ms (steps; ours × the most substeps, rays, and max-error where it is not E); in brackets what does not count, as it tends to another picture. What is lit counts: models of light differ`,
    rows.map(({ volume, transferFunction, results }, i) => ({
      volume,
      'transfer function': transferFunction,
      ...Object.fromEntries(
        Object.entries(results).map(([name, result]) => [name, describe(result, target, rows[i].isLit)]),
      ),
      ...Object.fromEntries(
        ours.map((name, at) => [`fastest peer / ${name}`, ratios[at][i]?.toFixed(2) ?? 'none counts']),
      ),
    })),
  );
  for (const [at, name] of ours.entries()) {
    const known = ratios[at].filter((ratio) => ratio !== null);
    console.log(
      known.length === 0
        ? `no peer counts in any scene (${name})\n`
        : `fastest peer / ${name}: median ${median(known).toFixed(1)}, min ${Math.min(...known).toFixed(2)}, of ${known.length} of ${rows.length} scenes\n`,
    );
  }
}

/** @param {import('./peers-page.ts').PeerResult} result @param {string} target @param {boolean} isLit */
function describe({ fromReference, reached, fixedMs }, target, isLit) {
  const one = reached[target];
  const text =
    fixedMs === null
      ? one
        ? `${one.ms.toFixed(0)} (${describeSteps(one, target)})`
        : 'never'
      : `${fixedMs.toFixed(0)} (fixed)`;
  return (isLit || fromReference <= maxFromReference) && fixedMs === null ? text : `[${text}]`;
}

/** @param {import('./peers-page.ts').Reached} reached @param {string} target */
function describeSteps({ steps, substeps, rays = 1, maxError }, target) {
  const e = target === keepsSmall ? 1 : Number(target);
  return [
    substeps ? `${steps} × ${substeps}` : steps,
    ...(rays < 1 ? [`${(100 * rays).toFixed(0)} %`] : []),
    ...(maxError && maxError !== e ? [`max-error ${maxError}`] : []),
  ].join(', ');
}

/**
 * The fastest peer that counts and reaches the target, over ours; null where there is none.
 * @param {import('./peers-page.ts').PeersRow} row
 * @param {string} name - which of ours
 * @param {string} target
 */
function compareFastest({ isLit, results }, name, target) {
  const own = results[name].reached[target];
  const times = Object.entries(results)
    .filter(([other, { fromReference }]) => !ours.includes(other) && (isLit || fromReference <= maxFromReference))
    .map(([, { reached }]) => reached[target]?.ms ?? Infinity);
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
