import { loadReader } from '../base/load-reader.ts';
import type { UnpackLs } from '../codecs/charls.ts';
import type { UnpackJ2k } from '../codecs/openjpeg.ts';
import type { Picture } from './picture.ts';

/** What unpacks pixels besides our own code; null where no picture needs it, or the page's policy refuses it. */
export interface Libraries {
  readonly j2k: UnpackJ2k | null;
  readonly ls: UnpackLs | null;
}

export const noLibraries: Libraries = { j2k: null, ls: null };

/** Whether a picture is packed with JPEG 2000, which no code of our own unpacks. */
export const isJ2k = ({ syntax: { packing } }: Picture): boolean => packing === 'JPEG 2000' || packing === 'HTJ2K';

/** Loads what pictures need. */
export async function loadLibraries(pictures: readonly Picture[]): Promise<Libraries> {
  const needsLs = pictures.some(({ syntax: { packing } }) => packing === 'JPEG-LS');
  return {
    j2k: pictures.some(isJ2k) ? await (await loadReader(() => import('../codecs/openjpeg.ts'))).loadOpenJpeg() : null,
    ls: needsLs ? await (await loadReader(() => import('../codecs/charls.ts'))).loadCharls() : null,
  };
}
