import { define } from '../internal/define.ts';
import { VolumeSeries } from './volume-series.ts';

define('volume-series', VolumeSeries);

export { VolumeSeries };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
