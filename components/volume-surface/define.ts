import { define } from '../internal/define.ts';
import { VolumeSurface } from './volume-surface.ts';

define('volume-surface', VolumeSurface);

export { VolumeSurface };
