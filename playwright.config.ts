// End-to-end tests on the built package. `npx playwright test test/e2e/x.spec.ts` runs one file (after `npm run build`).
import { defineConfig } from '@playwright/test';
import { findBrowser, listTestArgs } from './scripts/find-browser.mjs';

/**
 * Files whose tests follow each other in one page of the browser, which is emptied between them: half of the work of a short test is to start a
 * page of its own. Left out are those that ask for permissions, or look at what a page leaves behind: memory, contexts, workers.
 */
const onePage = [
  ...[
    'accessibility',
    'attributes',
    'author-scene',
    'box',
    'camera',
    'companions',
    'demos',
    'editor',
    'editor-text',
    'errors',
    'events',
    'gradient-opacity',
    'interaction',
  ],
  ...[
    'labels',
    'layers',
    'legend',
    'light',
    'live-regions',
    'measure',
    'plane-editor',
    'pointing',
    'projection',
    'radar',
    'readout',
    'rtl',
    'scans',
  ],
  ...['slice-view', 'slices', 'source', 'styles', 'surfaces', 'timeline', 'x3dom-scenes'],
].map((name) => `**/${name}.spec.ts`);

/**
 * V8 optimises only functions that run for long (by default, after 67,584 units of its counter). Most pages of tests end before optimised code
 * has repaid the work of its compilation.
 */
const lateOptimisation = '--js-flags=--interrupt-budget=1000000';

export default defineConfig({
  testDir: 'test/e2e',
  testMatch: '**/*.spec.ts',
  outputDir: 'test-results',
  globalSetup: './test/e2e/global-setup.ts',
  workers: 2, // Half of a spec's time is waiting, also in software GL on two cores.
  // Of 324 tests one that waits for a busy machine may time out. It is tried once more, and named at the end of the run.
  retries: process.env.CI ? 1 : 0,
  forbidOnly: true,
  timeout: 120_000,
  expect: { timeout: 60_000 }, // A machine with other work is late; a test that waits for what never comes has 120 s.
  reporter: [['list'], ['./scripts/playwright-counts-reporter.mjs']],
  use: {
    browserName: 'chromium',
    baseURL: process.env.VOLUME_VIEW_URL, // Set by the global setup, before the workers start.
    viewport: { width: 900, height: 700 },
    launchOptions: { executablePath: await findBrowser(), args: [...listTestArgs(), lateOptimisation] },
  },
  projects: [
    { name: 'one page', testMatch: onePage, use: { reuseContext: true } },
    { name: 'a page each', testIgnore: onePage },
  ],
});
