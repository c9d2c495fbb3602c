import { define } from '../define.ts';
import { VolumeLayer } from '../volume-layer.ts';

define('volume-layer', VolumeLayer);

export { VolumeLayer };
