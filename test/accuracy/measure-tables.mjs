// What the programs of `npm run accuracy` that fill tables have in common.
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { fillMarks } from './fill-marks.mjs';

/** @typedef {{ page: import('@playwright/test').Page, openPage: (options?: import('../helpers/measure-in-browser.mjs').PageOptions) => Promise<import('@playwright/test').Page>, machine: import('../helpers/measure-in-browser.mjs').Machine }} Place */

/** What a person asks of a run in other numbers than those of the tables. */
const partly = ['SCENES', 'ANGLES', 'COUNT', 'ERRORS', 'SIZES', 'DETAILS', 'TIMES'];

/**
 * Measure in a page, print tables, and write them between the marks of docs/numbers/accuracy.md that have their names. A quick run writes nothing, nor does one of
 * some scenes or numbers (see `partly`), or one with DRY=1.
 * @param {{ quick: boolean }} options
 * @param {(place: Place) => Promise<Record<string, string>>} measure - tables as Markdown, by their names
 */
export async function measureTables({ quick }, measure) {
  await measureSource(async ({ machine, openPage }) => {
    const began = performance.now();
    const openHere = (/** @type {import('../helpers/measure-in-browser.mjs').PageOptions} */ options = {}) =>
      openPage('test/accuracy/page.html', options);
    const tables = await measure({ machine, openPage: openHere, page: await openHere() });
    console.log(`\n${nameMachine(machine)}\n`);
    for (const [name, table] of Object.entries(tables)) console.log(`${name}\n\n${table}\n`);
    const isPart = partly.some((name) => process.env[name] !== undefined);
    if (process.env.DRY !== '1' && !quick && !isPart) fillMarks(join(projectRoot, 'docs/numbers/accuracy.md'), tables);
    console.log(`${Math.round((performance.now() - began) / 1000)} s`);
  });
}
