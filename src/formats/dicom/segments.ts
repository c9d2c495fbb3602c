// What a segmentation says of its segments.
import { labToRgb } from './cielab.ts';
import type { NamedLabel } from '../../volume/labels.ts';
import { corruptFile } from '../base/file-problem.ts';
import { nameReader } from './character-set.ts';
import { readPaletteColors } from './colors.ts';
import type { DataSet } from './data-set.ts';
import { sequences, tags } from './tags.ts';

/**
 * Names and colours of the segments, by their numbers. Source: PS3.3, C.8.20.2 and C.8.20.4
 * @param what - for messages
 * @throws {VolumeViewError} `format/corrupt`
 */
export function readSegments(set: DataSet, what: string): NamedLabel[] {
  const nameOf = nameReader(set);
  const named = new Map<number, NamedLabel>();
  const palette = set.text(tags.photometric).toUpperCase() === 'PALETTE COLOR' ? readPaletteColors(set) : null;
  for (const item of set.items(sequences.segments)) {
    const id = item.number(tags.segmentNumber);
    if (id === undefined)
      throw corruptFile(what, 'describes a segment without a number; expected one from 1 to 65,535');
    // Label maps may describe what is around all segments, as number 0.
    if (id === 0 || named.has(id)) continue;
    const lab = item.numbers(tags.segmentColor);
    named.set(id, {
      id,
      name: nameOf(item, tags.segmentLabel),
      color: lab.length === 3 ? labToRgb(lab) : (palette?.(id) ?? null),
    });
  }
  return [...named.values()];
}
