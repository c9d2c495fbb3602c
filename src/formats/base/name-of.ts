/**
 * The last part of a URL's path, for messages. Of a data: URL only its type; of a blob: URL the fragment, if it has
 * one.
 */
export function nameOf(url: string): string {
  if (url.startsWith('data:')) return url.slice(0, Math.min(40, url.indexOf(',') + 1 || 40));
  if (url.startsWith('blob:') && url.includes('#')) return decodeFragment(url);
  const path = url.replace(/[?#].*$/, '');
  return path.slice(path.lastIndexOf('/') + 1) || path;
}

function decodeFragment(url: string): string {
  const fragment = url.slice(url.indexOf('#') + 1);
  try {
    return decodeURIComponent(fragment);
  } catch {
    return fragment;
  }
}
