// What more than the steps changes a picture enters its error: what a video lost, and what coarse bricks hide. Only pages that show such volumes load it.
import { includePart, scaleLoss } from '../../quality/include-loss.ts';
import type { ErrorPart } from '../../quality/error-estimate.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import type { Volume } from '../../volume/volume.ts';
import { withDefaultLook } from '../appearance/default-look.ts';
import { resolveAppearance } from '../appearance/resolve-appearance.ts';
import { plainAppearance } from '../model/plain-appearance.ts';
import type { QualityFinding } from './chosen-level.ts';

/**
 * What was found of a picture, and with it what the form of its volume leaves. More steps can't mend that, so they are chosen before, by their own error:
 * see `ViewQuality`.
 * @param seen - what is visible now
 */
export async function includeLoss<T extends QualityFinding>(
  found: T,
  volume: Volume,
  seen: SeenVolume | null,
  maxError: number,
): Promise<T> {
  // What coarse bricks hide may be all that a view shows.
  const detail = volume.finer?.error;
  if (!found.error || !(found.error.rays || detail?.rms)) return found;
  let error = detail ? includePart(found.error, 'detail', detail) : found.error;
  const loss = seen && (await findLoss(volume, seen));
  if (loss) error = includePart(error, 'lossy', loss);
  return { ...found, error, isKept: found.isKept && error.rms <= maxError };
}

async function findLoss(volume: Volume, seen: SeenVolume): Promise<ErrorPart | null> {
  if (!volume.lossy) return null;
  // The pictures that were compared when the form was made had the look of a page that says nothing.
  const { transferFunction, opacityFactor, referenceLength } = await resolveAppearance(
    withDefaultLook(plainAppearance, volume),
    volume,
  );
  const made = { transferFunction, opticalScale: opacityFactor / referenceLength };
  return scaleLoss(volume.lossy, volume, { now: seen, made });
}
