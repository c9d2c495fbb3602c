import { define } from '../internal/define.ts';
import { VolumeLabel } from './volume-label.ts';

define('volume-label', VolumeLabel);

export { VolumeLabel };
