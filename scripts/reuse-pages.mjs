// Reuses pages in the unit tests of @web/test-runner-playwright: a new page for each file would cost a window and a process, which takes
// longer than the tests of a usual file.

/** @typedef {import('playwright').BrowserContext} BrowserContext */

/**
 * A file gets a context, and the page in it, that no other file is using. The runner has left that page for `about:blank`, which ends all
 * its scripts. A page that crashed is not used again: its file ends with an error, and the context never comes back to the list.
 */
export function reusePages() {
  /** @type {BrowserContext[]} */
  const free = [];

  /** @param {import('playwright').Browser} browser */
  async function openContext(browser) {
    const context = await browser.newContext();
    // The runner calls this when a file is finished. The browser closes all contexts at the end.
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
