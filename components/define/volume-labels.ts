import { define } from '../define.ts';
import './volume-label.ts';
import { VolumeLabels } from '../volume-labels.ts';

define('volume-labels', VolumeLabels);

export { VolumeLabels };
