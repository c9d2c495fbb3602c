import { loadPart } from '../load-part.ts';
import type { VolumeOptics } from './volume-info.ts';

/** What a volume of labels looks like, as what draws it has it: by the places of its ids. */
export async function opticsByPlace(ids: readonly number[], optics: VolumeOptics): Promise<VolumeOptics> {
  const { stopsByPlace } = await loadPart(import('../optics/label-stops.ts'), 'shows labels');
  return { ...optics, transferFunction: stopsByPlace(optics.transferFunction, ids), window: [0, ids.length - 1] };
}
