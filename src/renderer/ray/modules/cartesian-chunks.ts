// Parts of fields that only few devices and few volumes need: the first volume that needs them loads this file.
export { default as interpolateVoxels } from '../../../../shaders/chunks/field/interpolate.glsl?raw';
export { default as volumeMosaic } from '../../../../shaders/chunks/field/volume-mosaic.glsl?raw';
export { allocatePlane, fillPlane } from '../../textures/fill-plane.ts';
export { chooseFloatScale, packFloats } from '../../device/prepare-floats.ts';
export { weighTexels } from './weighed-texels.ts';
