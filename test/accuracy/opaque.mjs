// `npm run accuracy -- opaque`: whether what is said of errors is true where something is opaque at once, in volumes and views that were made to break
// it. The truth is a float64 ray-caster that finds each crossing of a value. SCENES=noise,stent takes volumes with these words in their names; ROWS=1
// prints each scene as it is measured; WEBGL=1 takes WebGL 1 for all.
import { formatTable } from '../bench/table.mjs';
import { chooseScenes } from './choose-scenes.mjs';
import { measureTables } from './measure-tables.mjs';
import { groupByKind, isKept, misleading, nameLargest, sumUp } from './sum-up-stated.mjs';

/** @typedef {import('./opaque-page.ts').OpaqueResult} OpaqueResult */

/** Of a short run every so manieth volume is taken. */
const few = 6;

/** Every so manieth volume that is made here is measured in WebGL 1, too. */
const oldEvery = 5;

/** Of what is asked for, so much more is true where it is said to be kept: less is what the estimate is about. */
const nearlyKept = 1.1;

/** Less than this, 1/255, is what rounding to 8 bits makes of any picture: understating it misleads nobody. */
const reported = 0.5;

/** @param {{ quick: boolean }} options */
export const run = ({ quick }) =>
  measureTables({ quick }, async ({ openPage, page }) => {
    const all = await page.evaluate(
      async (name) => /** @type {string[]} */ ((await import(name)).opaqueVolumes),
      '/test/accuracy/opaque-scenes.ts',
    );
    const wanted = chooseScenes(all, quick && few);
    const onlyOld = process.env.WEBGL === '1';
    /** @type {OpaqueResult[]} */
    const results = [];
    /** @param {import('@playwright/test').Page} where @param {string} name */
    const measure = async (where, name) => {
      const found = await where.evaluate(
        async ({ module, volume }) => {
          const { measureOpaque } = /** @type {typeof import('./opaque-page.ts')} */ (await import(module));
          return measureOpaque(volume, (what) => /** @type {any} */ (window).sayProgress(what));
        },
        { module: '/test/accuracy/opaque-page.ts', volume: name },
      );
      if (!found) console.log(`left out: ${name} (needs ../shared/data)`);
      for (const one of found ?? []) {
        results.push(one);
        if (process.env.ROWS === '1') console.log(Object.values(describeResult(one)).join(' | '));
      }
    };
    if (!onlyOld) for (const name of wanted) await measure(page, name);
    const old = await openPage({ before: withoutWebGl2 });
    for (const [i, name] of wanted.entries()) if (onlyOld || (i % oldEvery === 2 && i < 16)) await measure(old, name);
    const broken = results.filter((one) => listFaults(one).length > 0 || !isKept(one));
    return {
      'stated-opaque': formatTable(
        groupByKind(results.map((one) => ({ ...one, kind: one.webgl === 1 ? 'WebGL 1' : one.kind }))).map(
          ([name, group]) => ({ scenes: name, ...describeGroup(group) }),
        ),
      ),
      'missed-opaque': broken.length > 0 ? formatTable(broken.map(describeResult)) : 'None.',
    };
  });

/** Runs in a page: there is no WebGL 2. */
function withoutWebGl2() {
  const getContext = /** @type {(kind: string, options?: unknown) => any} */ (HTMLCanvasElement.prototype.getContext);
  HTMLCanvasElement.prototype.getContext = /** @type {any} */ (
    /** @type {(this: HTMLCanvasElement, kind: string, options?: unknown) => unknown} */ (
      function (kind, options) {
        return kind.endsWith('webgl2') ? null : getContext.call(this, kind, options);
      }
    )
  );
}

/** @param {OpaqueResult[]} group */
function describeGroup(group) {
  const { 'said to be kept, is not': _kept, 'understated by more than 3': _more, ...rest } = sumUp(group);
  return {
    ...rest,
    'said to be kept, is not': group.filter((one) => listFaults(one).includes('said to be kept, is not')).length,
    'a statement does not hold': group.filter((one) => listFaults(one).length > 0).length,
  };
}

/** What is said of a scene and does not hold. @param {OpaqueResult} result */
export function listFaults({ error, finest, maxError, stats: { error: stated, keepsMaxError } }) {
  const faults = [];
  if (keepsMaxError && error.e > nearlyKept * maxError) faults.push('said to be kept, is not');
  if (stated.max !== null && error.max > stated.max + 0.5) faults.push('maximum exceeded');
  if (error.rms > reported && stated.rms < error.rms / misleading) faults.push('RMSE understated');
  if (keepsMaxError && stated.rms > maxError) faults.push('contradicts itself');
  if (finest !== null && finest <= maxError) faults.push('stopped too early');
  return faults;
}

/** @param {OpaqueResult} result */
function describeResult(result) {
  const { name, stats, error, level, off, finest, webgl } = result;
  return {
    scene: webgl === 1 ? `${name}, WebGL 1` : name,
    'pixels covered': error.covered,
    'samples a voxel × substeps': `${level.samplesAVoxel.toFixed(0)} × ${level.substeps}`,
    'says that it is kept': stats.keepsMaxError ? 'yes' : 'no',
    E: error.e.toFixed(2),
    'RMSE stated': stats.error.rms.toFixed(2),
    true: error.rms.toFixed(2),
    'P99 stated': stats.error.p99.toFixed(2),
    'P99 true': error.p99.toFixed(2),
    'P99.9 true': error.p999.toFixed(1),
    'off by more than 8': off ?? '',
    'maximum stated': nameLargest(stats.error.max),
    'of rays probed': stats.error.probed.toFixed(1),
    rays: stats.error.rays,
    'maximum true': error.max.toFixed(1),
    'E with 2,048 steps': finest === null ? '' : finest.toFixed(2),
    'does not hold': listFaults(result).join(', '),
  };
}
