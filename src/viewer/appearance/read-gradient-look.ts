// What attributes say of gradients: loaded with the first of them.
import { parseGradientOpacity } from '../../optics/transfer/parse-gradient-opacity.ts';
import { parsePatches } from '../../optics/transfer/parse-patches.ts';
import { outlinePatches } from '../../optics/transfer/patches.ts';
import { spanAround } from '../../optics/transfer/span-around.ts';
import type { LookSettings } from '../model/settings.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/**
 * A look by gradients too. A projection shows values, and has none.
 * @param range - of the data
 * @throws {VolumeViewError} `attribute/invalid`, `transfer-function/syntax`
 */
export function withGradients({ gradientOpacity, transferFunction2d }: LookSettings, optics: VolumeOptics, range: readonly [number, number]): VolumeOptics {
  const { referenceLength, projection, surfaces } = optics;
  // Of data that are all the same, percentages rise too.
  const window = optics.window[1] > optics.window[0] ? optics.window : spanAround(optics.window[0]);
  const steepest = (window[1] - window[0]) / referenceLength;
  const stops = parseGradientOpacity(gradientOpacity ?? '', steepest);
  const patches = parsePatches(transferFunction2d ?? '', { window, steepest });
  return {
    ...optics,
    ...(stops.length > 0 && { styles: [{ weight: 1, styles: [{ kind: 'gradient', stops }] }] }),
    // There is fog beside surfaces.
    ...(patches.length > 0 && !projection && { patches, transferFunction: outlinePatches(patches, range), surfaces: surfaces && { surfaces: surfaces.surfaces, ...(surfaces.plain && { plain: true }) } }),
  };
}
