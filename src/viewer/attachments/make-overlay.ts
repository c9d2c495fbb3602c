import { cartesianOverlay, isOver } from '../../optics/attachments/overlay.ts';
import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import type { FieldStage } from '../../optics/rays/ray-stages.ts';
import { paneOverlay } from '../../panes/pane-overlay.ts';
import { isPolar } from '../../volume/volume.ts';
import type { ViewOverlay } from '../model/view-overlay.ts';

/** @param field - of the layer, by places in the volume's unit cube */
export function makeOverlay(
  shown: ShownOverlay,
  name: string,
  field: FieldStage = cartesianOverlay(shown),
): ViewOverlay {
  const inPane = isPolar(shown.volume) ? null : paneOverlay(shown);
  return {
    shown,
    name,
    isOver: (volume) => isOver(shown, volume),
    valueAt: (place) => {
      const { value, valid } = field.sampleAt(place);
      return valid ? value : null;
    },
    inPane: (volume) => (volume && isOver(shown, volume) ? inPane : null),
  };
}
