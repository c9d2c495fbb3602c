import { emptyQuad, interpolateQuad } from '../../src/optics/rays/between-pixels.ts';
import { keptError } from '../../src/quality/error-estimate.ts';
import type { SparingTools } from '../../src/quality/spare-rays.ts';

export const sparingTools: SparingTools = { emptyQuad, interpolateQuad, keptError };
