// Segmentations of DICOM of a few pixels, frame by frame. Source: PS3.3, C.8.20
import type { DicomFields } from './dicom-bytes.ts';

/** A frame: its slice, from 0, its segment (none in a label map), and its numbers row by row. */
export interface SegmentFrame {
  readonly slice: number;
  readonly segment?: number;
  readonly pixels: readonly number[];
}

export interface Segmentation {
  readonly type: 'BINARY' | 'FRACTIONAL' | 'LABELMAP';
  readonly columns: number;
  readonly rows: number;
  readonly frames: readonly SegmentFrame[];
  readonly segments: readonly DicomFields[];
  /** Of a slice, in DICOM's world; 2.5 mm apart along an oblique normal where absent. */
  readonly positionOf?: (slice: number) => readonly number[];
  readonly bits?: 1 | 8 | 16;
  /** Of all frames; the oblique stack's where absent. */
  readonly orientation?: readonly number[];
  /** Rows, columns and slices apart, mm. */
  readonly spacing?: readonly [number, number, number];
}

/** Unit vectors along a row and along a column, and across the slices. */
const [row, column, normal] = [
  [0.8, 0.6, 0],
  [-0.36, 0.48, 0.8],
  [0.48, -0.64, 0.6],
];

/** Where the slices of an oblique stack begin. */
const oblique = (slice: number): number[] => [10, -20, 30].map((x, axis) => x + 2.5 * slice * normal[axis]);

/** A segment with a name. @param lab - its colour, as the file has it */
export const segment = (number: number, label: string, lab?: readonly number[]): DicomFields => ({
  SegmentNumber: [number],
  SegmentLabel: label,
  SegmentAlgorithmType: 'MANUAL',
  ...(lab ? { RecommendedDisplayCIELabValue: lab } : {}),
});

/** The elements of a segmentation. */
export function segmentationFields(made: Segmentation): DicomFields {
  const { type, columns, rows, frames, segments, positionOf = oblique } = made;
  const { orientation = [...row, ...column], spacing: [down, across, apart] = [0.75, 0.5, 2.5] } = made;
  const bits = made.bits ?? (type === 'BINARY' ? 1 : 8);
  const all = frames.flatMap(({ pixels }) => pixels);
  return {
    SOPClassUID: type === 'LABELMAP' ? '1.2.840.10008.5.1.4.1.1.66.7' : '1.2.840.10008.5.1.4.1.1.66.4',
    SOPInstanceUID: '1.2.3.66',
    SeriesInstanceUID: '1.2.3',
    Modality: 'SEG',
    SegmentationType: type,
    ...(type === 'FRACTIONAL' ? { SegmentationFractionalType: 'PROBABILITY', MaximumFractionalValue: [200] } : {}),
    SegmentSequence: segments,
    SamplesPerPixel: [1],
    PhotometricInterpretation: 'MONOCHROME2',
    NumberOfFrames: String(frames.length),
    Rows: [rows],
    Columns: [columns],
    BitsAllocated: [bits],
    BitsStored: [bits],
    HighBit: [bits - 1],
    PixelRepresentation: [0],
    SharedFunctionalGroupsSequence: [
      {
        PlaneOrientationSequence: [{ ImageOrientationPatient: orientation }],
        PixelMeasuresSequence: [
          { PixelSpacing: [down, across], SliceThickness: [apart], SpacingBetweenSlices: [apart] },
        ],
      },
    ],
    PerFrameFunctionalGroupsSequence: frames.map(({ slice, segment: number }) => ({
      PlanePositionSequence: [{ ImagePositionPatient: positionOf(slice) }],
      ...(number === undefined ? {} : { SegmentIdentificationSequence: [{ ReferencedSegmentNumber: [number] }] }),
    })),
    PixelData: bits === 1 ? packBits(all) : bits === 8 ? Uint8Array.from(all) : words(all),
  };
}

/** The lowest bit of a byte is the first one; frames follow each other without a gap. */
function packBits(bits: readonly number[]): Uint8Array {
  const bytes = new Uint8Array(Math.ceil(bits.length / 8));
  for (const [i, bit] of bits.entries()) bytes[i >> 3] |= bit << (i & 7);
  return bytes;
}

const words = (numbers: readonly number[]): Uint8Array => new Uint8Array(Uint16Array.from(numbers).buffer);

/** Numbers that differ from pixel to pixel: `n` of them from 0 up to `below`. */
export function scatter(n: number, below: number, seed: number): number[] {
  let state = seed;
  return Array.from({ length: n }, () => {
    state = (state * 1_103_515_245 + 12_345) % 2 ** 31;
    return Math.floor((state / 2 ** 31) * below);
  });
}

/** Three segments of 5 x 3 pixels (15 bits a frame), which overlap, in any order; the slices 1 and 3 have none. */
export const overlapping: Segmentation = {
  type: 'BINARY',
  columns: 5,
  rows: 3,
  frames: [
    { slice: 4, segment: 2, pixels: scatter(15, 2, 1) },
    { slice: 0, segment: 3, pixels: scatter(15, 2, 2) },
    { slice: 2, segment: 1, pixels: scatter(15, 2, 3) },
    { slice: 0, segment: 1, pixels: scatter(15, 2, 4) },
    { slice: 2, segment: 3, pixels: scatter(15, 2, 5) },
  ],
  segments: [
    segment(1, 'Liver', [43863, 49602, 45746]),
    segment(2, 'Spleen', [60000, 20000, 50000]),
    segment(3, 'Vessel'),
  ],
};
