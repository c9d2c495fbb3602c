// A picture of Siemens scanners whose tiles are the slices of a volume.
import { add, scale } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { corruptFile } from '../base/file-problem.ts';
import type { Frame } from './frame.ts';
import type { Picture } from './picture.ts';
import { tags } from './tags.ts';

export interface Mosaic {
  readonly size: { readonly columns: number; readonly rows: number };
  /** Where the tiles are, in the picture and in the world. */
  place(frame: Frame): { readonly corner: readonly [number, number]; readonly position: Vector3 | null }[];
}

/**
 * Finds out whether a picture is a mosaic. The file gives the place that the whole picture would have if it lay around
 * the middle of its slice.
 * Source: Siemens' conformance statements (ImageType MOSAIC; 0019,100A), and its header of images (0029,1010)
 */
export function findMosaic({ set, columns, rows, frames, what }: Picture): Mosaic | null {
  if (frames > 1 || !set.texts(tags.imageType).includes('MOSAIC')) return null;
  const header = set.bytesOf(tags.siemensHeader);
  const tiles = set.number(tags.siemensImages) ?? readHeaderNumbers(header, 'NumberOfImagesInMosaic')[0] ?? NaN;
  const across = Math.ceil(Math.sqrt(tiles));
  const size = { columns: columns / across, rows: rows / across };
  if (!(tiles >= 1 && Number.isInteger(tiles) && Number.isInteger(size.columns) && Number.isInteger(size.rows)))
    throw corruptFile(
      what,
      `is a mosaic of ${columns} x ${rows} pixels with ${Number.isNaN(tiles) ? 'no number of' : tiles} tiles; expected tiles of equal size`,
    );
  const [x, y, z] = readHeaderNumbers(header, 'SliceNormalVector');
  return {
    size,
    place({ position, plane, spacing, step }) {
      return Array.from({ length: tiles }, (_, i) => {
        const corner = [(i % across) * size.columns, Math.floor(i / across) * size.rows] as const;
        if (!position || !plane || !spacing || step === null) return { corner, position: null };
        const sign =
          Number.isFinite(x + y + z) && plane.normal[0] * x + plane.normal[1] * y + plane.normal[2] * z < 0 ? -1 : 1;
        const first = add(
          add(position, scale(plane.row, (spacing[0] * (columns - size.columns)) / 2)),
          scale(plane.column, (spacing[1] * (rows - size.rows)) / 2),
        );
        return { corner, position: add(first, scale(plane.normal, sign * i * step)) };
      });
    },
  };
}

/** Bytes of a field's name and description, and of the head of one of its values. */
const [fieldBytes, valueBytes] = [84, 16];

/** The numbers of a field of Siemens' header ("CSA", its second version); none if it is missing. */
function readHeaderNumbers(bytes: Uint8Array<ArrayBuffer>, wanted: string): number[] {
  const latin = (from: number, length: number): string =>
    new TextDecoder('latin1').decode(bytes.subarray(from, from + length)).replace(/\0[\s\S]*$/, '');
  if (latin(0, 4) !== 'SV10') return [];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const fields = view.getUint32(8, true);
  for (let field = 0, at = 16; field < fields && at + fieldBytes <= bytes.length; field++) {
    const isWanted = latin(at, 64) === wanted;
    const values = view.getUint32(at + 76, true);
    at += fieldBytes;
    const numbers: number[] = [];
    for (let i = 0; i < values && at + valueBytes <= bytes.length; i++) {
      const size = view.getUint32(at, true);
      at += valueBytes;
      if (isWanted && size > 0) numbers.push(Number(latin(at, Math.min(size, 64)).trim()));
      at += 4 * Math.ceil(size / 4);
    }
    if (isWanted) return numbers;
  }
  return [];
}
