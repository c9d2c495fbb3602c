import { define } from '../internal/define.ts';
import { VolumeTransferFunction } from './volume-transfer-function.ts';

define('volume-transfer-function', VolumeTransferFunction);

export { VolumeTransferFunction };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
