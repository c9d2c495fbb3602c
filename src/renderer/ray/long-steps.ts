import count from '../../../shaders/chunks/walk/long-steps.glsl?raw';
import type { StepCode } from '../../optics/cells/substeps.ts';

/** Steps that are longer than a voxel in cells that allow it. */
export const longSteps: StepCode = { name: 'long steps', defines: { LONG: 1 }, count };
