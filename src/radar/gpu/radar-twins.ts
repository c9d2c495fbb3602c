import { loadPart } from '../../core/load-part.ts';
import { later } from '../../renderer/ray/ray-twin.ts';

/** The code of the twins of a radar's modules. */
export const radarTwins = later(() => loadPart(import('../twins.ts'), 'looks into radar volumes'));
