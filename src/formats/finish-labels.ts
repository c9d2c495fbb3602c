// For volumes of labels that have to be made smaller, or that have more labels, or larger ids, than a transfer function
// of values can distinguish.
import { cartesianGrid } from '../volume/grid.ts';
import { summarize } from '../volume/histogram.ts';
import { indexLabels, summarizeLabels } from '../volume/label-volume.ts';
import { buildMacrocells } from '../volume/macrocells.ts';
import type { Block } from '../volume/reduce.ts';
import { reduceLabels } from '../volume/reduce-labels.ts';
import type { Volume } from '../volume/volume.ts';
import type { DecodedCartesianVolume } from './base/decoded-volume.ts';
import type { CoarseVolume } from './base/load-request.ts';
import type { SuggestedAppearance } from './appearance/suggested-appearance.ts';

interface Labels {
  readonly decoded: DecodedCartesianVolume;
  /** The volume without its samples, with the appearance that was found. */
  readonly outline: CoarseVolume['of'];
  /** Reduces a block to the size that the device holds. */
  fit(block: Block): Promise<Block>;
}

/** Labels have no mean: each of the larger voxels gets the label that most of it has. */
export async function finishLabels({ decoded, outline, fit }: Labels): Promise<Volume> {
  const { reduced: _made, ...rest } = outline;
  const isSmall =
    outline.transferFunction !== undefined && !decoded.indexed && !(decoded.samples instanceof Float32Array);
  const indexed = isSmall ? null : indexLabels(decoded);
  const numbers = indexed?.samples ?? decoded.samples;
  if (!(isSmall || indexed) || numbers instanceof Float32Array) return finishOthers(outline, decoded, fit);
  const from = decoded.grid.dimensions;
  const { dimensions, indexToWorld } = await fit({ ...decoded.grid, samples: numbers });
  const isReduced = String(dimensions) !== String(from);
  const samples = isReduced
    ? reduceLabels({ dimensions: from, numbers, ids: { length: 2 ** (8 * numbers.BYTES_PER_ELEMENT) } }, dimensions)
        .numbers
    : numbers;
  const summary = indexed
    ? {
        ...summarizeLabels(samples, indexed.ids),
        ids: indexed.ids,
        slope: 1,
        intercept: 0,
        indexed: undefined,
        transferFunction: decoded.transferFunction,
      }
    : summarize(samples, decoded.slope, decoded.intercept);
  return {
    ...rest,
    ...summary,
    grid: cartesianGrid(dimensions, indexToWorld),
    samples,
    macrocells: buildMacrocells(samples, dimensions),
    ...(isReduced || decoded.reduced ? { reduced: { from: decoded.reduced?.from ?? from, to: dimensions } } : {}),
  };
}

/**
 * For files that call their values labels, although they are not whole numbers, or too many: the values are shown as
 * they are.
 */
async function finishOthers(
  outline: CoarseVolume['of'],
  { grid, samples: all }: DecodedCartesianVolume,
  fit: Labels['fit'],
): Promise<Volume> {
  const plain: SuggestedAppearance = { window: outline.range, transferFunction: undefined, isDiscrete: undefined };
  const { samples, dimensions } = await fit({ ...grid, samples: all });
  const notes = [
    ...(outline.left ?? []),
    'it says that its values are labels, but they are not whole numbers, at most 65,536 different ones up to 9,007,199,254,740,991: they are shown as measured values',
  ];
  return { ...outline, ...plain, left: notes, samples, macrocells: buildMacrocells(samples, dimensions) };
}
