import type { Volume } from '../../volume/volume.ts';

/** What of a file beside the volume is not in the picture, or not as it is there. */
export interface FileNotices {
  /** Of the file, as people know it; '' where it has none. */
  readonly name: string;
  /** In words. */
  readonly notices: readonly string[];
}

/** Where it is told. */
interface NoticePlace {
  readonly besideNotices: Map<object, readonly FileNotices[]>;
  readonly user: { changed(): void };
}

/** Addresses that are no names: what they hold is in them. */
const nameless = /^(data|blob):/i;

/** A file, and what of it is not in the picture; nothing where all of it is. */
export type ToldFile = readonly [url: string, notices: readonly string[]];

/**
 * Tell who looks at a picture what of files beside the volume is not in it, or not as it is there.
 * @param owner - shows the files: what it told before no longer holds
 */
export function tellBeside({ besideNotices, user }: NoticePlace, owner: object, files: readonly ToldFile[]): void {
  const told = files.filter(([, notices]) => notices.length > 0).map(([url, notices]): FileNotices => ({ name: nameOf(url), notices }));
  if (told.length === 0 && !besideNotices.has(owner)) return;
  if (told.length > 0) besideNotices.set(owner, told);
  else besideNotices.delete(owner);
  user.changed();
}

/** What of a volume's file changes what is seen. */
export function noticesOf({ radar, left, reduced }: Volume): readonly string[] {
  const smaller = reduced ? [`made smaller for this device, from ${reduced.from.join(' x ')} voxels to ${reduced.to.join(' x ')}`] : [];
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
