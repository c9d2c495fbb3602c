import { define } from '../internal/define.ts';
import '../volume-label/define.ts';
import { VolumeLabels } from './volume-labels.ts';

define('volume-labels', VolumeLabels);

export { VolumeLabels };
