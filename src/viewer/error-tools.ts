// All that measures the error of a picture: loaded when the first one is there.
export { foretellSampling } from '../quality/adaptive-sampling.ts';
export { chooseLevel } from '../quality/choose-level.ts';
export { keptError } from '../quality/error-estimate.ts';
export { boundMissed, stateError } from '../quality/largest-error.ts';
export { errorAtHalf, ErrorProbe } from './measure-quality.ts';
