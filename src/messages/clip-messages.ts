/** The messages of <volume-clip>. */
export interface ClipMessages {
  /** The handle of a plane. */
  readonly clipPlane: string;
  /** The handle that moves the whole box. */
  readonly clipBox: string;
  /** Handles of its sides: at the low end of each axis of the world, and at the high end. */
  readonly clipSides: readonly (readonly [low: string, high: string])[];
}
