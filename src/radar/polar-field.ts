import { storedField } from '../optics/rays/ray-field.ts';
import type { FieldStage } from '../optics/rays/ray-stages.ts';
import type { PolarData } from '../volume/volume.ts';
import { interpolateBeam, polarSampler } from './interpolate-polar.ts';
import type { BeamField } from './polar-gradient.ts';

type PolarSamples = Pick<PolarData, 'samples' | 'grid' | 'slope' | 'intercept'>;

/** The field of samples on a radar's polar grid; velocities fold. Twin: shaders/chunks/radar/volume-polar.glsl */
export function polarField(volume: PolarSamples): FieldStage {
  return storedField(polarSampler(volume), volume, volume.grid.foldFrom);
}

/**
 * The field of another moment of the same gates, by places of the first moment's unit cube. Each moment's own box ends above its highest
 * gate with data.
 */
export function secondMomentField(over: PolarData, volume: PolarData): FieldStage {
  return polarField({ ...volume, grid: { ...volume.grid, box: over.grid.box } });
}

/** A field by range, azimuth and elevation. */
export function polarBeamField(volume: PolarSamples): BeamField {
  const { samples, grid, slope, intercept } = volume;
  const { isFolded } = polarField(volume);
  return {
    isFolded,
    sampleBeam: (beam) => {
      const value = slope * interpolateBeam(samples, grid, beam) + intercept;
      return { value, valid: !Number.isNaN(value) };
    },
  };
}
