import { define } from '../internal/define.ts';
import { VolumeNote } from './volume-note.ts';

define('volume-note', VolumeNote);

export { VolumeNote };
