export { encodePng, makeRadarMosaic } from '../../../src/prepare/radar-mosaic.ts';
export type { RadarMosaicFiles } from '../../../src/prepare/radar-mosaic.ts';
export { writePolarMosaic } from '../../../src/prepare/write-polar-mosaic.ts';
export type { WrittenMosaic } from '../../../src/prepare/write-polar-mosaic.ts';
export { formatManifest } from './format-manifest.ts';
export { nameFiles } from './name-files.ts';
export { maxPageBytes, writePage } from './write-page.ts';
