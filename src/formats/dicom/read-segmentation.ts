// Segmentations: frames of labels. Loaded with the first of them. Source: PS3.3, C.8.20
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import type { ReadContext } from '../base/format.ts';
import { checkFrames, decodeFrame } from './decode-frame.ts';
import { loadLibraries } from './load-libraries.ts';
import type { Frame } from './frame.ts';
import { labelVolume, startLabels } from './label-volume.ts';
import { listFrames } from './list-frames.ts';
import { readLabelPicture } from './picture.ts';
import type { Picture } from './picture.ts';
import { placeSegments } from './place-segments.ts';
import type { DicomFile } from './read-file.ts';
import { readSegments } from './segments.ts';
import { sequences, tags } from './tags.ts';

/** The label of a stored number, 0 for none. */
type LabelOf = (stored: number) => number;

const what = 'the DICOM segmentation';

/** Memory for what is known of one frame: a small file may have thousands. */
const describingBytes = 1500;

/**
 * Reads a segmentation as labels, on its own grid: the number of each voxel is that of its segment. Slices that the file
 * leaves out hold none. Nothing of the file becomes text but the names of its segments, which are those of labels.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export async function readSegmentation(
  file: DicomFile,
  { budget, onProgress }: ReadContext,
): Promise<DecodedCartesianVolume> {
  const picture = readLabelPicture(file, what);
  checkFrames(picture);
  const isBits = picture.bitsAllocated === 1;
  if (isBits && !picture.pixels.bytes)
    throw unsupportedFile(
      what,
      'has bits that are packed, which is not read; unpack it: gdcmconv --raw in.dcm out.dcm',
    );
  if (picture.bitsAllocated > 16)
    throw unsupportedFile(
      what,
      `has ${picture.bitsAllocated} bits for a voxel; expected 1, 8 or 16. Convert it: segimage2itkimage (dcmqi)`,
    );
  budget.take(describingBytes * picture.frames, what);
  const { set } = file;
  const segments = readSegments(set, what);
  const frames = listFrames(picture);
  const placed = placeSegments(frames, what);
  const fractions = isBits ? null : readFractions(set);
  const isLabelMap = set.text(tags.segmentationType).toUpperCase() === 'LABELMAP';
  // Segments in the order of their numbers: where they overlap, the last one is seen.
  const ordered = frames.map((frame) => ({ frame, id: isLabelMap ? 0 : segmentOf(frame) }));
  ordered.sort((a, b) => a.id - b.id);
  const largest = Math.max(
    ...(isLabelMap ? [2 ** picture.bitsStored - 1] : ordered.map(({ id }) => id)),
    ...segments.map(({ id }) => id),
  );
  const painter = startLabels(placed.dimensions, largest, budget, what);
  const libraries = await loadLibraries([picture]);
  const pixels = picture.columns * picture.rows;
  for (const [i, { frame, id }] of ordered.entries()) {
    onProgress(i, ordered.length);
    const labelOf = chooseLabels(picture, id, fractions);
    const slices = placed.slicesOf(frame);
    budget.step(pixels / 8, what);
    const numbers = isBits ? cutBits(picture, frame.index) : decodeFrame(picture, frame.index, budget, { libraries });
    for (let p = 0; p < pixels; p++) {
      const label = labelOf(numbers[p]);
      if (label > 0) for (const k of slices) painter.paint(k * pixels + p, label);
    }
  }
  const left = [
    ...(fractions && fractions.max > 1 && !isLabelMap
      ? [
          `fractions of segments: a voxel has the label where at least half of it is of the segment (${fractions.half} of ${fractions.max})`,
        ]
      : []),
    ...placed.left,
    ...painter.describeHidden((id) => `segment ${id}`),
  ];
  return labelVolume(placed, painter, { format: 'DICOM, SEG', named: segments, left });
}

/** The number of the segment that a frame is of: its own, else that of all frames. */
function segmentOf({ picture: { set }, index }: Frame): number {
  const groups = [set.items(sequences.frameGroups)[index], set.items(sequences.sharedGroups)[0]];
  for (const group of groups) {
    const number = group?.items(sequences.segmentOfFrame)[0]?.number(tags.referencedSegment);
    if (number !== undefined && number > 0) return number;
  }
  throw corruptFile(what, `does not say of which segment its frame ${index + 1} is`);
}

interface Fractions {
  readonly half: number;
  readonly max: number;
}

function readFractions(set: Picture['set']): Fractions {
  // Some writers store whole bytes for segments that have no fractions.
  const max = set.text(tags.segmentationType).toUpperCase() === 'BINARY' ? 1 : (set.number(tags.maxFraction) ?? 255);
  return { max, half: max / 2 };
}

function chooseLabels({ bitsAllocated, padding }: Picture, id: number, fractions: Fractions | null): LabelOf {
  if (id > 0) return bitsAllocated === 1 ? (bit) => bit * id : (share) => (share >= fractions!.half ? id : 0);
  return padding ? (number) => (number >= padding[0] && number <= padding[1] ? 0 : number) : (number) => number;
}

/** The bits of a frame, the lowest of a byte first; frames need not begin with a byte. Source: PS3.5, 8.1.1 and annex D */
function cutBits({ pixels: { bytes, vr, littleEndian }, columns, rows }: Picture, index: number): Uint8Array {
  const bits = new Uint8Array(columns * rows);
  // Words of 16 bits have their lower byte last.
  const turn = vr === 'OW' && !littleEndian ? 1 : 0;
  for (let i = 0, at = index * bits.length; i < bits.length; i++, at++)
    bits[i] = (bytes![Math.floor(at / 8) ^ turn] >> (at % 8)) & 1;
  return bits;
}
