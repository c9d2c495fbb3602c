import { loadPart } from '../../core/load-part.ts';
import type * as labelStops from '../../optics/transfer/label-stops.ts';
import type { VolumeOptics } from './volume-info.ts';

/** What makes transfer functions of labels: loaded with the first whose samples are places in a list of ids. */
export const loadLabelStops = (): Promise<typeof labelStops> => loadPart(import('../../optics/transfer/label-stops.ts'), 'shows labels');

/** What a volume of labels looks like, as what draws it has it: by the places of its ids. */
export async function opticsByPlace(ids: readonly number[], optics: VolumeOptics): Promise<VolumeOptics> {
  const { stopsByPlace } = await loadLabelStops();
  return { ...optics, transferFunction: stopsByPlace(optics.transferFunction, ids), window: [0, ids.length - 1] };
}
