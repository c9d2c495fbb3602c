import { defaultPreset } from './default-preset.ts';

/** Presets written as stops, see presets.ts */
export const writtenPresets = [
  'gray',
  'ct-bone',
  'ct-soft-tissue',
  'ct-angio',
  'ct-lung',
  'radar-dbz',
  'radar-velocity',
  'diverging',
] as const;

/** Presets with a colour table over the window. The tables are loaded with the first one. */
export const colorTables = ['viridis', 'inferno', 'magma', 'plasma', 'cividis', 'turbo'] as const;

/** The names that `transfer-function` accepts. */
export const presetNames: readonly string[] = [defaultPreset, ...writtenPresets, ...colorTables];
