import { define } from '../internal/define.ts';
import { VolumeSliceView } from './volume-slice-view.ts';

define('volume-slice-view', VolumeSliceView);

export { VolumeSliceView };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
