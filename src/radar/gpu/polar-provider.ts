import type { FieldProvider } from '../../renderer/ray/ray-module.ts';
import { uploadPolarVolume } from './polar-field-module.ts';
import { createSlices } from './slices-module.ts';

/** How volumes on polar grids are uploaded to the GPU. Only pages with a radar load this. */
export const polarProvider: FieldProvider = {
  upload: uploadPolarVolume,
  createSlices,
  second: async () => (await import('./second-moment.ts')).uploadSecondMoment,
};
