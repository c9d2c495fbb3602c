import { define } from '../define.ts';
import { VolumeLayerElement } from '../volume-layer.ts';

define('volume-layer', VolumeLayerElement);

export { VolumeLayerElement };
