import type { FieldProviders } from '../../src/renderer/layers/volume-layer.ts';

/** The code that draws volumes whose grid is not cartesian. It is loaded with the first such volume. */
export const fieldProviders: FieldProviders = {
  polar: async () => (await import('../../src/radar/gpu/polar-provider.ts')).polarProvider,
  polarTaps: async () => (await import('../../src/radar/gpu/polar-taps.ts')).polarTapsOf,
};
