// The plugin in German. WordPress takes a language only if it has words for it itself, so it gets an empty list of them.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { writeCatalogue } from '../wordpress-words.mjs';
import { enter, openEditor } from './trial.mjs';

/** @param {import('./trial.mjs').Trial} trial */
export async function tryLanguage(trial) {
  const { site } = trial;
  const folder = join(site.root, 'wp-content/languages');
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'de_DE.mo'), writeCatalogue(new Map([['', 'Language: de_DE\n']])));
  site.run(`update_option( 'WPLANG', 'de_DE' );`);
  const admin = await enter(trial, 'admin');
  await admin.goto(`${site.url}/wp-admin/options-media.php`);
  assert.match(await admin.innerText('body'), /Jede Datei wird an ihrem Inhalt geprüft/);
  await openEditor(admin, `${site.url}/wp-admin/post-new.php`);
  const [title, words] = await admin.evaluate(() => {
    const { blocks, i18n } = /** @type {any} */ (window).wp;
    return [blocks.getBlockType('volume-view/volume').title, i18n.__('Start from this view', 'volume-view')];
  });
  assert.deepEqual([title, words], ['Volumen', 'Mit dieser Ansicht beginnen']);
  site.run(`update_option( 'WPLANG', '' );`);
  await admin.context().close();
  console.log(`German: ${title}, ${words}`);
}
