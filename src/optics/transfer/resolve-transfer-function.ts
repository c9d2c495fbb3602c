import { buildDefaultPreset, defaultPreset } from './default-preset.ts';
import type { TransferFunction } from './transfer-function.ts';

/**
 * Reads a transfer function from an attribute: a preset's name, or stops. A value that is no text is returned as it is. The code for
 * everything but the default is loaded when it is first needed.
 * @param window - the data values that presets and percentages span
 * @throws {VolumeViewError} `transfer-function/syntax`
 */
export async function resolveTransferFunction(
  text: string | TransferFunction,
  window: readonly [number, number],
): Promise<TransferFunction> {
  if (typeof text !== 'string') return text;
  if (text.trim().toLowerCase() === defaultPreset) return buildDefaultPreset(window);
  const { readTransferFunction } = await import('./presets.ts');
  return readTransferFunction(text, window);
}
