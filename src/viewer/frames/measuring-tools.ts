import { emptyQuad, interpolateQuad } from '../../optics/rays/between-pixels.ts';
import { keptError } from '../../quality/error-estimate.ts';
import { stateError } from '../../quality/largest-error.ts';
import { aside, ErrorProbe } from './measure-quality.ts';

/**
 * What `free-quality.ts` needs of the part that measures pictures. It is given, not imported: where one part of the package imports from
 * another that is loaded on demand, each page pays one more request, also pages that do not use it.
 */
export const measuringTools = { aside, emptyQuad, ErrorProbe, interpolateQuad, keptError, stateError };

export type MeasuringTools = typeof measuringTools;
