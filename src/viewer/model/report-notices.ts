// Loaded with the first file that is attached to a volume.
import type { Volume } from '../../volume/volume.ts';
import type { FileNotices, NoticePlace, ReportedFile } from './file-notices.ts';

/** Addresses that have no file name: the data are in the address itself, or in memory. */
const nameless = /^(data|blob):/i;

/**
 * Notify the people who see a picture which parts of attached files are not in it, or are changed in it.
 * @param owner - the object that shows the files: this call replaces its earlier report
 */
export function reportFileNotices(
  { fileNotices, user }: NoticePlace,
  owner: object,
  files: readonly ReportedFile[],
): void {
  const reported = files
    .filter(([, notices]) => notices.length > 0)
    .map(([url, notices]): FileNotices => ({ name: nameOf(url), notices }));
  if (reported.length === 0 && !fileNotices.has(owner)) return;
  if (reported.length > 0) fileNotices.set(owner, reported);
  else fileNotices.delete(owner);
  user.changed();
}

/** The notices about a volume's file that change what people see. */
export function noticesOf({ radar, left, reduced }: Volume): readonly string[] {
  const smaller = reduced
    ? [`made smaller for this device, from ${reduced.from.join(' x ')} voxels to ${reduced.to.join(' x ')}`]
    : [];
  return [...smaller, ...(radar?.left ?? left ?? [])];
}

function nameOf(url: string): string {
  if (nameless.test(url.trim())) return '';
  const [path] = url.trim().split(/[?#]/);
  const name = path.slice(path.lastIndexOf('/') + 1);
  try {
    return decodeURIComponent(name).slice(0, 80);
  } catch {
    return name.slice(0, 80);
  }
}
