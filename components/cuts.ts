import type { Slice } from '../src/optics/slices.ts';
import type { CartesianGrid } from '../src/volume/grid.ts';
import type { Rings } from './range-rings.ts';

/** Which part of a volume is shown, where it is cut, and what is drawn around it. */
export interface Cuts {
  /** null for all of it. */
  readonly region: CartesianGrid | null;
  /** What cameras frame, which may be of another scan; null for what is shown. */
  readonly framed: CartesianGrid | null;
  readonly slices: readonly Slice[];
  /** null for none. */
  readonly rings: Rings | null;
}

export const noCuts: Cuts = { region: null, framed: null, slices: [], rings: null };

/** The attributes of <volume-slice>. */
const sliceAttributes = ['type', 'elevation', 'sweep', 'height', 'azimuth', 'from', 'to', 'hidden'];

/** Calls back when the <volume-slice> children of an element come, go or change. */
export function watchSlices(host: Element, changed: () => void): { disconnect(): void } {
  const observer = new MutationObserver((records) => {
    const isSlice = (node: Node): boolean => node instanceof Element && node.localName === 'volume-slice';
    if (records.some(({ target, addedNodes, removedNodes }) => [target, ...addedNodes, ...removedNodes].some(isSlice))) changed();
  });
  observer.observe(host, { childList: true, subtree: true, attributes: true, attributeFilter: sliceAttributes });
  return observer;
}

/** Whether an element asks for any cut at all, or rings: only then the part that reads them is loaded. */
export function asksForCuts(host: Element & { readonly region: string | null; readonly rings: string | null }): boolean {
  return host.region !== null || host.rings !== null || [...host.children].some((child) => child.localName === 'volume-slice');
}
