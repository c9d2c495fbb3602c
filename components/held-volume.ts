import type { Volume } from '../src/volume/volume.ts';

/** Key of the samples that a <volume-view> holds, for companions that read them too: they are no part of its interface. */
export const heldVolume = Symbol('volume');

/** What holds a volume; null before it is there. */
export interface VolumeHolder {
  readonly [heldVolume]: Volume | null;
}
