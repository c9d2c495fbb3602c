import type { FieldProvider } from '../../renderer/ray/ray-module.ts';
import { uploadPolarVolume } from './polar-field-module.ts';
import { createSlices } from './slices-module.ts';

/** How volumes on polar grids are brought to the GPU: what only a page with a radar loads. */
export const polarProvider: FieldProvider = {
  upload: uploadPolarVolume,
  createSlices,
  second: async () => (await import('./second-moment.ts')).uploadSecondMoment,
};
