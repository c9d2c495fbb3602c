import { define } from '../define.ts';
import { VolumeTerrain } from '../volume-terrain.ts';

define('volume-terrain', VolumeTerrain);

export { VolumeTerrain };
