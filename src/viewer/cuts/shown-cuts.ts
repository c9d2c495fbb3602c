import type { Slice } from '../../radar/slices.ts';
import type { RayCut } from '../../renderer/ray/ray-module.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { WorldCut } from '../../volume/world-cut.ts';
import type { LabelledRings } from './read-rings.ts';

/** Which part of a volume is shown, where it is cut, and what is drawn around it. */
export interface Cuts {
  /** null for all of it. */
  readonly region: GridFrame | null;
  /** What cameras frame, which may be of another scan; null for what is shown. */
  readonly framed: GridFrame | null;
  readonly slices: readonly Slice[];
  /** What else cuts rays. */
  readonly cuts: readonly RayCut[];
  /** What these cut away, in the world; absent for nothing. */
  readonly away?: WorldCut;
  /** null for none. */
  readonly rings: LabelledRings | null;
}

export const noCuts: Cuts = { region: null, framed: null, slices: [], cuts: [], rings: null };
