import { corruptFile } from '../base/file-problem.ts';
import type { NiftiHeader } from './nifti-header.ts';

const what = 'the NIfTI header';

/** The error for a header that `isSound` refuses. */
export function refuseHeader({ dim, slope, intercept }: NiftiHeader): Error {
  const [axes] = dim;
  if (!(axes >= 1 && axes <= 7)) return corruptFile(what, `got ${axes} axes; expected 1 to 7`);
  const lengths = dim.slice(1, 1 + axes);
  if (!(lengths[0] >= 1))
    return corruptFile(what, `got dimensions ${lengths.join(' x ')}; expected 1 or more along the first axis`);
  return corruptFile(what, `got scl_slope ${slope} with scl_inter ${intercept}; expected a finite number`);
}
