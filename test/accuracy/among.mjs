// `npm run accuracy -- among`: what is left of small things in pictures at rest where the volume is cut, where shapes and slices stand
// in it, in WebGL 1, and in panes with slices. SCENES=plate,wires takes the scenes with these words in their names; ANGLES=5 so many angles of each;
// MAX_ERROR=4 another `max-error`, where things count that stand out by 8 times as much: then panes, which have no rays, are left out.
import { formatTable } from '../bench/table.mjs';
import { measureTables } from './measure-tables.mjs';
import { countThings, sumUpThings } from './sum-up-small.mjs';

/** @typedef {import('./among-page.ts').AmongResult} AmongResult */

/** Angles, a degree apart. */
const usualAngles = { full: 5, quick: 2 };

const maxError = Number(process.env.MAX_ERROR ?? 1);

/** Things that count in a plain scene at each angle, at the least. */
const fewestPlain = 8;

/** As x3dom sees Apple's systems, where it asks for WebGL 1. */
const askForWebGl1 = () => void Object.defineProperty(navigator, 'platform', { value: 'MacIntel' });

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ page, openPage, machine }) => {
    const angles = Number(process.env.ANGLES ?? (quick ? usualAngles.quick : usualAngles.full));
    const words = process.env.SCENES?.toLowerCase().split(',') ?? [''];
    const old = await openPage({ before: askForWebGl1 });
    const [inTwo, inOne] = [await measureIn(page, { angles, words }), await measureIn(old, { angles, words })];
    const plain = await measurePlain(old, { angles, words });
    const panes =
      maxError === 1 && words.some((word) => 'specks on a slice in a pane'.includes(word))
        ? await measurePanes(page, angles)
        : [];
    if (inTwo.some(({ webgl }) => webgl !== 2) || [...inOne, ...plain].some(({ webgl }) => webgl !== 1))
      throw new Error('a picture was drawn with another WebGL than was asked for');
    for (const result of [...inTwo, ...inOne, ...panes]) refuseFew(result);
    for (const result of plain) refuseFew({ ...result, fewest: fewestPlain });
    for (const result of [...inTwo, ...inOne].filter(({ name }) => name.includes('edges')))
      refuseFew({ ...result, pictures: result.pictures.map(({ atEdges }) => ({ atEdges })) });
    return {
      'among-where': `${angles} angles of each scene; ${machine.browser}, ${machine.renderer}.`,
      'among-things': formatTable(joinAlike([...inTwo, ...inOne, ...panes].map(describe))),
      'among-edges': formatTable(joinAlike([...inTwo, ...inOne].map(describeEdges).filter(({ shown }) => shown > 0))),
      'among-slices': formatTable(
        joinAlike([...inTwo, ...inOne, ...panes].filter(({ whole }) => whole !== null).map(describeWhole)),
      ),
      'among-plain': formatTable(plain.map(sumUpThings)),
    };
  });

/**
 * @param {import('@playwright/test').Page} page
 * @param {{ angles: number, words: string[] }} how
 */
async function measureIn(page, { angles, words }) {
  const module = '/test/accuracy/among-page.ts';
  const names = await page.evaluate(async (from) => (await import(from)).listAmong(), module);
  /** @type {AmongResult[]} */
  const results = [];
  for (const name of names) {
    if (!words.some((word) => name.toLowerCase().includes(word))) continue;
    results.push(
      await page.evaluate(
        async ({ from, scene, count, maxError }) => {
          const { measureAmong } = /** @type {typeof import('./among-page.ts')} */ (await import(from));
          return measureAmong(scene, {
            angles: count,
            maxError,
            doubts: true,
            notify: (what) => /** @type {any} */ (window).sayProgress(what),
          });
        },
        { from: module, scene: name, count: angles, maxError },
      ),
    );
  }
  return results;
}

/**
 * In WebGL 1, the scenes of `npm run accuracy -- small`.
 * @param {import('@playwright/test').Page} page
 * @param {{ angles: number, words: string[] }} how
 */
