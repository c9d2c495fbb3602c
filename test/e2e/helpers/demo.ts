import type { Page } from '@playwright/test';

/**
 * Open a page of the demos, with the built package in the place of its sources. The server sends that: a browser whose requests go through a test keeps nothing of
 * what it reads.
 * @param css - for small pictures, say; from the beginning, so that none is drawn that is not looked at
 */
export async function openDemo(page: Page, name: string, css: string): Promise<void> {
  await fetch(`${process.env.VOLUME_VIEW_URL}/src/index.ts`, {
    method: 'PUT',
    body: "export * from '/dist/volume-view.js';",
  });
  await page.addInitScript((text) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
    document.adoptedStyleSheets = [sheet];
  }, css);
  await page.goto(`/demos/${name}`);
}
