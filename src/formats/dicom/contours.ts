// What a structure set (RTSTRUCT) says: regions of interest (ROI), each with a name, a colour and contours. Source: PS3.3, C.8.8.5 and C.8.8.6
import type { NamedLabel } from '../../volume/labels.ts';
import type { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { nameReader } from './character-set.ts';
import type { DataSet } from './data-set.ts';
import { count } from './group-frames.ts';
import { sequences, tags } from './tags.ts';

/** A closed line around a region. */
export interface Contour {
  /** Of the label that it is around. */
  readonly id: number;
  /** Places in DICOM's world (LPS), mm: x, y and z in turns, of three points at least. */
  readonly points: Float64Array;
  /** Of the plane that it stands for, mm, where the file says it. */
  readonly thickness: number | null;
}

export interface Contours {
  readonly contours: readonly Contour[];
  readonly named: readonly NamedLabel[];
  /** What of the file is not among the contours, or not as it is there, in words. */
  readonly left: readonly string[];
}

/** More than any plan has. */
const [maxRois, maxContours, maxPoints] = [2 ** 12, 2 ** 17, 2 ** 22];

/** Numbers that a label may have. */
const maxId = 2 ** 16 - 1;

/** No scanner reaches so far, mm. */
const farthest = 1e5;

/** Memory for a point while it is read: text, number, and place. */
const bytesPerPoint = 200;

/** @param what - for messages @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large` */
export function listContours(set: DataSet, budget: Budget, what: string): Contours {
  const rois = set.items(sequences.rois);
  if (rois.length > maxRois)
    throw unsupportedFile(
      what,
      `has ${rois.length.toLocaleString('en')} regions; expected at most ${maxRois.toLocaleString('en')}`,
    );
  const numbers = rois.map((roi) => roi.number(tags.roiNumber));
  const isNumbered =
    numbers.every((id) => id !== undefined && Number.isInteger(id) && id >= 1 && id <= maxId) &&
    new Set(numbers).size === numbers.length;
  const idOf = new Map(numbers.map((number, i) => [number, isNumbered ? number! : i + 1]));
  const colors = new Map<number, NamedLabel['color']>();
  const contours: Contour[] = [];
  let [open, strange, points] = [0, 0, 0];
  for (const group of set.items(sequences.roiContours)) {
    const id = idOf.get(group.number(tags.referencedRoi));
    const items = group.items(sequences.contours);
    if (id === undefined) {
      strange += items.length;
      continue;
    }
    colors.set(id, readColor(group));
    if (contours.length + items.length > maxContours)
      throw unsupportedFile(what, `has more than ${maxContours.toLocaleString('en')} contours; expected fewer`);
    for (const [i, item] of items.entries()) {
      const name = `contour ${i + 1} of region ${id}`;
      if (!/^CLOSED_?PLANAR(_XOR)?$/.test(item.text(tags.contourType).toUpperCase() || 'CLOSED_PLANAR')) {
        open++;
        continue;
      }
      const found = readPoints(item, budget, { what, name });
      points += found.length / 3;
      if (points > maxPoints)
        throw unsupportedFile(
          what,
          `has contours of more than ${maxPoints.toLocaleString('en')} points; expected fewer`,
        );
      if (found.length < 9) open++;
      else contours.push({ id, points: found, thickness: item.number(tags.slabThickness) ?? null });
    }
  }
  const nameOf = nameReader(set);
  return {
    contours,
    named: rois.map((roi, i) => {
      const id = idOf.get(numbers[i])!;
      return { id, name: nameOf(roi, tags.roiName), color: colors.get(id) ?? null };
    }),
    left: [
      ...(isNumbered || rois.length === 0
        ? []
        : [
            'the numbers of the regions, which are not different ones from 1 to 65,535: they have those of their order',
          ]),
      ...(open > 0 ? [`${count(open, 'contour')} of points or open lines, around nothing`] : []),
      ...(strange > 0 ? [`${count(strange, 'contour')} of regions that the file does not describe`] : []),
    ],
  };
}

function readColor(group: DataSet): NamedLabel['color'] {
  const channels = group.numbers(tags.roiColor);
  const isColor = channels.length === 3 && channels.every((one) => one >= 0 && one <= 255);
  return isColor ? [channels[0] / 255, channels[1] / 255, channels[2] / 255] : null;
}

function readPoints(item: DataSet, budget: Budget, { what, name }: { what: string; name: string }): Float64Array {
  // Two bytes for a number: a digit, and what divides it from the next one.
  const atMost = Math.ceil(item.bytesOf(tags.contourData).length / 2);
  budget.take((atMost / 3) * bytesPerPoint, what);
  const numbers = item.numbers(tags.contourData, atMost);
  budget.giveBack((atMost / 3) * bytesPerPoint - 8 * numbers.length);
  if (numbers.length % 3 !== 0)
    throw corruptFile(
      what,
      `has ${numbers.length.toLocaleString('en')} numbers in ${name}; expected three for each point`,
    );
  if (!numbers.every((one) => Math.abs(one) <= farthest))
    throw corruptFile(
      what,
      `has a place in ${name} that is no number, or farther away than ${farthest.toLocaleString('en')} mm`,
    );
  return Float64Array.from(numbers);
}
