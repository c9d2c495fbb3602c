import { storedField } from '../optics/ray-field.ts';
import type { FieldStage } from '../optics/ray-stages.ts';
import type { PolarVolume } from '../volume/volume.ts';
import { polarSampler } from './interpolate-polar.ts';

/** Samples on a radar's polar grid, which velocities fold on. Twin: shaders/chunks/volume-polar.glsl */
export function polarField(volume: Pick<PolarVolume, 'samples' | 'grid' | 'slope' | 'intercept'>): FieldStage {
  return storedField(polarSampler(volume), volume, volume.grid.foldFrom);
}
