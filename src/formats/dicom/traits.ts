// What may differ between pictures of one place, such as the time when each was measured.
import type { DataSet } from './data-set.ts';
import { secondsOf } from './date-time.ts';
import type { Picture } from './picture.ts';
import { sequences, tags } from './tags.ts';
import type { Tag } from './tags.ts';

/** Finds where an element of a frame is, perhaps in an item of a sequence. */
export type Find = (group: Tag | null, tag: Tag) => DataSet;

export type Traits = ReadonlyMap<string, string | number>;

/** Nuclear medicine says of each frame of a file what it is, by lists of numbers. Source: PS3.3, C.8.4.8 */
export interface FrameVectors {
  /** Which slice each frame is, from 1; none where the file does not say it. */
  readonly slices: readonly number[];
  readonly others: readonly (readonly [name: string, numbers: readonly number[]])[];
  /** How long after a heartbeat each frame began, in seconds; none where the file does not say it. */
  readonly gates: readonly (number | undefined)[];
}

export function readVectors(picture: Pick<Picture, 'set' | 'frames'>): FrameVectors {
  const read = (tag: Tag): number[] => (picture.frames > 1 ? readFrameVector(picture, tag) : []);
  return {
    slices: read(tags.sliceVector),
    others: vectorTags.map(([name, tag]) => [name, read(tag)] as const).filter(([, numbers]) => numbers.length > 0),
    gates: picture.frames > 1 ? readGates(picture) : [],
  };
}

/** By the length of the parts of a heartbeat, which may differ between intervals. Source: PS3.3, C.8.4.13 */
export function readGates(picture: Pick<Picture, 'set' | 'frames'>): (number | undefined)[] {
  const intervals = readFrameVector(picture, tags.intervalVector);
  const gates = picture.set
    .items(sequences.gated)
    .map((item) => item.items(sequences.gatedData)[0]?.number(tags.frameTime));
  return readFrameVector(picture, tags.timeSlotVector).map((slot, i) => {
    const gate = gates[(intervals[i] ?? 1) - 1];
    return gate && ((slot - 1) * gate) / 1e3;
  });
}

/** A number for each frame; none where the file does not say them. */
export function readFrameVector({ set, frames }: Pick<Picture, 'set' | 'frames'>, tag: Tag): number[] {
  const numbers = set.numbers(tag, frames);
  return numbers.length === frames ? numbers : [];
}

/** @param index - of the frame, from 0 */
export function readTraits({ set, frames }: Picture, index: number, find: Find, vectors: FrameVectors): Traits {
  const traits = new Map<string, string | number>();
  const add = (name: string, value: number | undefined): void => {
    if (value !== undefined) traits.set(name, value);
  };
  const frameType = [sequences.mrFrameType, sequences.ctFrameType, sequences.petFrameType]
    .map((group) => find(group, tags.frameType).texts(tags.frameType))
    .find(([first]) => first !== '');
  traits.set('kind of picture', (frameType ?? set.texts(tags.imageType)).slice(2).join(' '));
  const complexPart = find(sequences.mrFrameType, tags.complexPart).text(tags.complexPart);
  if (complexPart !== '') traits.set('part of complex numbers', complexPart);
  const dataType = find(sequences.dataType, tags.dataType).text(tags.dataType);
  // Tissue comes before what flows in it.
  if (dataType !== '') traits.set('kind of data', dataType === 'TISSUE_INTENSITY' ? '' : dataType);
  for (const [name, numbers] of vectors.others) add(name, numbers[index]);
  add(afterStart, vectors.gates[index]);
  for (const [name, group, ...candidates] of traitTags) {
    add(
      name,
      candidates.map((tag) => find(group, tag).number(tag)).find((one) => one !== undefined),
    );
  }
  add('time of the acquisition', secondsOf(set.text(tags.acquisitionDate), set.text(tags.acquisitionTime)));
  const dateTime = (tag: Tag): number | undefined => {
    const text = find(sequences.frameContent, tag).text(tag);
    return secondsOf(text.slice(0, 8), text.slice(8));
  };
  add('date and time of the acquisition', dateTime(tags.frameDateTime) ?? dateTime(tags.acquisitionDateTime));
  const milliseconds = set.number(tags.frameReferenceTime);
  add('reference time', dateTime(tags.referenceDateTime) ?? (milliseconds && milliseconds / 1e3));
  const instance = set.number(tags.instance);
  if (frames > 1 || instance !== undefined) traits.set(lastTrait, (instance ?? 0) * 2 ** 16 + index);
  add('time of the content', secondsOf(set.text(tags.contentDate), set.text(tags.contentTime)));
  return traits;
}

/** In what pictures differ that say nothing else: the order in which the scanner counts them. */
export const lastTrait = 'number of the picture';

const afterStart = 'time from the start';

/** Those that are no time come first. */
const vectorTags: readonly (readonly [name: string, tag: Tag])[] = [
  ['window of energy', tags.energyWindowVector],
  ['detector', tags.detectorVector],
  ['interval between heartbeats', tags.intervalVector],
  ['part of a heartbeat', tags.timeSlotVector],
  ['phase', tags.phaseVector],
  ['part of the scan', tags.timeSliceVector],
];

/** Those that are no time come first, then those that say more of it. */
const traitTags: readonly (readonly [name: string, group: Tag | null, ...tags: Tag[]])[] = [
  ['echo time', sequences.echo, tags.effectiveEchoTime, tags.echoTime],
  ['echo number', null, tags.echoNumber],
  ['b value of diffusion', sequences.diffusion, tags.bValue, tags.siemensBValue],
  ['inversion time', null, tags.inversionTime],
  ['position in time', sequences.frameContent, tags.temporalIndex, tags.temporalPosition],
  [afterStart, sequences.temporalPosition, tags.timeOffset],
  ['trigger time', sequences.heart, tags.triggerDelay, tags.triggerTime],
  ['share of a heartbeat', sequences.heart, tags.heartPhase],
  ['share of a breath', sequences.breath, tags.breathPhase],
  ['number of the acquisition', sequences.frameContent, tags.frameAcquisition, tags.acquisition],
];
