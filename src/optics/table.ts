import { classifyStep } from './transfer-function.ts';
import type { OpticalFactors, TransferFunction } from './transfer-function.ts';

/** A transfer function sampled for one step length: what the ray-caster's look-up texture holds. */
export interface StepTable {
  /** Shape [size, 4], row-major: premultiplied colour and opacity of one full step. */
  readonly texels: Float32Array<ArrayBuffer>;
  /** Data values of the centres of the first and the last texel. */
  readonly low: number;
  readonly high: number;
}

/**
 * Texels of a table. Between them the GPU interpolates, which is exact for a piecewise linear function but next to its
 * stops; 2,048 texels keep that below the picture's 8 bits for stops that are half a percent of the domain apart.
 */
export const tableSize = 2048;

/**
 * Sample a transfer function, opacity correction included, so that the shader needs neither a logarithm nor a power
 * per sample.
 * @param ratio - step length / reference length
 * @throws {RangeError} where the transfer function has no stop
 */
export function buildStepTable(
  transferFunction: TransferFunction,
  ratio: number,
  factors: OpticalFactors,
  size = tableSize,
): StepTable {
  if (transferFunction.length === 0) throw new RangeError('buildStepTable got no stop; expected 1 or more');
  const [low, high] = tableDomain(transferFunction);
  const texels = new Float32Array(size * 4);
  for (let i = 0; i < size; i++) {
    const value = low + ((high - low) * i) / (size - 1);
    texels.set(classifyStep(transferFunction, value, ratio, factors), i * 4);
  }
  return { texels, low, high };
}

/** From the first to the last stop, outside of which nothing changes; widened a little where they coincide. */
function tableDomain(transferFunction: TransferFunction): [number, number] {
  const low = transferFunction[0].value;
  const high = transferFunction[transferFunction.length - 1].value;
  if (high > low) return [low, high];
  const margin = Math.max(Math.abs(low) * 1e-6, 1e-9);
  return [low - margin, high + margin];
}
