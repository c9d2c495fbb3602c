/** `sampleVolume` of volumes on a radar's polar grid: what only a page with a radar loads. */
export { default as polarSampling } from '../../shaders/chunks/volume-polar.glsl?raw';
