// Pages of the unit tests, for @web/test-runner-playwright: a page of its own for each file would cost a window and a process, more than most files' tests take.

/** @typedef {import('playwright').BrowserContext} BrowserContext */

/**
 * A file gets a context, and the page in it, that no other file is using; the runner has left that page for `about:blank`, which ends all that ran in it.
 * A page that crashed is not used again: its file ends with an error, and never gives it back.
 */
export function reusePages() {
  /** @type {BrowserContext[]} */
  const free = [];

  /** @param {import('playwright').Browser} browser */
  async function openContext(browser) {
    const context = await browser.newContext();
    // What the runner calls when a file is done. The browser closes them all at the end.
    context.close = async () => void free.push(context);
    return context;
  }

  return {
    /** @param {{ browser: import('playwright').Browser }} session */
    createBrowserContext: async ({ browser }) => free.pop() ?? (await openContext(browser)),
    /** @param {{ context: BrowserContext }} session */
    createPage: async ({ context }) => context.pages()[0] ?? (await context.newPage()),
  };
}
