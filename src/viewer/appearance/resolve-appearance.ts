import { loadPart } from '../../core/load-part.ts';
import { defaultPreset } from '../../optics/transfer/default-preset.ts';
import { resolveTransferFunction } from '../../optics/transfer/resolve-transfer-function.ts';
import { spanAround } from '../../optics/transfer/span-around.ts';
import { largestWindow } from '../../optics/transfer/transfer-function.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { defaultReferenceLength } from '../../volume/reference-length.ts';
import { loadLabelStops } from '../model/optics-by-place.ts';
import type { ScanModel } from '../model/scan-model.ts';
import type { AppearanceSettings } from '../model/settings.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** The transfer function of a volume whose page gives none. */
export async function suggestedOf({
  transferFunction,
  ids,
  named,
}: Pick<ScanModel, 'transferFunction' | 'ids' | 'named'>): Promise<string | TransferFunction> {
  if (transferFunction || !ids) return transferFunction ?? defaultPreset;
  return (await loadLabelStops()).plainLabelStops(ids, named);
}

/**
 * The appearance of a volume: what the author says, else what its file says or its values suggest.
 * @throws {VolumeViewError} `transfer-function/syntax`, `attribute/invalid`
 */
export async function resolveAppearance(said: AppearanceSettings, volume: ScanModel): Promise<VolumeOptics> {
  const { named, window: given } = said;
  const appearance =
    named === null && typeof given !== 'string'
      ? { ...said, window: given }
      : (await loadPart(import('./apply-names.ts'), 'reads looks')).applyNames(said, volume);
  const [low, high] = appearance.window ?? volume.window ?? volume.range;
  const ends = [low, high].map((end) => Math.min(largestWindow, Math.max(-largestWindow, end)));
  const window = ends[0] < ends[1] ? ([ends[0], ends[1]] as const) : spanAround(ends[0]);
  const text = appearance.transferFunction ?? (await suggestedOf(volume));
  const optics: VolumeOptics = {
    transferFunction: await resolveTransferFunction(text, window),
    window,
    referenceLength: appearance.referenceLength ?? volume.referenceLength ?? defaultReferenceLength(volume.grid),
    opacityFactor: appearance.opacityFactor ?? 1,
    lightFactor: appearance.lightFactor,
    projection: appearance.projection,
    shading: appearance.shading ?? 'unlit',
    surfaces: appearance.surfaces
      ? (await loadPart(import('../../optics/surfaces/parse-surfaces.ts'), 'reads surfaces')).readSurfaces(
          appearance.surfaces,
          window,
          appearance,
        )
      : null,
  };
  return appearance.gradientOpacity || appearance.transferFunction2d
    ? (await loadPart(import('./read-gradient-appearance.ts'), 'reads gradients')).withGradients(
        appearance,
        optics,
        volume.range,
      )
    : optics;
}
