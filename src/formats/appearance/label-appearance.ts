import { labelColors as colors } from '../../volume/label-colors.ts';
import { maxLabels } from '../../volume/index-numbers.ts';
import type { Samples } from '../../volume/samples.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import type { SuggestedAppearance } from './suggested-appearance.ts';

/** Opacity of a label. */
const opacity = '22%';

/**
 * The number of labels that get a colour stop of their own here. A volume that has more labels, or ids that float32
 * rounds, gets its colours from the ids when it is drawn.
 */
const maxColored = 255;

/**
 * A typical ray through a mask is as long as this, in reference lengths. With this depth a reader can see how thick the
 * mask is, whether it is a skull or a whole head.
 */
const depth = 1;

/** Maximum opacity of a mask. */
const maxOpacity = 0.18;

/**
 * The appearance of whole numbers that stand for things: each label has its colour, and 0 has none. Two values are a
 * mask.
 */
export function labelAppearance(decoded: DecodedCartesianVolume): SuggestedAppearance {
  const { samples, slope, intercept, indexed, named } = decoded;
  const labels = indexed ? [...indexed.ids] : valuesOf(samples, slope, intercept);
  labels.sort((a, b) => a - b);
  const [lowest, highest] = [labels[0], labels[labels.length - 1]];
  if (named) return { window: [lowest, Math.max(highest, lowest + 1)], isDiscrete: true };
  if (labels.length < 3)
    return { window: [lowest, Math.max(highest, lowest + 1)], transferFunction: maskAppearance(decoded) };
  const things = labels.filter((label) => label !== 0);
  if (indexed || lowest < 0 || things.length > maxColored || !Number.isSafeInteger(highest))
    return { window: [lowest, highest], isDiscrete: true };
  const stops = things.map((label, i) => {
    const color = colors[i % colors.length];
    const from = i === 0 ? `${label - 0.5} ${color} 0, ` : '';
    return `${from}${label - 0.5} ${color} ${opacity}, ${(things[i + 1] ?? highest + 1) - 0.5} ${color} ${opacity}`;
  });
  return { window: [lowest, highest], transferFunction: stops.join(', '), isDiscrete: true };
}

function valuesOf(samples: Samples, slope: number, intercept: number): number[] {
  const stored = new Set<number>();
  let last = NaN;
  for (const value of samples) {
    if (value !== last) stored.add(value);
    last = value;
    if (stored.size > maxLabels) break;
  }
  return Array.from(stored, (value) => Math.round(slope * value + intercept)).filter((label) => Number.isFinite(label));
}

/**
 * A skin that gets lighter inwards, with a density that suits its thickness. A mask has no values between its two: the
 * edge is half way.
 */
function maskAppearance({ samples, grid: { dimensions, spacing } }: DecodedCartesianVolume): string {
  let inside = 0;
  for (const value of samples) if (value > inside) inside = value;
  let [voxels, runs] = [0, 0];
  for (let i = 0, before = 0; i < samples.length; before = samples[i++]) {
    if (samples[i] !== inside) continue;
    voxels++;
    if (before !== inside) runs++;
  }
  const reference = Math.max(...dimensions.map((n, axis) => n * spacing[axis])) / 100;
  const usual = ((voxels / Math.max(1, runs)) * spacing[0]) / reference;
  const percent = (share: number): string =>
    `${(100 * share * Math.min(maxOpacity, 1 - Math.exp(-depth / usual))).toFixed(2)}%`;
  return `40% #3d2418 0, 52% #6b4430 ${percent(0.5)}, 78% #c89b74 ${percent(0.8)}, 100% #fdebd3 ${percent(1)}`;
}
