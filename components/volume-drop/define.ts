import { define } from '../internal/define.ts';
import { VolumeDrop } from './volume-drop.ts';

define('volume-drop', VolumeDrop);

export { VolumeDrop };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
