import type { Volume } from '../../volume/volume.ts';

/** The appearance of a volume whose file gives none. */
export type SuggestedAppearance = Pick<Volume, 'window' | 'transferFunction' | 'isDiscrete'>;

/** The colour preset of units that have a well-known scale. */
export function presetOfUnit(unit: string): string | undefined {
  return unit === 'HU' ? 'ct-bone' : unit === 'dBZ' ? 'radar-dbz' : undefined;
}
