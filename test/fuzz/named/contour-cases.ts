import { dicomBytes } from '../../helpers/dicom-bytes.ts';
import { circle, structureSetFields } from '../../helpers/dicom-contours.ts';
import type { MadeRegion, Point } from '../../helpers/dicom-contours.ts';
import { oneFile } from '../fuzz-case.ts';
import type { FuzzCase } from '../fuzz-case.ts';

const contoursOf = (regions: readonly MadeRegion[]): FuzzCase =>
  oneFile('a.dcm', dicomBytes(structureSetFields(regions), { isImplicit: true }));

/** Up and down over all rows, at each point. */
const zigzag = (points: number): Point[] => Array.from({ length: points }, (_, i) => [i % 97, i % 2 ? 100 : 0, 0]);

export const contourCases: Readonly<Record<string, () => FuzzCase>> = {
  'dicom: 500 regions of which each lies over all others': () =>
    contoursOf(
      Array.from({ length: 500 }, (_, i) => ({
        number: i + 1,
        name: '',
        contours: [circle([0, 0, 0], 100 - i / 100, 8)],
      })),
    ),
  'dicom: a contour that crosses each row 10,000 times': () =>
    contoursOf([{ number: 1, name: '', contours: [zigzag(10_000)] }]),
  'dicom: planes a hundredth of a millimetre apart, over 100 metres': () =>
    contoursOf([{ number: 1, name: '', contours: [0, 0.06, 9e4].map((z): Point[] => circle([0, 0, z], 9e4, 4)) }]),
  'dicom: contours that are one point': () =>
    contoursOf([{ number: 65_535, name: '', contours: [0, 1].map((z): Point[] => circle([7, 7, z], 0, 5)) }]),
};
