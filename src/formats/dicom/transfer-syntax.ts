/** How the pixels of a file are packed. */
export interface TransferSyntax {
  readonly packing:
    | 'none'
    | 'RLE'
    | 'JPEG'
    | 'lossless JPEG'
    | 'JPEG-LS'
    | 'JPEG 2000'
    | 'HTJ2K'
    | 'JPEG XL'
    | 'video'
    | 'unknown';
  readonly isBigEndian?: true;
  readonly isDeflated?: true;
  /** Whether unpacked numbers may differ from those that were packed, so that a bit alone means nothing. */
  readonly isLossy?: true;
}

const root = '1.2.840.10008.1.2';

/** Source: DICOM PS3.6, table A-1, and PS3.5, annex A */
const syntaxes: Readonly<Record<string, TransferSyntax>> = {
  '': { packing: 'none' },
  '.1': { packing: 'none' },
  '.1.98': { packing: 'none' },
  '.1.99': { packing: 'none', isDeflated: true },
  '.2': { packing: 'none', isBigEndian: true },
  '.5': { packing: 'RLE' },
  '.4.50': { packing: 'JPEG', isLossy: true },
  '.4.51': { packing: 'JPEG', isLossy: true },
  '.4.57': { packing: 'lossless JPEG' },
  '.4.70': { packing: 'lossless JPEG' },
  '.4.80': { packing: 'JPEG-LS' },
  '.4.81': { packing: 'JPEG-LS', isLossy: true },
  '.4.90': { packing: 'JPEG 2000' },
  '.4.91': { packing: 'JPEG 2000', isLossy: true },
  '.4.92': { packing: 'JPEG 2000' },
  '.4.93': { packing: 'JPEG 2000', isLossy: true },
  '.4.110': { packing: 'JPEG XL' },
  '.4.111': { packing: 'JPEG XL' },
  '.4.112': { packing: 'JPEG XL' },
  '.4.201': { packing: 'HTJ2K' },
  '.4.202': { packing: 'HTJ2K' },
  '.4.203': { packing: 'HTJ2K', isLossy: true },
};

/** Any other number of this form is a video. */
const video = /^\.4\.10\d$/;

/** @param uid - of the transfer syntax; '' if the file has none */
export function readSyntax(uid: string): TransferSyntax {
  if (uid === '') return { packing: 'none' };
  if (!uid.startsWith(root)) return { packing: 'unknown' };
  const rest = uid.slice(root.length);
  return syntaxes[rest] ?? { packing: video.test(rest) ? 'video' : 'unknown' };
}
