import { define } from '../internal/define.ts';
import { VolumeQuestion } from './volume-question.ts';

define('volume-question', VolumeQuestion);

export { VolumeQuestion };
