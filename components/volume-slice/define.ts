import { define } from '../internal/define.ts';
import { VolumeSlice } from './volume-slice.ts';

define('volume-slice', VolumeSlice);

export { VolumeSlice };
