import { emptyQuad, interpolateQuad } from '../../optics/rays/between-pixels.ts';
import { keptError } from '../../quality/error-estimate.ts';
import { stateError } from '../../quality/largest-error.ts';
import { rangeEmission } from '../../optics/transfer/emission-range.ts';
import { aside, ErrorProbe } from './measure-quality.ts';

/**
 * What `free-quality.ts` and `jump-quality.ts` need of the part that measures pictures. They are given, not imported: where one part of the package imports from
 * another that is loaded on demand, each page pays one more request, also pages that do not use it.
 */
export const measuringTools = { aside, emptyQuad, ErrorProbe, interpolateQuad, keptError, rangeEmission, stateError };

export type MeasuringTools = typeof measuringTools;
