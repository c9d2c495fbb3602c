import { define } from '../internal/define.ts';
import { VolumeWorkspace } from './volume-workspace.ts';

define('volume-workspace', VolumeWorkspace);

export { VolumeWorkspace };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
