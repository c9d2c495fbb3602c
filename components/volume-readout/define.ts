import { define } from '../internal/define.ts';
import { VolumeReadout } from './volume-readout.ts';

define('volume-readout', VolumeReadout);

export { VolumeReadout };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
