// Structure sets of DICOM (RTSTRUCT): regions by their contours. Source: PS3.3, C.8.8.5 and C.8.8.6
import type { DicomFields } from './dicom-bytes.ts';

export type Point = readonly [x: number, y: number, z: number];

export interface MadeRegion {
  readonly number: number;
  readonly name: string;
  readonly color?: readonly number[];
  readonly contours: readonly (readonly Point[])[];
  readonly type?: string;
}

/** The elements of a structure set. Places are written in hundredths of a millimetre, as programs do. */
export function structureSetFields(regions: readonly MadeRegion[]): DicomFields {
  return {
    SOPClassUID: '1.2.840.10008.5.1.4.1.1.481.3',
    SOPInstanceUID: '1.2.3.481',
    SeriesInstanceUID: '1.2.4',
    Modality: 'RTSTRUCT',
    StructureSetROISequence: regions.map(({ number, name }) => ({ ROINumber: [number], ROIName: name })),
    ROIContourSequence: regions.map(({ number, color, contours, type = 'CLOSED_PLANAR' }) => ({
      ...(color ? { ROIDisplayColor: color } : {}),
      ReferencedROINumber: [number],
      ContourSequence: contours.map((points) => ({
        ContourGeometricType: type,
        NumberOfContourPoints: [points.length],
        ContourData: points.flat().map((x) => Number(x.toFixed(2))),
      })),
    })),
  };
}

/** A closed line of corners around a place in a plane across z. */
export function circle([x, y, z]: Point, radius: number, corners = 48): Point[] {
  return Array.from({ length: corners }, (_, i) => {
    const angle = (2 * Math.PI * i) / corners;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle), z];
  });
}

/** A square with a square hole, as one line: a bridge leads in and back. */
export function keyhole([x, y, z]: Point, outer: number, inner: number): Point[] {
  const corners = (half: number, turn: 1 | -1): Point[] =>
    [
      [-half, -half],
      [turn * half, -turn * half],
      [half, half],
      [-turn * half, turn * half],
      [-half, -half],
    ].map(([dx, dy]) => [x + dx, y + dy, z]);
  return [...corners(outer, 1), ...corners(inner, -1)];
}

const heights = [-10, -7.5, -5, -2.5, 0];

/** A body in five planes, with a tube in three of them, and a square with a hole, which is not in the third plane. */
export const regions: readonly MadeRegion[] = [
  {
    number: 1,
    name: 'Body',
    color: [0, 255, 0],
    contours: heights.map((z) => circle([5, -10, z], 30)),
  },
  {
    number: 2,
    name: 'Tube',
    color: [255, 0, 51],
    contours: [1, 2, 3].flatMap((i) => [circle([9, -8, heights[i]], 14), circle([9, -8, heights[i]], 7)]),
  },
  {
    number: 7,
    name: 'Keyhole',
    contours: [0, 1, 3].map((i) => keyhole([-12.3, -10.1, heights[i]], 6, 2)),
  },
];