async function measurePlain(page, { angles, words }) {
  const module = '/test/accuracy/small-page.ts';
  const scenes = await page.evaluate(async (from) => (await import(from)).listScenes(), module);
  /** @type {import('./small-page.ts').SmallResult[]} */
  const results = [];
  for (const { name, hasThings } of scenes) {
    if (!hasThings || !words.some((word) => name.toLowerCase().includes(word))) continue;
    results.push(
      await page.evaluate(
        async ({ from, scene, count, maxError }) => {
          const { measureScene } = /** @type {typeof import('./small-page.ts')} */ (await import(from));
          return measureScene(scene, {
            angles: count,
            maxError,
            doubts: false,
            notify: (what) => /** @type {any} */ (window).sayProgress(`WebGL 1: ${what}`),
          });
        },
        { from: module, scene: name, count: angles, maxError },
      ),
    );
  }
  return results;
}

/**
 * @param {import('@playwright/test').Page} page
 * @param {number} angles
 */
async function measurePanes(page, angles) {
  return page.evaluate(
    async ({ from, count }) => {
      const { measurePane, paneZooms } = /** @type {typeof import('./among-panes.ts')} */ (await import(from));
      const results = [];
      for (const zoom of paneZooms) results.push(await measurePane(zoom, count));
      return results;
    },
    { from: '/test/accuracy/among-panes.ts', count: angles },
  );
}

/**
 * @param {Pick<AmongResult, 'name' | 'webgl' | 'fewest' | 'minContrast'> & { pictures: readonly Partial<AmongResult['pictures'][0]>[] }} result
 * @throws where so few things were seen that a table would tell nothing
 */
function refuseFew({ name, webgl, fewest, minContrast, pictures }) {
  // Fewer things stand out by more.
  if (maxError !== 1) return;
  for (const { things = [], atEdges = [] } of pictures) {
    const { shown } = countThings([[...things, ...atEdges]], minContrast);
    if (shown < fewest)
      throw new Error(`${name}, WebGL ${webgl}: ${shown} things count at an angle; expected ${fewest} or more`);
  }
}

/** @param {AmongResult} result */
function describe(result) {
  const { scene, 'device pixel ratio': _, ...counts } = sumUpThings(result);
  return {
    scene,
    WebGL: String(result.webgl ?? 'none'),
    ...counts,
    'rays, to twice the steps': result.uncertain === null ? '' : result.uncertain.toFixed(2),
  };
}

/** Beside the edges of shapes. @param {AmongResult} result */
function describeEdges(result) {
  const { 'rays, to twice the steps': _, ...counts } = describe({
    ...result,
    pictures: result.pictures.map(({ atEdges }) => ({ things: atEdges, atEdges })),
  });
  return counts;
}

/** How much of a speck's own brightness its brightest pixel has, at all angles at which its middle is on the slice. @param {AmongResult} result */
function describeWhole({ name, webgl, pixelsPerVoxel, pictures, whole, minContrast, kind }) {
  const things = (kind === 'pane' ? pictures.slice(0, 1) : pictures)
    .flatMap((one) => one.things)
    .filter((thing) => thing !== null);
  const seen = things.map(({ contrast, kept }) => (contrast * kept) / (whole ?? 1));
  return {
    scene: name,
    WebGL: String(webgl ?? 'none'),
    'pixels a voxel': pixelsPerVoxel,
    'specks on it': things.length,
    'not shown': things.filter(({ contrast }) => contrast < minContrast).length,
    'least of its own brightness': `${(100 * Math.min(...seen)).toFixed(0)} %`,
  };
}

/**
 * Rows that differ by their WebGL alone are one.
 * @template {{ WebGL: string }} Row
 * @param {Row[]} rows
 */
function joinAlike(rows) {
  /** @type {Map<string, Row>} */
  const joined = new Map();
  for (const row of rows) {
    const key = JSON.stringify({ ...row, WebGL: '' });
    const before = joined.get(key);
    joined.set(key, before ? { ...before, WebGL: `${before.WebGL} and ${row.WebGL}` } : row);
  }
  return [...joined.values()];
}
