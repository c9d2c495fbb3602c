// What the smoke test compares with; run.mjs makes one module of it for the browser.
export { comparePictures, decodePicture } from '../e2e/helpers/pictures.ts';
export { drawReference, plainAttributes, plainOrbit } from '../e2e/helpers/reference.ts';
export { ball } from '../e2e/helpers/volumes.ts';
export { orbitCamera } from '../../src/optics/rays/camera.ts';
