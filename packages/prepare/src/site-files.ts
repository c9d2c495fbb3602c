import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
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

/** Copies the element's script and its parts, where the package is installed, and again after it became another version. */
export async function copyScript(site: string, say: (text: string) => void): Promise<void> {
  const script = findScript();
  const target = join(site, scriptName);
  if (!script) {
    if (!existsSync(target))
      say(
        `the pages need ${scriptName}, ${x3domName} and the folder ${partsName}: copy them from the folder dist of the package volume-view into ${site}`,
      );
    return;
  }
  const bytes = readFileSync(script);
  if (existsSync(target) && readFileSync(target).equals(bytes)) return;
  await copyFolder(join(dirname(script), partsName), site, partsName);
  await writeWhole(site, x3domName, readFileSync(join(dirname(script), x3domName)));
  // Last, because where it is, its parts are there too.
  await writeWhole(site, scriptName, bytes);
}

/** The script of the element, where the package is installed. */
function findScript(): string | null {
  for (const from of [import.meta.url, join(process.cwd(), 'package.json')]) {
    try {
      return createRequire(from).resolve(`volume-view/${scriptName}`);
    } catch {
      // Not there.
    }
  }
  return null;
}
