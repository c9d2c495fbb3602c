import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import type { PaneLabels } from '../../panes/pane-labels.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';

/** A second field over the volume of an element, with what its picture, its picks and its panes need: they load no code for it. */
export interface ViewOverlay {
  readonly shown: ShownOverlay;
  /** Its name; '' for none. */
  readonly name: string;
  /** Whether it belongs to this volume: another volume may have come meanwhile. */
  isOver(volume: Volume): boolean;
  /** Its data value at a place of the volume's unit cube; null where it has none. */
  valueAt(place: Vector3): number | null;
  /** What is shown over the grey values of a pane of the volume; null where there are none. */
  inPane(volume: Volume | null): PaneLabels | null;
}
