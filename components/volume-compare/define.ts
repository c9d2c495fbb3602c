import { define } from '../internal/define.ts';
import { VolumeCompare } from './volume-compare.ts';

define('volume-compare', VolumeCompare);

export { VolumeCompare };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
