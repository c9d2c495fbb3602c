// `npm run bench -- bricks`: bytes and seconds to a picture of a given error, where a volume comes in bricks of a pyramid, by the policy
// that chooses the next brick. It runs in Node, without a browser, and its bytes do not depend on a clock.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateSync } from 'node:zlib';
import { sharedDataFolder } from '../../scripts/shared-data.mjs';
import { loadModule } from './load-module.mjs';
import { median, printTable } from './table.mjs';

const list = (/** @type {string | undefined} */ text) => text?.split(',');

const errors = [4, 2, 1];
const networks = [20, 100, 300].flatMap((delay) =>
  [2, 10, 50].map((megabytes) => ({ delay: delay / 1000, bandwidth: megabytes * 1e6 })),
);

/** @returns {Promise<typeof import('./bricks/simulate.ts')>} */
const loadSimulator = () => loadModule('test/bench/bricks/simulate.ts');

export async function run() {
  printResults(await simulatePictures(list(process.env.SCENES) ?? ['head', 'cranium', 'storm', 'specks', 'shells']));
}

/** @param {readonly string[]} scenes */
export async function simulatePictures(scenes) {
  const { simulate } = await loadSimulator();
  const results = [];
  const side = Number(process.env.SIDE ?? 32);
  for await (const result of simulate({
    scenes,
    looks: list(process.env.LOOKS),
    views: list(process.env.VIEWS),
    side,
    tableSide: Number(process.env.TABLE_SIDE ?? side),
    size: Number(process.env.RAYS ?? 28),
    pixels: 512,
    probes: Number(process.env.PROBES ?? 16),
    errors,
    networks,
    read: (path) => {
      const file = join(sharedDataFolder, path);
      return Promise.resolve(existsSync(file) ? new Uint8Array(readFileSync(file)) : null);
    },
    pack: (bytes) => deflateSync(bytes),
    log: console.log,
  })) {
    results.push(result);
    const { scene, look, view, coarsest, tableBytes, policies } = result;
    const reached = policies.map(
      ({ policy, reached: all }) =>
        `${policy} ${all.map((one) => (one ? (one.bytes / 1000).toFixed(0) : 'never')).join(', ')}`,
    );
    console.log(
      `${scene}: ${look}, ${view}: table ${(tableBytes / 1000).toFixed(1)} kB, max of the coarsest ${coarsest.max.toFixed(0)}; ${reached.join('; ')}`,
    );
  }
  return results;
}

/** @typedef {import('./bricks/simulate.ts').SceneResult} SceneResult */

/** @param {readonly SceneResult[]} results */
export function printResults(results) {
  const scenes = [...new Set(results.map(({ scene }) => scene))];
  printTable(
    'Kilobytes to an error E of 4, 2, 1 / with all bricks in the picture',
    results.map(({ scene, look, view, totalBytes, coarsest, policies }) => ({
      scene: `${scene}: ${look}, ${view}`,
      'E of the coarsest': coarsest.e.toFixed(0),
      ...Object.fromEntries(
        policies.map(({ policy, reached }) => [
          policy,
          reached.map((one) => (one ? (one.bytes / 1000).toFixed(0) : 'never')).join(', '),
        ]),
      ),
      all: (totalBytes / 1000).toFixed(0),
    })),
  );
  const pairs = ['by error', 'by error, learnt'].flatMap((ours) =>
    ['nearest level', 'crosshair'].map((theirs) => [ours, theirs]),
  );
  printTable(
    `Bytes to an error, as a share of what the other policy needs: median (smallest to largest) of ${results.length} pictures`,
    pairs.flatMap(([ours, theirs]) =>
      errors.map((error, i) => {
        const ratios = compare(results, [ours, theirs], (reached) => reached[i]?.bytes);
        return { policies: `${ours} / ${theirs}`, E: error, ...describe(ratios) };
      }),
    ),
  );
  printTable(
    'By error / nearest level, by data, all three errors',
    scenes.map((scene) => {
      const of = results.filter((result) => result.scene === scene);
      return {
        scene,
        ...describe(
          errors.flatMap((_, i) => compare(of, ['by error', 'nearest level'], (reached) => reached[i]?.bytes)),
        ),
      };
    }),
  );
  printTable(
    'Seconds to E = 2, by error / nearest level',
    networks.map(({ delay, bandwidth }, n) => ({
      'delay, ms': delay * 1000,
      'MB/s': bandwidth / 1e6,
      'by error, s (median)': medianOf(results, 'by error', n),
      'nearest level, s (median)': medianOf(results, 'nearest level', n),
      ...describe(compare(results, ['by error', 'nearest level'], (reached) => reached[1]?.seconds[n])),
    })),
  );
  const said = results.flatMap(({ policies }) =>
    policies
      .filter(({ policy }) => policy === 'by error')
      .flatMap(({ stated }) => stated.filter((one) => one.true.rms > 0.5)),
  );
  const within = said.filter((one) => Math.abs(Math.log2(one.stated / one.true.rms)) <= 1).length;
  console.log(
    `What was said of the RMS is within a factor of two in ${within} of ${said.length} states with a true RMS above 0.5.`,
  );
}

/** @param {readonly number[]} ratios */
function describe(ratios) {
  if (ratios.length === 0) return { ratio: 'none', 'above 1.2': '' };
  return {
    ratio: `${median(ratios).toFixed(2)} (${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)})`,
    'above 1.2': `${ratios.filter((ratio) => ratio > 1.2).length} of ${ratios.length}`,
  };
}

/**
 * @param {readonly SceneResult[]} results
 * @param {readonly string[]} names - of two policies
 * @param {(reached: SceneResult['policies'][0]['reached']) => number | undefined} read
 */
function compare(results, names, read) {
  return results.flatMap(({ policies }) => {
    const [ours, theirs] = names.map((name) => read(policies.find(({ policy }) => policy === name)?.reached ?? []));
    return ours && theirs ? [ours / theirs] : [];
  });
}

/** @param {readonly SceneResult[]} results @param {string} name @param {number} n - of the network */
function medianOf(results, name, n) {
  const seconds = results.flatMap(({ policies }) => {
    const one = policies.find(({ policy }) => policy === name)?.reached[1];
    return one ? [one.seconds[n]] : [];
  });
  return median(seconds).toFixed(2);
}
