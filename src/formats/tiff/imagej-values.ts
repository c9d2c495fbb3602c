// What ImageJ says of the values of its numbers. Source: ImageJ 1.54, ij/io/FileOpener, setCalibration, and ij/measure/Calibration
import type { ValueScale } from './layout.ts';
import { tags } from './tiff-file.ts';
import type { Directory, TiffFile } from './tiff-file.ts';

/** Functions of ImageJ. */
const [straightLine, none] = [0, 20];

/** What ImageJ calls the unit of values that have none. */
const noUnit = 'Gray Value';

/** In memory, ImageJ adds this to signed numbers of 16 bits. */
const signedShift = 2 ** 15;

/** Longer ones are no units. */
const maxUnit = 32;

/** ImageJ scales gray numbers of 8 and 16 bits, and no others. */
export function scaleImageJ(
  file: TiffFile,
  first: Directory,
  values: ReadonlyMap<string, string>,
): { readonly scale?: ValueScale & { readonly shift: number }; readonly left: string | null } {
  const number = (name: string): number => Number(values.get(name) || NaN);
  const [kind, intercept, slope] = [number('cf'), number('c0'), number('c1')];
  const [bits, samples, format] = [tags.bits, tags.samples, tags.format].map((tag) => file.number(first, tag) ?? 1);
  if (Number.isNaN(kind) || kind === none || bits > 16 || samples > 1 || format === 3) return { left: null };
  if (kind !== straightLine || !Number.isFinite(intercept) || !Number.isFinite(slope) || slope === 0)
    return {
      left: `the calibration of the values (cf=${kind} of ImageJ), which is no straight line: they are shown as they are stored`,
    };
  const shift = format === 2 && bits === 16 ? signedShift : 0;
  const unit = values.get('vunit') ?? '';
  return {
    scale: { slope, intercept: intercept + slope * shift, shift, unit: unit === noUnit ? '' : unit.slice(0, maxUnit) },
    left: null,
  };
}
