import { define } from '../define.ts';
import { VolumeMeasure } from '../volume-measure.ts';

define('volume-measure', VolumeMeasure);

export { VolumeMeasure };
export { registerTranslation } from '../../src/messages/words.ts';
