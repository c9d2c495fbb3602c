// What benches have in common that take frames of the same scene in turns, and count the time of all cores that the drawing process took.
import { measureSource, nameMachine } from '../helpers/measure-in-browser.mjs';
import { printTable } from './table.mjs';

/**
 * A table for each size. `processorSeconds()` of turns.ts is there in the pages.
 * @template {Record<string, string | number>} Row
 * @param {{ sizes: readonly number[], what: string }} options - what: is the same in all, for people
 * @param {(page: import('@playwright/test').Page, size: number) => Promise<Row[]>} measure - in a page of its own
 */
export async function measureTurns({ sizes, what }, measure) {
  await measureSource(async ({ machine, openPage, browser }) => {
    const session = await browser.newBrowserCDPSession();
    console.log(`${nameMachine(machine)}, ${what}; processor: time of all cores that the drawing process took`);
    for (const size of sizes) {
      const page = await openPage('test/accuracy/page.html');
      await page.exposeFunction('processorSeconds', async () => {
        const { processInfo } = await session.send('SystemInfo.getProcessInfo');
        return processInfo.find(({ type }) => type === 'GPU')?.cpuTime ?? 0;
      });
      const rows = await measure(page, size);
      await page.close();
      printTable(`${size} x ${size} pixels`, rows);
    }
  });
}
