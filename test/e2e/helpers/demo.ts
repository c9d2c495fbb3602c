import type { Page } from '@playwright/test';

/** Open a page of the demos, with the built package in the place of its sources. @param css - for small pictures, say */
export async function openDemo(page: Page, name: string, css: string): Promise<void> {
  await page.route('**/src/index.ts', (route) => route.fulfill({ contentType: 'text/javascript', body: "export * from '/dist/volume-view.js';" }));
  await page.goto(`/demos/${name}`);
  await page.addStyleTag({ content: css });
}
