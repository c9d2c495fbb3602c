import type { FieldProviders } from '../../src/renderer/layers/volume-layer.ts';

/** What draws volumes that are not on cartesian grids; loaded when the first one comes. */
export const fieldProviders: FieldProviders = {
  polar: async () => (await import('../../src/radar/gpu/polar-provider.ts')).polarProvider,
  polarTaps: async () => (await import('../../src/radar/gpu/polar-taps.ts')).polarTapsOf,
};
