import { buildDefaultPreset, defaultPreset } from './default-preset.ts';
import type { TransferFunction } from './transfer-function.ts';

/**
 * A transfer function from an attribute: a preset's name, or stops. What reads all but the default is loaded with the first.
 * @param window - data values that presets and percentages span
 * @throws {VolumeViewError} `transfer-function/syntax`
 */
export async function resolveTransferFunction(text: string, window: readonly [number, number]): Promise<TransferFunction> {
  if (text.trim().toLowerCase() === defaultPreset) return buildDefaultPreset(window);
  const { readTransferFunction } = await import('./presets.ts');
  return readTransferFunction(text, window);
}
