import { define } from '../define.ts';
import { VolumeLabel } from '../volume-label.ts';

define('volume-label', VolumeLabel);

export { VolumeLabel };
