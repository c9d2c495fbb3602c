import type { Slice } from '../../radar/slices.ts';
import type { RayCut } from '../../renderer/ray/ray-module.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { WorldCut } from '../../volume/world-cut.ts';
import type { LabelledRings } from './read-rings.ts';

/** The visible part of a volume, its cuts, and what is drawn around it. */
export interface Cuts {
  /** null for the whole volume. */
  readonly region: GridFrame | null;
  /** The part that cameras frame, which may belong to another scan; null for the visible part. */
  readonly framed: GridFrame | null;
  readonly slices: readonly Slice[];
  /** Other shapes that cut rays. */
  readonly cuts: readonly RayCut[];
  /** What `cuts` cut away, in the world; absent for nothing. */
  readonly away?: WorldCut;
  /** null for none. */
  readonly rings: LabelledRings | null;
}

export const noCuts: Cuts = { region: null, framed: null, slices: [], cuts: [], rings: null };
