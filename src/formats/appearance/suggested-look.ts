import type { Volume } from '../../volume/volume.ts';

/** What a volume looks like where its file does not say. */
export type SuggestedLook = Pick<Volume, 'window' | 'transferFunction' | 'isDiscrete'>;

/** Some units have a scale that everybody knows. */
export function presetOfUnit(unit: string): string | undefined {
  return unit === 'HU' ? 'ct-bone' : unit === 'dBZ' ? 'radar-dbz' : undefined;
}
