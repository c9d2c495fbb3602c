import type { Browser, BrowserContextOptions, Page } from '@playwright/test';

/** What tests choose with `test.use`, or leave as the configuration has it. */
export type PageKind = Required<Pick<BrowserContextOptions, 'viewport' | 'hasTouch' | 'colorScheme'>> &
  Pick<BrowserContextOptions, 'deviceScaleFactor'>;

/** What tests listen to. */
const listened = [
  'console',
  'pageerror',
  'request',
  'requestfinished',
  'requestfailed',
  'response',
  'dialog',
  'popup',
] as const;

/** Pages that the tests of a file use one after the other, one of each kind. */
export class KeptPages {
  readonly #pages = new Map<string, Page>();
  #file = '';

  /** @param prepare - a new page, before it is used */
  constructor(
    readonly browser: Browser,
    readonly prepare: (page: Page) => unknown,
  ) {}

  async take(kind: PageKind, file: string): Promise<Page> {
    if (file !== this.#file) await this.close();
    this.#file = file;
    const key = JSON.stringify(kind);
    const kept = this.#pages.get(key);
    if (kept && !kept.isClosed()) return kept;
    const page = await this.browser.newPage({ ...kind, baseURL: process.env.VOLUME_VIEW_URL! });
    this.#pages.set(key, page);
    await this.prepare(page);
    page.addInitScript = () => {
      throw new Error('A kept page may have begun before: take `test`, whose pages are new.');
    };
    return page;
  }

  /** Take back what a test may have done to a page besides its document. */
  async giveBack(page: Page, { viewport, colorScheme }: PageKind): Promise<void> {
    if (page.isClosed()) return;
    for (const type of listened) page.removeAllListeners(type);
    await page.unrouteAll({ behavior: 'ignoreErrors' });
    await page.emulateMedia({ media: null, colorScheme, reducedMotion: null, forcedColors: null, contrast: null });
    const now = page.viewportSize();
    if (viewport && (now?.width !== viewport.width || now.height !== viewport.height))
      await page.setViewportSize(viewport);
    if (viewport) await page.mouse.move(viewport.width - 1, viewport.height - 1); // Beside what is shown next.
  }

  async close(): Promise<void> {
    for (const page of this.#pages.values()) await page.close();
    this.#pages.clear();
  }
}
