import { voteOfCorners } from '../../optics/rays/vote.ts';
import { nameInFile } from '../../volume/labels.ts';
import type { ShownLabels } from '../../volume/labels.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { nearestVoxel } from './pick-voxel.ts';
import type { ViewLabels } from '../model/view-labels.ts';
import type { ViewOverlay } from '../model/view-overlay.ts';
import type { LayerValue, VolumePick } from '../model/volume-pick.ts';

/**
 * The label at a place, and its name; nothing where there is no label.
 * @param place - in the unit cube
 */
export function labelOf(
  labels: ViewLabels | null,
  place: Vector3,
  { label }: VolumePick,
  volume: Volume,
): Pick<VolumePick, 'label' | 'labelName'> {
  const id =
    labels?.shown && isOn(labels.shown, volume)
      ? idAt(labels.shown, place)
      : label === undefined
        ? null
        : Number(label);
  const labelName = id === null ? null : (labels?.nameOf(id) ?? nameInFile(volume, id));
  return { ...(id === null ? {} : { label: String(id) }), ...(labelName === null ? {} : { labelName }) };
}

/**
 * The values of a volume's channels at a place, and of the layer over it; nothing where it has neither. A channel has the grid of its volume, so
 * its value is that of a voxel, as in a slice.
 * @param place - in the unit cube
 */
export function layersAt(overlay: ViewOverlay | null, place: Vector3, volume: Volume): Pick<VolumePick, 'layers'> {
  const { grid } = volume;
  const channels = volume.channels?.list.map(({ number, name, samples, slope, intercept }): LayerValue => {
    const voxel = nearestVoxel({ grid, samples, slope, intercept }, place);
    return { name, value: voxel?.value ?? null, unit: '', channel: number };
  });
  const layers = [...(channels ?? []), ...valueOf(overlay, place, volume)];
  return layers.length > 0 ? { layers } : {};
}

function valueOf(overlay: ViewOverlay | null, place: Vector3, volume: Volume): LayerValue[] {
  if (!overlay?.isOver(volume)) return [];
  const {
    name,
    shown: {
      volume: { unit },
    },
  } = overlay;
  return [{ name, value: overlay.valueAt(place), unit }];
}

/** Whether labels are on a volume's grid: another volume may have come meanwhile. */
export function isOn({ map }: ShownLabels, { grid }: Volume): boolean {
  return grid.kind === 'cartesian' && String(map.dimensions) === String(grid.dimensions);
}

/** null for a place without a label. */
function idAt({ map: { numbers, dimensions, ids } }: ShownLabels, place: Vector3): number | null {
  const number = voteOfCorners(numbers, dimensions, place);
  return number === 0 ? null : ids[number];
}
