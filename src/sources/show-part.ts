import type { Budget } from '../formats/base/budget.ts';
import type { DecodedCartesianVolume } from '../formats/base/decoded-volume.ts';
import type { CoarseListener, LoadRequest } from '../formats/base/load-request.ts';
import { finishVolume } from '../formats/finish-volume.ts';

/** The load for which files are read. */
export interface FolderLoad {
  readonly request: Pick<LoadRequest, 'limits' | 'settings'>;
  /** Grows with files whose size is not known before they have come. */
  readonly budget?: Pick<Budget, 'addFile' | 'deviceBytes'>;
  /** Receives the bytes that are read of all files together. */
  readonly onProgress: (loaded: number, total: number) => void;
  /** Taken away when a part was shown: what else stands in for the volume would come late. */
  onCoarse?: CoarseListener;
}

/** Shows a small volume of a part of the data, while the rest is read. @param grid - of the whole volume */
export async function showPart(
  load: FolderLoad,
  part: DecodedCartesianVolume,
  grid: DecodedCartesianVolume['grid'],
): Promise<void> {
  const { request, onCoarse } = load;
  const limits = await request.limits;
  // What is wrong with a part is so with the whole, which says it.
  const volume = await finishVolume(part, limits, undefined, request.settings?.clean).catch(() => null);
  // Of labels there are no values between two slices.
  if (!onCoarse || !volume || volume.isDiscrete) return;
  const { samples: _few, macrocells: _ofFew, channels: _alsoFew, ...of } = volume;
  load.onCoarse = undefined;
  onCoarse({ volume: { ...volume, coarse: true }, of: { ...of, grid } });
}
