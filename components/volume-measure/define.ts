import { define } from '../internal/define.ts';
import { VolumeMeasure } from './volume-measure.ts';

define('volume-measure', VolumeMeasure);

export { VolumeMeasure };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
