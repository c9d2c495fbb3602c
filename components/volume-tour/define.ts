import '../volume-step/define.ts';
import { define } from '../internal/define.ts';
import { VolumeTour } from './volume-tour.ts';

define('volume-tour', VolumeTour);

export { VolumeTour };
