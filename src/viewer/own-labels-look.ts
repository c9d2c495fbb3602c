import { writeColor } from '../optics/write-transfer-function.ts';
import type { LabelEntry } from './view-labels.ts';

/** Opacity of a label in a volume that is labels itself. */
const opaque = 0.22;

/** Labels that get stops of their own; of more, some that follow one another look alike. */
const mostStyled = 1024;

/** The transfer function of a volume that is labels itself: each value its colour, and none of what has no label. */
export function ownLabelsLook(entries: readonly LabelEntry[]): string {
  const rising = entries.slice(1);
  rising.sort((a, b) => a.id - b.id);
  const alike = Math.ceil(rising.length / mostStyled);
  const firsts = rising.filter((_, i) => i % alike === 0);
  const highest = rising.at(-1)?.id ?? 1;
  const stops = firsts.map(({ id, color, opacity, hidden }, i) => {
    const look = `${writeColor(color)} ${(100 * (hidden ? 0 : opacity * opaque)).toFixed(2)}%`;
    const from = i === 0 ? `${id - 0.5} ${writeColor(color)} 0, ` : '';
    // Where there is no label between two, nothing has that value.
    return `${from}${id - 0.5} ${look}, ${(firsts[i + 1]?.id ?? highest + 1) - 0.5} ${look}`;
  });
  return stops.join(', ');
}
