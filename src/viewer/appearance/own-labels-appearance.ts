import { labelOpacity, labelStops } from '../../optics/transfer/label-stops.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { ghost } from '../model/view-labels.ts';
import type { LabelEntry } from '../model/view-labels.ts';

/**
 * The transfer function of a volume that is itself labels: a colour for each value, and nothing for places without a label. Null
 * where there is no label.
 */
export function ownLabelsAppearance(entries: readonly LabelEntry[]): TransferFunction | null {
  const rising = entries.slice(1);
  if (rising.length === 0) return null;
  rising.sort((a, b) => a.id - b.id);
  return labelStops(
    rising.map(({ id, color, opacity, hidden, isGhost }) =>
      isGhost
        ? { id, color: ghost.color, opacity: (labelOpacity * ghost.opacityFactor) / 2 }
        : { id, color, opacity: hidden ? 0 : opacity * labelOpacity },
    ),
  );
}
