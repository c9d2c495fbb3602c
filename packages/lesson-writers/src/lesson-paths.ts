// Addresses in a lesson, and the paths of files that they name.

/** The folder for the files of a lesson in what is written: so no name of theirs meets one of ours. */
export const dataFolder = 'data/';

/** The longest path that all file systems and archives take. */
const maxPath = 200;

/**
 * The path of a file in a lesson's folder, without `.` and empty parts; null where it leads elsewhere or has a name that some systems refuse.
 */
export function cleanPath(path: string): string | null {
  if (path.length > maxPath || /[\\:*?"<>|\p{Cc}\p{Cs}]/u.test(path) || path.startsWith('/')) return null;
  const parts = path.split('/').filter((part) => part !== '' && part !== '.');
  return parts.length > 0 && !parts.some((part) => /^\.|[. ]$/.test(part)) ? parts.join('/') : null;
}

/** What an address names: a path, and what follows `#`. Null for all that is no file of the lesson. */
export function readAddress(address: string): { readonly path: string; readonly fragment: string } | null {
  const [, written, fragment = ''] = /^([^#]*)(#.*)?$/s.exec(address) ?? [];
  let path;
  try {
    path = cleanPath(decodeURIComponent(written ?? ''));
  } catch {
    return null;
  }
  return path === null ? null : { path, fragment };
}

/** The address of a file of the lesson, from the page. */
export const writeAddress = (path: string): string => (dataFolder + path).split('/').map(encodeURIComponent).join('/');

/** Whether a link may stay: to another page, to a mailbox, or to a place in this page. */
export const isLink = (href: string): boolean => /^(?:https?:\/\/[^\s/\\]|mailto:[^\s]|#)/i.test(href);
