import { startCompanions } from '../internal/companions.ts';
import { define } from '../internal/define.ts';
import { VolumeView } from './volume-view.ts';

if (!define('volume-view', VolumeView)) startCompanions();

export { VolumeView };
