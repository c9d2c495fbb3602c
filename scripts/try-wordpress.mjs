// The plugin in a real WordPress: `node scripts/try-wordpress.mjs [FOLDER OF WORDPRESS] [FOLDER FOR PICTURES]`, by default Debian's WordPress. It
// needs PHP with mysqli, and MariaDB (Debian: php-cli, php-mysql, mariadb-server, wordpress). It makes a site of its own in a folder for the trial,
// and drives it in a browser, as Administrator, as Author and as a reader. It is no part of the tests, since it takes minutes. `npm run build`
// comes before.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { findBrowser, listTestArgs } from './find-browser.mjs';
import { projectRoot } from './shared-data.mjs';
import { startSite } from './wordpress/start-site.mjs';
import { tryBlock } from './wordpress/try-block.mjs';
import { tryEmbeds } from './wordpress/try-embeds.mjs';
import { tryLanguage } from './wordpress/try-language.mjs';
import { tryPages } from './wordpress/try-pages.mjs';
import { tryRemoval } from './wordpress/try-removal.mjs';
import { tryUploads } from './wordpress/try-uploads.mjs';

const [from = '/usr/share/wordpress', pictures] = process.argv.slice(2);
const site = await startSite(from);
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listTestArgs() });
try {
  console.log(`WordPress ${site.version} at ${site.url}`);
  const look = async (/** @type {import('@playwright/test').Page} */ page, /** @type {string} */ name) => {
    if (pictures) await page.screenshot({ path: join(pictures, `${site.version}-${name}.png`) });
  };
  const trial = { site, browser, look, data: join(projectRoot, 'demos/data') };
  await tryUploads(trial);
  await tryBlock(trial);
  await tryPages(trial);
  await tryEmbeds(trial, from);
  await tryLanguage(trial);
  tryRemoval(trial);
  assert.deepEqual(site.listErrors(), []);
  console.log('PHP has logged no error');
} catch (error) {
  for (const [i, page] of browser
    .contexts()
    .flatMap((context) => context.pages())
    .entries())
    if (pictures) await page.screenshot({ path: join(pictures, `${site.version}-failed-${i}.png`) });
  throw error;
} finally {
  await browser.close();
  await site.stop();
}
