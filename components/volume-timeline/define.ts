import { define } from '../internal/define.ts';
import { VolumeTimeline } from './volume-timeline.ts';

define('volume-timeline', VolumeTimeline);

export { VolumeTimeline };
export { registerTranslation } from '../../src/messages/locale-controller.ts';
