import { defaultPreset } from './default-preset.ts';

/** Presets that are written as stops, see presets.ts */
export const writtenPresets = ['gray', 'ct-bone', 'ct-soft-tissue', 'ct-angio', 'ct-lung', 'radar-dbz', 'radar-velocity', 'diverging'] as const;

/** Presets that paint a colour table over the window; the tables are loaded when one is used. */
export const colorTables = ['viridis', 'inferno', 'magma', 'plasma', 'cividis', 'turbo'] as const;

/** Names that `transfer-function` takes. */
export const presetNames: readonly string[] = [defaultPreset, ...writtenPresets, ...colorTables];
