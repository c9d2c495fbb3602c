import type { Volume } from '../volume/volume.ts';

/** What of a file beside the volume is not in the picture, or not as it is there. */
export interface FileNotices {
  /** Of the file, as people know it; '' where it has none. */
  readonly name: string;
  /** In words. */
  readonly notices: readonly string[];
}

/** Where it is told. */
interface NoticePlace {
  readonly besideNotices: Map<object, FileNotices>;
  readonly user: { changed(): void };
}

/** Addresses that are no names: what they hold is in them. */
const nameless = /^(data|blob):/i;

/**
 * Tell who looks at a picture what of a file beside the volume is not in it, or not as it is there.
 * @param owner - shows the file: what it told before no longer holds
 * @param notices - none where all of it is shown
 */
export function tellBeside({ besideNotices, user }: NoticePlace, owner: object, url: string, notices: readonly string[]): void {
  if (notices.length === 0 && !besideNotices.has(owner)) return;
  if (notices.length > 0) besideNotices.set(owner, { name: nameOf(url), notices });
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
