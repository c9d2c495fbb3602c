// What attributes say of gradients: loaded with the first of them.
import { parseGradientOpacity } from '../optics/parse-gradient-opacity.ts';
import { parsePatches } from '../optics/parse-patches.ts';
import { outlinePatches } from '../optics/patches.ts';
import type { LookSettings } from './settings.ts';
import type { VolumeOptics } from './volume-info.ts';

/**
 * A look by gradients too. A projection shows values, and has none.
 * @throws {VolumeViewError} `attribute/invalid`, `transfer-function/syntax`
 */
export function withGradients({ gradientOpacity, transferFunction2d }: LookSettings, optics: VolumeOptics): VolumeOptics {
  const { window, referenceLength, projection, surfaces } = optics;
  const steepest = (window[1] - window[0]) / referenceLength;
  const stops = parseGradientOpacity(gradientOpacity ?? '', steepest);
  const patches = parsePatches(transferFunction2d ?? '', { window, steepest });
  return {
    ...optics,
    ...(stops.length > 0 && { styles: [{ weight: 1, styles: [{ kind: 'gradient', stops }] }] }),
    // There is fog beside surfaces.
    ...(patches.length > 0 && !projection && { patches, transferFunction: outlinePatches(patches), surfaces: surfaces && { surfaces: surfaces.surfaces, ...(surfaces.plain && { plain: true }) } }),
  };
}
