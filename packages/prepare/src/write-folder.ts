import { existsSync } from 'node:fs';
import { chmod, cp, mkdir, mkdtemp, open, readdir, rename, rm } from 'node:fs/promises';
import { dirname, join } from 'node:path';

/** Folders and files that are being written, or are about to be removed, begin with this. */
export const unfinished = '.unfinished-';

/** What of an earlier run was not finished is removed. Call it while no other run writes there. */
export async function removeUnfinished(site: string): Promise<void> {
  for (const name of await readdir(site))
    if (name.startsWith(unfinished)) await rm(join(site, name), { recursive: true, force: true });
}

/**
 * Writes a folder as a whole: under another name, then it gets its own. So a reader, or a run that is ended at any moment, never finds a part of it.
 * @param files - names, with `/` between folders, and contents; each is asked for when the one before it is written
 */
export async function writeFolder(
  site: string,
  name: string,
  files: Iterable<readonly [name: string, content: Uint8Array | string]>,
): Promise<void> {
  await mkdir(site, { recursive: true });
  const beside = await mkdtemp(join(site, unfinished));
  for (const [file, content] of files) {
    await mkdir(dirname(join(beside, file)), { recursive: true });
    await writeThrough(join(beside, file), content);
  }
  await giveName(site, beside, name);
}

/** Copies a folder as a whole. */
export async function copyFolder(from: string, site: string, name: string): Promise<void> {
  const beside = await mkdtemp(join(site, unfinished));
  await cp(from, beside, { recursive: true });
  await giveName(site, beside, name);
}

/** How often it is tried where another process gives a folder the same name: two files may have the same bytes. */
const tries = 5;

async function giveName(site: string, beside: string, name: string): Promise<void> {
  const target = join(site, name);
  // A folder of mkdtemp is its owner's alone, and a web server is another user.
  await chmod(beside, 0o755);
  for (let left = tries; ; left--) {
    const old = existsSync(target) ? await mkdtemp(join(site, unfinished)) : null;
    try {
      if (old) await rename(target, join(old, 'old'));
      await rename(beside, target);
      return;
    } catch (cause) {
      if (left <= 1) throw cause;
    } finally {
      if (old) await rm(old, { recursive: true, force: true });
    }
  }
}

/** Writes a file as a whole. */
export async function writeWhole(folder: string, name: string, content: Uint8Array | string): Promise<void> {
  const beside = join(folder, `${unfinished}${process.pid}-${name}`);
  await writeThrough(beside, content);
  await rename(beside, join(folder, name));
}

/** The bytes are on the disk before the name is: a machine that stops must not leave an empty file. */
async function writeThrough(path: string, content: Uint8Array | string): Promise<void> {
  const handle = await open(path, 'w', 0o644);
  try {
    await handle.writeFile(content);
    await handle.sync();
  } finally {
    await handle.close();
  }
}
