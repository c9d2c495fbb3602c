import type { Volume } from '../../volume/volume.ts';
import type { VolumeInfo } from './volume-info.ts';

/** What of a file attached to the volume is not in the picture, or is changed in it. */
export interface FileNotices {
  /** The name of the file, as people know it; '' where it has none. */
  readonly name: string;
  /** In words. */
  readonly notices: readonly string[];
}

/** Where the notices are kept and shown. */
interface NoticePlace {
  readonly fileNotices: Map<object, readonly FileNotices[]>;
  readonly user: { changed(): void };
}

/** Addresses that have no file name: the data are in the address itself, or in memory. */
const nameless = /^(data|blob):/i;

/** A file, and which parts of it are not in the picture; an empty list where all are. */
export type ReportedFile = readonly [url: string, notices: readonly string[]];

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

/** Whether something of a volume's file, or of the files shown with it, is not in the picture, or is changed there. */
export function hasNotices(
  info: Pick<VolumeInfo, 'notices' | 'reduced'> | null,
  attached: ReadonlyMap<object, readonly FileNotices[]>,
): boolean {
  return attached.size > 0 || Boolean(info?.notices?.length || info?.reduced);
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
