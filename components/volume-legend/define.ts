import { define } from '../internal/define.ts';
import { VolumeLegend } from './volume-legend.ts';

define('volume-legend', VolumeLegend);

export { VolumeLegend };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
