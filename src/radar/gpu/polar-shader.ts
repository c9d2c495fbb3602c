import slices from '../../../shaders/chunks/slices.glsl?raw';
import volumePolar from '../../../shaders/chunks/volume-polar.glsl?raw';

/** `sampleVolume` of volumes on a radar's polar grid, and the slices in them: what only a page with a radar loads. */
export const polarSampling: string = volumePolar + slices;
