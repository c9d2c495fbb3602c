import type { Patch } from './patches.ts';
import { writeColor } from './write-transfer-function.ts';

/**
 * Writes patches as the text of an attribute that parsePatches reads: numbers to six digits, or more if a patch is narrow, colours to
 * 1/255, opacities to four digits.
 */
export function writePatches(patches: readonly Patch[]): string {
  return patches
    .map((patch) =>
      [
        patch.kind,
        ...roundedNumbersOf(patch),
        writeColor(patch.color),
        `${Number((patch.opacity * 100).toPrecision(4))}%`,
      ].join(' '),
    )
    .join(', ');
}

/** The numbers that place a patch, in the order of the attribute. */
export function numbersOf(patch: Patch): readonly [number, number, number, number] {
  return patch.kind === 'box' ? [...patch.values, ...patch.gradients] : [patch.value, patch.gradient, ...patch.widths];
}

/** The same, rounded to the digits that are written: to a hundred-thousandth of the patch's width or finer. */
export function roundedNumbersOf(patch: Patch): readonly number[] {
  const [a, b, c, d] = numbersOf(patch);
  const widths = patch.kind === 'box' ? [b - a, b - a, d - c, d - c] : [c, d, c, d];
  return [a, b, c, d].map((x, i) =>
    Number(x.toPrecision(Math.min(17, Math.max(6, 5 + Math.ceil(Math.log10(Math.abs(x) / widths[i])))))),
  );
}
