import type { Volume } from './volume.ts';

/** What says what a volume's world is. */
type Described = Pick<Volume, 'anatomical' | 'format' | 'unit'>;

/** Formats that count lengths in mm, whatever lies in their world. */
const inMillimetres = /^(NIfTI|DICOM|NRRD|MetaImage|MGH|MRC|Analyze|AFNI|MINC|OME-Z)/i;

/** Units of what no patient has. */
const weather = /^(dBZ|m\/s|mm\/h)$/i;

/** Whether the axes of a volume's world are a patient's: x to the right, y to the front, z to the head. A file of a medical format need not say so, and may hold weather. */
export function isPatient({ anatomical, unit }: Pick<Described, 'anatomical' | 'unit'>): boolean {
  return anatomical === true && !weather.test(unit);
}

/** Whether lengths in a volume's world are mm. An image says nothing of it. */
export function isInMillimetres({ format, unit }: Pick<Described, 'format' | 'unit'>): boolean {
  return inMillimetres.test(format) && !weather.test(unit);
}
