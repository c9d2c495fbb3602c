import { define } from '../internal/define.ts';
import { VolumeStep } from './volume-step.ts';

define('volume-step', VolumeStep);

export { VolumeStep };
