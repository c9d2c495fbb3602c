import type { NamedLabel } from '../../volume/labels.ts';
import { cleanName } from '../base/clean-name.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { listLeft } from '../base/list-left.ts';
import type { OmeImage } from './open-image.ts';
import { describeChannel, describeHidden } from './ome-channels.ts';
import type { ShownChannels } from './ome-channels.ts';
import { listOf, numbersOf, objectOf } from './read-json.ts';

/** What all levels of an image have in common. */
export function describeImage(
  image: OmeImage,
  {
    shown,
    time,
    times,
    volumes,
  }: { readonly shown: ShownChannels; readonly time: number; readonly times: number; readonly volumes: number },
): Pick<DecodedCartesianVolume, 'unit' | 'format' | 'window' | 'isLabels' | 'named' | 'left' | 'anatomical'> {
  const { axes, levels, omero, labels } = image;
  const window = shown.kind === 'values' && !labels ? describeChannel(omero, shown.index).window : null;
  const channels = axes.channel === null ? 1 : levels[0].array.shape[axes.channel];
  return {
    unit: '',
    format: `${image.format}${times > 1 ? `, volume ${time + 1} of ${times}` : ''}`,
    ...(axes.anatomical && { anatomical: true }),
    ...(window && { window }),
    ...(labels && { isLabels: true, named: readLabels(labels) }),
    ...listLeft(volumes, describeHidden(shown, channels), ...image.left),
  };
}

/** Colours of labels, 0 to 255, and names. Source: OME-Zarr 0.5, "image-label" metadata */
function readLabels(labels: ReturnType<typeof objectOf>): readonly NamedLabel[] {
  const named = new Map<number, NamedLabel>();
  for (const one of listOf(labels.colors)) {
    const { 'label-value': id, rgba } = objectOf(one);
    const color = numbersOf(rgba);
    if (typeof id !== 'number' || !Number.isSafeInteger(id) || !color || color.length < 3) continue;
    const [red, green, blue] = color.map((part) => Math.min(1, Math.max(0, part / 255)));
    named.set(id, { id, name: '', color: [red, green, blue] });
  }
  for (const one of listOf(labels.properties)) {
    const { 'label-value': id, name, class: kind } = objectOf(one);
    const text = typeof name === 'string' ? name : kind;
    if (typeof id !== 'number' || !Number.isSafeInteger(id) || typeof text !== 'string') continue;
    named.set(id, { id, name: cleanName(text), color: named.get(id)?.color ?? null });
  }
  return [...named.values()];
}
