import { defaultPreset } from '../optics/default-preset.ts';
import { resolveTransferFunction } from '../optics/resolve-transfer-function.ts';
import { windowFromHistogram } from '../optics/window.ts';
import { edgeLengths } from '../volume/grid.ts';
import type { Histogram } from '../volume/histogram.ts';
import type { ScanModel } from './scan-model.ts';
import type { LookSettings } from './settings.ts';
import type { VolumeOptics } from './volume-info.ts';

/**
 * What a volume looks like: what the author says, else what its file says, else what its histogram suggests.
 * @throws {VolumeViewError} `transfer-function/syntax`
 */
export async function resolveLook(look: LookSettings, volume: ScanModel): Promise<VolumeOptics> {
  const window = look.window ?? volume.window ?? suggestWindow(volume);
  const text = look.transferFunction ?? volume.transferFunction ?? suggestPreset(volume);
  return {
    transferFunction: await resolveTransferFunction(text, window),
    window,
    referenceLength: look.referenceLength ?? Math.max(...edgeLengths(volume.grid)) / 100,
    opacityFactor: look.opacityFactor,
    lightFactor: look.lightFactor,
    projection: look.projection,
  };
}

/** Velocities lie around 0, other moments of a radar anywhere; elsewhere the background is left out. */
function suggestWindow({ grid, unit, range, histogram }: ScanModel): [number, number] {
  if (grid.kind !== 'polar' || !(range[1] > range[0])) return windowFromHistogram(histogram);
  const fastest = Math.max(...range.map(Math.abs));
  return unit === 'm/s' ? [-fastest, fastest] : [...range];
}

/** Some units have a scale that everybody knows. */
function suggestPreset({ grid, unit, histogram }: ScanModel): string {
  if (grid.kind !== 'polar') return unit === 'dBZ' ? 'radar-dbz' : unit === 'HU' ? 'ct-bone' : defaultPreset;
  if (unit === 'm/s') return 'radar-velocity';
  return unit === 'dBZ' && !isCloud(histogram) ? 'radar-dbz' : 'turbo';
}

/** What a weather radar's scale begins with, dBZ. */
const minRain = 5;

/** A cloud radar's reflectivities lie below those of rain: on the scale of that there would be nothing to be seen. */
function isCloud({ low, high, counts }: Histogram): boolean {
  const first = Math.ceil(((minRain - low) / (high - low)) * counts.length);
  const sum = (values: Uint32Array): number => values.reduce((total, count) => total + count, 0);
  return sum(counts.subarray(Math.max(0, first))) < 0.05 * sum(counts);
}
