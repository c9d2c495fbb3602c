import type { ShownOverlay } from '../optics/overlay.ts';

/** A second field over the volume of an element, as its picture and its picks need it. */
export interface ViewOverlay {
  readonly shown: ShownOverlay;
  /** What it is called. */
  readonly name: string;
}
