import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';
import type { AxeResults, RunOptions } from 'axe-core';
import { expect } from './harness.ts';

const axePath = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** All rules; but of what passes axe describes no more than one element for each rule, and no element gets a selector, which takes longest. */
const options: RunOptions = { resultTypes: ['violations'], selectors: false };

interface WindowWithAxe {
  readonly axe?: { run(options: RunOptions): Promise<AxeResults> };
}

/** What axe finds wrong with the page as it is, `rule: element`. */
export async function findFaults(page: Page): Promise<string[]> {
  if (!(await page.evaluate(() => Boolean((window as WindowWithAxe).axe)))) await page.addScriptTag({ path: axePath });
  const { passed, faults } = await page.evaluate(async (asked) => {
    const { passes, violations } = await (window as WindowWithAxe).axe!.run(asked);
    return {
      passed: passes.length,
      faults: violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html}`)),
    };
  }, options);
  expect(passed, 'axe looked').toBeGreaterThan(5);
  return faults;
}
