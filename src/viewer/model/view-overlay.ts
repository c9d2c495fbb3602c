import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import type { PaneLabels } from '../../panes/pane-labels.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';

/** A second field over the volume of an element, as its picture, its picks and its panes need it: they load nothing for it. */
export interface ViewOverlay {
  readonly shown: ShownOverlay;
  /** What it is called; '' for nothing. */
  readonly name: string;
  /** Whether it is over a volume: another one may have come meanwhile. */
  isOver(volume: Volume): boolean;
  /** Its data value at a place of the volume's unit cube; null where it has none. */
  valueAt(place: Vector3): number | null;
  /** Over the greys of a pane of the volume; null where there are none. */
  inPane(volume: Volume | null): PaneLabels | null;
}
