import { startCompanions } from '../companions.ts';
import { define } from '../define.ts';
import { VolumeView } from '../volume-view.ts';

define('volume-view', VolumeView);
startCompanions();

export { VolumeView };
