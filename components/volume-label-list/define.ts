import { define } from '../internal/define.ts';
import { VolumeLabelList } from './volume-label-list.ts';

define('volume-label-list', VolumeLabelList);

export { VolumeLabelList };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
