import { loadPart } from '../../core/load-part.ts';
import type * as labelStops from '../../optics/transfer/label-stops.ts';
import type { VolumeOptics } from './volume-info.ts';

/** The code that makes transfer functions of labels: loaded with the first volume whose samples are indices in a list of ids. */
export const loadLabelStops = (): Promise<typeof labelStops> =>
  loadPart(import('../../optics/transfer/label-stops.ts'), 'shows labels');

/** The appearance of a volume of labels in the form that drawing needs: by the indices of its ids. */
export async function opticsByPlace(ids: readonly number[], optics: VolumeOptics): Promise<VolumeOptics> {
  const { stopsByPlace } = await loadLabelStops();
  return { ...optics, transferFunction: stopsByPlace(optics.transferFunction, ids), window: [0, ids.length - 1] };
}
