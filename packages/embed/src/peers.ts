/** Origins as `self.origin` and `event.origin` write them: `null` is one that no page shares. */
export interface Peers {
  /** Of this page. */
  readonly own: string;
  /** Of sites that the page's own server lists. */
  readonly listed: readonly string[];
  /** The only ones that the address allows; null where it says nothing. */
  readonly narrowed: readonly string[] | null;
}

/**
 * Whether this page answers the page around its frame.
 *
 * A page around a frame can write any address into it. So it may set what an address may say; but what the frame says of its data is another matter:
 * a frame with the origin of its server gets what the reader may see there. It answers that server's pages, and sites that the server lists. A frame
 * in a sandbox without an origin has only what its server gives to everybody: it answers every page.
 */
export function mayTalk(parent: string, { own, listed, narrowed }: Peers): boolean {
  if (narrowed !== null && !narrowed.includes(parent)) return false;
  return own === 'null' || parent === own || listed.includes(parent);
}
