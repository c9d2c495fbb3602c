import { define } from '../internal/define.ts';
import { VolumeTerrain } from './volume-terrain.ts';

define('volume-terrain', VolumeTerrain);

export { VolumeTerrain };
