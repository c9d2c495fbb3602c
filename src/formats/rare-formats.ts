import type { VolumeFormat } from './base/format.ts';
import { afni } from './afni/afni-format.ts';
import { analyze } from './analyze/analyze-format.ts';
import { dicom } from './dicom/dicom-format.ts';
import { mgh } from './mgh/mgh-format.ts';
import { mrc } from './mrc/mrc-format.ts';
import { npy } from './npy/npy-format.ts';
import { bzip2 } from './packed/bzip2-format.ts';
import { zstd } from './packed/zstd-format.ts';
import { level3, rainbow } from './radar/more-radar-formats.ts';
import { tiff } from './tiff/tiff-format.ts';
import { vti } from './vti/vti-format.ts';

/**
 * Formats that few pages have. Their descriptions are loaded only for a file that is of none of the usual formats, so
 * that pages with other files do not pay for them.
 */
export const rareFormats: readonly VolumeFormat[] = [
  mgh,
  mrc,
  analyze,
  npy,
  vti,
  afni,
  dicom,
  tiff,
  level3,
  rainbow,
  bzip2,
  zstd,
];
