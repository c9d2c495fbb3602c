import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { playerFolder } from '../../lesson-writers/src/index.ts';
import type { DoneLine } from './job.ts';
import { partsName, scriptName, writeIndex, x3domName } from './site-pages.ts';
import { copyFolder, writeWhole } from './write-folder.ts';

/** Writes the page of all volumes of a site, where it has changed. */
export async function writeIndexPage(site: string, lines: DoneLine[]): Promise<void> {
  lines.sort((a, b) => a.title.localeCompare(b.title, 'en', { numeric: true }));
  const page = writeIndex(lines.map((line) => ({ ...line, hasPoster: existsSync(join(site, line.id, 'poster.png')) })));
  await writeChanged(site, 'index.html', page);
}

/** Writes a text as a whole, where it is another one than before. @returns whether it was */
export async function writeChanged(folder: string, name: string, text: string): Promise<boolean> {
  const path = join(folder, name);
  if (existsSync(path) && readFileSync(path, 'utf8') === text) return false;
  await writeWhole(folder, name, text);
  return true;
}

/** Copies the element's script and its parts, and again after they became another version. @param player - with the element's own files */
export async function copyScript(site: string, player: URL): Promise<void> {
  const from = fileURLToPath(player);
  const bytes = readFileSync(join(from, scriptName));
  const target = join(site, scriptName);
  if (existsSync(target) && readFileSync(target).equals(bytes)) return;
  await copyFolder(join(from, partsName), site, partsName);
  await writeWhole(site, x3domName, readFileSync(join(from, x3domName)));
  // Last, because where it is, its parts are there too.
  await writeWhole(site, scriptName, bytes);
}

/** Copies the element's own files for pages in frames, which share them, and again after they became another version. */
export async function copyPlayer(site: string, player: URL): Promise<void> {
  const from = fileURLToPath(player);
  const target = join(site, playerFolder, scriptName);
  if (existsSync(target) && readFileSync(target).equals(readFileSync(join(from, scriptName)))) return;
  await copyFolder(from, site, playerFolder.replace('/', ''));
}
