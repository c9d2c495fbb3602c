import { define } from '../internal/define.ts';
import './volume-label.ts';
import { VolumeLabels } from '../volume-labels/volume-labels.ts';

define('volume-labels', VolumeLabels);

export { VolumeLabels };
