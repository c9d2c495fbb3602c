import { define } from '../internal/define.ts';
import { VolumeClip } from './volume-clip.ts';

define('volume-clip', VolumeClip);

export { VolumeClip };
