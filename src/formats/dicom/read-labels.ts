import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import { isStructureSet } from './picture.ts';
import { readContours } from './read-contours.ts';
import type { DicomFile } from './read-file.ts';
import { readSegmentation } from './read-segmentation.ts';

/** Reads a file that has labels and no values. @throws {VolumeViewError} as readSegmentation and readContours say */
export async function readLabels(file: DicomFile, context: ReadContext): Promise<DecodedCartesianVolume> {
  return isStructureSet(file.set) ? readContours(file, context) : readSegmentation(file, context);
}
