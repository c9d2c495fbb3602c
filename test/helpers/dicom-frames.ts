// Frames of DICOM: an enhanced file, each of whose frames has its place and its time; and a slice for packed streams.
import { ctSlice } from './dicom-bytes.ts';
import type { DicomFields } from './dicom-bytes.ts';

/** Of how many times and slices, and the width and height of a frame. */
export interface TimedSize {
  readonly times: number;
  readonly slices: number;
  readonly edge: number;
}

/** The numbers of a frame, each of which says its time and its slice. */
export const numbersAt = (time: number, slice: number, edge: number): Int16Array =>
  Int16Array.from({ length: edge * edge }, (_, i) => 1000 * time + 10 * slice + ((i * (slice + 3)) % 7));

/** Time and slice of each frame, as they lie in the file: slices backwards, and of each all times. */
export const listTimed = ({ times, slices }: TimedSize): { readonly time: number; readonly slice: number }[] =>
  Array.from({ length: times * slices }, (_, i) => ({
    time: i % times,
    slice: slices - 1 - Math.floor(i / times),
  }));

/** The frames as they lie in the file. */
export const timedFrames = (size: TimedSize): Int16Array[] =>
  listTimed(size).map(({ time, slice }) => numbersAt(time, slice, size.edge));

/** The elements of the file. Positions in time count from 1, and nothing says when they were. */
export function timedFields(size: TimedSize, fields: DicomFields = {}): DicomFields {
  const frames = listTimed(size);
  const bytes = timedFrames(size).flatMap((numbers) => [...new Uint8Array(numbers.buffer)]);
  return {
    ...ctSlice(0),
    Modality: 'MR',
    RescaleIntercept: undefined,
    RescaleSlope: undefined,
    ImagePositionPatient: undefined,
    SliceThickness: undefined,
    Rows: [size.edge],
    Columns: [size.edge],
    PixelRepresentation: [1],
    NumberOfFrames: String(frames.length),
    SharedFunctionalGroupsSequence: [
      {
        PlaneOrientationSequence: [{ ImageOrientationPatient: [1, 0, 0, 0, 1, 0] }],
        PixelMeasuresSequence: [{ PixelSpacing: [1, 1], SpacingBetweenSlices: '3' }],
      },
    ],
    PerFrameFunctionalGroupsSequence: frames.map(({ time, slice }) => ({
      FrameContentSequence: [{ TemporalPositionIndex: [time + 1] }],
      PlanePositionSequence: [{ ImagePositionPatient: [-1, -2, 3 * slice] }],
    })),
    PixelData: Uint8Array.from(bytes),
    ...fields,
  };
}

/** What a time shows: its numbers, slice by slice. */
export const valuesAt = (time: number, { slices, edge }: TimedSize): number[] =>
  Array.from({ length: slices }, (_, k) => [...numbersAt(time, k, edge)]).flat();

/** The elements of one time in a mosaic of 2 x 2 tiles, as Siemens writes heads. @param edge - of the mosaic, in pixels @param count - of tiles with a slice */
export function mosaicFields(
  time: number,
  { edge, count }: { readonly edge: number; readonly count: number },
): DicomFields {
  const numbers = Int16Array.from({ length: edge * edge }, (_, i) => 1000 * time + i);
  return {
    ...timedFields({ times: 1, slices: 1, edge }),
    NumberOfFrames: undefined,
    PerFrameFunctionalGroupsSequence: undefined,
    SharedFunctionalGroupsSequence: undefined,
    ImageType: 'ORIGINAL\\PRIMARY\\M\\MOSAIC',
    SOPInstanceUID: `1.2.6.${time}`,
    ImagePositionPatient: [0, 0, 0],
    SpacingBetweenSlices: [3],
    NumberOfImagesInMosaic: [count],
    AcquisitionTime: `10000${2 * time}`,
    PixelData: new Uint8Array(numbers.buffer),
  };
}

/** A slice of 10 x 9 numbers that are values, as packed streams of tests hold them. */
export const packedSlice: DicomFields = {
  ...ctSlice(0),
  Modality: 'MR',
  RescaleSlope: undefined,
  RescaleIntercept: undefined,
  Rows: [9],
  Columns: [10],
};
