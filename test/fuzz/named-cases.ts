import type { FuzzCase } from './fuzz-case.ts';
import { contourCases } from './named/contour-cases.ts';
import { hdf5Cases } from './named/hdf5-cases.ts';
import { imageCases } from './named/image-cases.ts';
import { otherCases } from './named/other-cases.ts';
import { radarCases } from './named/radar-cases.ts';

/** Cases that were found by reading the code, or in a browser. Written out, as each says more than its bytes would. */
export const namedCases: Readonly<Record<string, () => FuzzCase>> = {
  ...contourCases,
  ...hdf5Cases,
  ...imageCases,
  ...radarCases,
  ...otherCases,
};
