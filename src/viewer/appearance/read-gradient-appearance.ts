// Reads the attributes about gradients: loaded with the first of them.
import { parseGradientOpacity } from '../../optics/transfer/parse-gradient-opacity.ts';
import { parsePatches } from '../../optics/transfer/parse-patches.ts';
import { outlinePatches } from '../../optics/transfer/patches.ts';
import { spanAround } from '../../optics/transfer/span-around.ts';
import type { AppearanceSettings } from '../model/settings.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/**
 * The appearance with gradients too. A projection shows values, so gradients do not change it.
 * @param range - of the data
 * @throws {VolumeViewError} `attribute/invalid`, `transfer-function/syntax`
 */
export function withGradients(
  { gradientOpacity, transferFunction2d }: AppearanceSettings,
  optics: VolumeOptics,
  range: readonly [number, number],
): VolumeOptics {
  const { referenceLength, projection, surfaces } = optics;
  // If all data have the same value, percentages still need a range.
  const window = optics.window[1] > optics.window[0] ? optics.window : spanAround(optics.window[0]);
  const steepest = (window[1] - window[0]) / referenceLength;
  const stops = parseGradientOpacity(gradientOpacity ?? '', steepest);
  const patches = parsePatches(transferFunction2d ?? '', { window, steepest });
  return {
    ...optics,
    ...(stops.length > 0 && { styles: [{ weight: 1, styles: [{ kind: 'gradient', stops }] }] }),
    // Patches emit and absorb as fog, in addition to surfaces.
    ...(patches.length > 0 &&
      !projection && {
        patches,
        transferFunction: outlinePatches(patches, range),
        surfaces: surfaces && { surfaces: surfaces.surfaces, ...(surfaces.plain && { plain: true }) },
      }),
  };
}
