import type { DecodedVolume, DecodeSettings } from './decoded-volume.ts';
import { respace } from './respace.ts';

/** A file's own place in the world gives way to a manifest's, and its spacing to what an attribute or manifest says. */
export function placeVolume(volume: DecodedVolume, settings: DecodeSettings): DecodedVolume {
  const own = settings.indexToWorld ?? volume.indexToWorld;
  return { ...volume, indexToWorld: settings.spacing ? respace(own, volume.dimensions, settings.spacing) : own };
}
