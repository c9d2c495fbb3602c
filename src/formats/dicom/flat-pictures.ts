// Pictures that are no slices of a volume: those of a film, views of a camera, and X-ray pictures. Each stands alone.
// Source: DICOM PS3.3, C.7.6.5 (times of a film), C.7.6.6.1.1 and C.8.4.8.1 (what frames are, by Frame Increment Pointer)
import type { DataSet } from './data-set.ts';
import type { Picture } from './picture.ts';
import { sequences, tags } from './tags.ts';
import type { Tag } from './tags.ts';
import { readFrameVector, readGates } from './traits.ts';

/** What a picture is that is no slice. */
export interface FlatPicture {
  /** Pictures of one group differ in time or in angle; others are films or views of their own. */
  readonly group: string;
  /** When it was measured, in seconds from the first one of its file; undefined where the file does not say it. */
  readonly seconds: number | undefined;
  /** Whether the camera was turned from picture to picture: where it stood is not known. */
  readonly isTurned: boolean;
}

/** Source: PS3.6, annex A */
const root = '1.2.840.10008.5.1.4.1.1.';
const nuclear = new Set(['5', '20'].map((end) => root + end));

/** X-ray pictures and films, ultrasound, photographs, portal images. What has places for its frames is none of these. */
const flatClasses =
  /^1\.2\.840\.10008\.5\.1\.4\.1\.1\.(1(\.[123](\.1)?)?|3(\.1)?|6(\.1)?|12\.[123](\.1)?|13\.1\.[45]|77\.1\.([147](\.1)?|5\.[1256])|481\.1)$/;

/** Reads what the pictures of a file are; null where they are slices, or nothing says what they are. */
export function findFlat(picture: Picture): ((index: number) => FlatPicture) | null {
  const { set, frames } = picture;
  const says = (tag: Tag): boolean => set.number(tag) !== undefined;
  const isPlaced = says(tags.position) && says(tags.orientation);
  if (frames === 1 && (isPlaced || says(tags.sliceLocation))) return null;
  const pointers = set.numbers(tags.frameIncrement);
  const kind = (set.texts(tags.imageType)[2] ?? '').toUpperCase().replaceAll('_', ' ');
  const isNuclear = nuclear.has(set.text(tags.sopClass)) || set.text(tags.modality) === 'NM';
  if (isNuclear) return isFlatOfNuclear(picture, kind, pointers) ? readNuclear(picture, kind) : null;
  if (pointers.some((id) => sliceTags.has(id))) return null;
  const isFilm = frames > 1 && pointers.some((id) => filmTags.has(id));
  const isFlatClass = flatClasses.test(set.text(tags.sopClass));
  if (!isFilm && (isPlaced || !isFlatClass || hasStep(set))) return null;
  if (isPlaced && !isFlatClass && isStack(set)) return null;
  const seconds = readTimes(set, frames);
  const group = frames > 1 ? set.text(tags.sopInstance) : 'stills';
  return (index) => ({ group, seconds: seconds?.(index), isTurned: false });
}

/** Whether the file says how far it is to the next slice, or how thick one is: so do slices of a breast in files of X-ray pictures. */
const hasStep = (set: DataSet): boolean =>
  [tags.spacingBetweenSlices, tags.sliceThickness].some((tag) => (set.number(tag) ?? 0) !== 0);

/** Programs that write a stack as a film. In MR, films of one slice have that spacing, too. */
const isStack = (set: DataSet): boolean =>
  (set.number(tags.spacingBetweenSlices) ?? 0) !== 0 && set.text(tags.modality) !== 'MR';

const idsOf = (some: readonly Tag[]): ReadonlySet<number> => new Set(some.map(({ id }) => id));

/** Times, angles of a tube, and pages of a document. */
const filmTags = idsOf([
  tags.frameTime,
  tags.frameTimeVector,
  tags.pageVector,
  tags.firstAngleVector,
  tags.secondAngleVector,
]);

/** What says that frames lie next to each other, also in a file of a kind that has films. */
const sliceTags = idsOf([tags.sliceLocationVector, tags.sliceLocation, tags.spacingBetweenSlices, tags.sliceThickness]);

const viewTags = idsOf([
  tags.energyWindowVector,
  tags.detectorVector,
  tags.phaseVector,
  tags.rotationVector,
  tags.intervalVector,
  tags.timeSlotVector,
  tags.angularViewVector,
  tags.timeSliceVector,
]);

/** Only what is reconstructed has slices. Source: PS3.3, C.8.4.8.1.1 */
function isFlatOfNuclear(picture: Picture, kind: string, pointers: readonly number[]): boolean {
  if (kind.startsWith('RECON') || pointers.some((id) => id === tags.sliceVector.id || sliceTags.has(id))) return false;
  if (picture.frames > 1 && readFrameVector(picture, tags.sliceVector).length > 0) return false;
  if (/^(STATIC|DYNAMIC|GATED|WHOLE BODY|TOMO|GATED TOMO)$/.test(kind)) return true;
  return !hasStep(picture.set) && pointers.some((id) => viewTags.has(id));
}

function readNuclear(picture: Picture, kind: string): (index: number) => FlatPicture {
  const { set, frames } = picture;
  const isTurned = kind.endsWith('TOMO') || readFrameVector(picture, tags.angularViewVector).length > 0;
  const [energies, detectors, rotations, intervals, phases, parts] = [
    tags.energyWindowVector,
    tags.detectorVector,
    tags.rotationVector,
    tags.intervalVector,
    tags.phaseVector,
    tags.timeSliceVector,
  ].map((tag) => readFrameVector(picture, tag));
  const film = frames > 1 ? set.text(tags.sopInstance) : '';
  const starts = startsOfPhases(set);
  const gates = readGates(picture);
  const secondsOf = (index: number): number | undefined => {
    if (isTurned) return undefined;
    if (parts.length > 0) return starts[(phases[index] ?? 1) - 1]?.(parts[index]);
    return gates[index];
  };
  return (index) => ({
    group: [film, ...[energies, detectors, rotations, intervals].map((vector) => vector[index] ?? 1)].join(),
    seconds: secondsOf(index),
    isTurned,
  });
}

/** Of each phase of a dynamic study when its pictures began, in seconds, by their numbers from 1. Source: PS3.3, C.8.4.14 */
function startsOfPhases(set: DataSet): ((part: number) => number)[] {
  let end = 0;
  return set.items(sequences.phases).map((phase) => {
    const start = end + (phase.number(tags.phaseDelay) ?? 0);
    const pause = phase.number(tags.framePause) ?? 0;
    const step = (phase.number(tags.frameDuration) ?? NaN) + pause;
    end = start + step * (phase.number(tags.framesInPhase) ?? NaN) - pause;
    return (part) => (start + (part - 1) * step) / 1e3;
  });
}

/** Source: PS3.3, C.7.6.5.1.1 and C.7.6.5.1.2 */
function readTimes(set: DataSet, frames: number): ((index: number) => number) | null {
  const steps = frames > 1 ? set.numbers(tags.frameTimeVector, frames) : [];
  if (steps.length === frames) {
    let time = 0;
    const times = steps.map((step, i) => (time += i > 0 ? step : 0));
    return (index) => times[index] / 1e3;
  }
  const step = set.number(tags.frameTime);
  return step !== undefined && step > 0 ? (index) => (index * step) / 1e3 : null;
}
