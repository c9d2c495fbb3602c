import { define } from '../internal/define.ts';
import { VolumeLayer } from './volume-layer.ts';

define('volume-layer', VolumeLayer);

export { VolumeLayer };
