// What a video lost enters the error of its pictures. Only pages that show one load it.
import { includePart, scaleLoss } from '../../quality/include-loss.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import type { Volume } from '../../volume/volume.ts';
import { withDefaultLook } from '../appearance/default-look.ts';
import { resolveAppearance } from '../appearance/resolve-appearance.ts';
import { plainAppearance } from '../model/plain-appearance.ts';
import type { QualityFinding } from './chosen-level.ts';

/**
 * What was found of a picture, and with it what the lossy form of its volume leaves. More steps can't mend that, so they are chosen before, by their own error.
 * @param seen - what is visible now
 */
export async function includeLoss<T extends QualityFinding>(
  found: T,
  volume: Volume,
  seen: SeenVolume | null,
  maxError: number,
): Promise<T> {
  if (!seen || !volume.lossy || !found.error?.rays) return found;
  // The pictures that were compared when the form was made had the look of a page that says nothing.
  const { transferFunction, opacityFactor, referenceLength } = await resolveAppearance(
    withDefaultLook(plainAppearance, volume),
    volume,
  );
  const then = { transferFunction, opticalScale: opacityFactor / referenceLength };
  const loss = scaleLoss(volume.lossy, volume, { now: seen, then });
  if (!loss) return found;
  const error = includePart(found.error, 'lossy', loss);
  return { ...found, error, isKept: found.isKept && error.rms <= maxError };
}
