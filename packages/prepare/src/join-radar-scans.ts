import { urlInStore } from '../../../src/sources/byte-store.ts';
import type { RadarLook } from '../../../src/prepare/look-at-radar.ts';
import type { FolderSource } from './find-jobs.ts';
import { folderBase } from './folder-store.ts';

/**
 * Makes the scans of one radar, each a file, one source: the scans of one quantity in the order of time. All other sources stay as they are,
 * and so do files in archives.
 * @param folder - absolute, of all sources
 * @param looks - by the keys of sources
 */
export function joinRadarScans(
  folder: string,
  all: readonly FolderSource[],
  looks: ReadonlyMap<string, RadarLook>,
): FolderSource[] {
  const kinds = new Map<string, { readonly one: FolderSource; readonly time: number }[]>();
  const others: FolderSource[] = [];
  for (const one of all) {
    const look = one.place.archive === undefined ? looks.get(one.key) : undefined;
    if (look) kinds.set(look.kind, [...(kinds.get(look.kind) ?? []), { one, time: look.time }]);
    else others.push(one);
  }
  for (const scans of kinds.values()) {
    if (scans.length === 1) {
      others.push(scans[0].one);
      continue;
    }
    scans.sort((a, b) => a.time - b.time || (a.one.key < b.one.key ? -1 : 1));
    const only = scans.map(({ one }) => one.key);
    const files = only.map((path) => urlInStore(folderBase, path));
    others.push({
      place: { folder, only },
      source: { first: files[0], files, each: true, phase: 2 },
      key: `${only[0]} and ${only.length - 1} later scans`,
    });
  }
  return others;
}
