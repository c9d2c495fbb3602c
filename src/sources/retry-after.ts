/** Milliseconds that a server asks clients to wait, from Retry-After. */
export function readRetryAfter({ headers }: Response): number {
  const text = headers.get('retry-after') ?? '0';
  const wait = /^\s*\d+\s*$/.test(text) ? Number(text) * 1000 : Date.parse(text) - Date.now();
  return wait > 0 ? wait : 0;
}
