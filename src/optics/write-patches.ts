import type { Patch } from './patches.ts';
import { writeColor } from './write-transfer-function.ts';

/** The text of an attribute that parsePatches reads as these: numbers to six digits, colours to 1/255, opacities to four digits. */
export function writePatches(patches: readonly Patch[]): string {
  return patches.map((patch) => [patch.kind, ...numbersOf(patch).map((x) => Number(x.toPrecision(6))), writeColor(patch.color), `${Number((patch.opacity * 100).toPrecision(4))}%`].join(' ')).join(', ');
}

/** What says where a patch is, in the order of the attribute. */
export function numbersOf(patch: Patch): readonly [number, number, number, number] {
  return patch.kind === 'box' ? [...patch.values, ...patch.gradients] : [patch.value, patch.gradient, ...patch.widths];
}
