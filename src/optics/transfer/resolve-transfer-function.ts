import { buildDefaultPreset, defaultPreset } from './default-preset.ts';
import type { TransferFunction } from './transfer-function.ts';

/**
 * A transfer function from an attribute: a preset's name, or stops. What is no text is one already. What reads all but the default is loaded with the first.
 * @param window - data values that presets and percentages span
 * @throws {VolumeViewError} `transfer-function/syntax`
 */
export async function resolveTransferFunction(text: string | TransferFunction, window: readonly [number, number]): Promise<TransferFunction> {
  if (typeof text !== 'string') return text;
  if (text.trim().toLowerCase() === defaultPreset) return buildDefaultPreset(window);
  const { readTransferFunction } = await import('./presets.ts');
  return readTransferFunction(text, window);
}
