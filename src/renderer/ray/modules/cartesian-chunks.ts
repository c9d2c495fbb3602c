// Parts of fields that few devices and few volumes need: loaded with the first of these.
export { default as interpolateVoxels } from '../../../../shaders/chunks/field/interpolate.glsl?raw';
export { default as volumeMosaic } from '../../../../shaders/chunks/field/volume-mosaic.glsl?raw';
export { allocatePlane, fillPlane } from '../../textures/fill-plane.ts';
export { chooseFloatScale, prepareFloats } from '../../device/prepare-floats.ts';
