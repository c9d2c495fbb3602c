import type { SocketView } from '../model/view-socket.ts';

type Fetch = typeof globalThis.fetch;

/** Sends cookies and logins to other servers too, but not for files that a stranger's file names. */
const withCookies: Fetch = (url, options) => fetch(url, { ...options, credentials: options?.credentials ?? 'include' });

/** How what is attached to a view is fetched: as its page has set it, by function or attribute; undefined or null for the browser's own way. */
export function fetchOf({ host, settings }: Pick<SocketView, 'host' | 'settings'>): Fetch | null | undefined {
  const sends = /^\s*use-credentials\s*$/i.test(settings.source?.crossOrigin ?? '');
  return host.fetch ?? (sends ? withCookies : undefined);
}
