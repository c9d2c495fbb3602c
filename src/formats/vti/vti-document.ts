import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { readXml } from '../base/read-xml.ts';

const what = 'the VTI file';

type Attributes = ReadonlyMap<string, string>;

/** One DataArray. */
export interface VtiArray {
  readonly attributes: Attributes;
  readonly name: string;
  readonly components: number;
  readonly at: 'points' | 'cells';
  /** Its text; empty if its data are appended. */
  data: string;
}

export interface VtiDocument {
  readonly file: Attributes;
  readonly image: Attributes;
  readonly piece: Attributes;
  readonly arrays: readonly VtiArray[];
  /** The names of the arrays that the file wants to be shown: an attribute Scalars. */
  readonly scalars: readonly string[];
  /** The appended data, from the byte after their "_" on; null if there are none. */
  readonly appended: { readonly bytes: Uint8Array<ArrayBuffer>; readonly encoding: string } | null;
}

/** Arrays of a file, and pieces: more than any file has. */
const maxElements = 10_000;

/**
 * Reads the structure of a VTI file, and finds its arrays. What follows `<AppendedData encoding="raw">` is no XML, so
 * the XML is read up to there.
 * Source: VTK 9, "VTK XML formats", docs.vtk.org
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readVtiDocument(bytes: Uint8Array<ArrayBuffer>): VtiDocument {
  const tag = findText(bytes, '<AppendedData', 0);
  const tagEnd = tag < 0 ? -1 : bytes.indexOf(0x3e, tag);
  const isCut = tagEnd >= 0;
  const text =
    new TextDecoder().decode(isCut ? bytes.subarray(0, tagEnd + 1) : bytes) +
    (isCut ? '</AppendedData></VTKFile>' : '');
  const found: {
    file?: Attributes;
    image?: Attributes;
    pieces: Attributes[];
    arrays: VtiArray[];
    scalars: string[];
    appended?: Attributes;
  } = { pieces: [], arrays: [], scalars: [] };
  let section: VtiArray['at'] | null = null;
  let current: VtiArray | null = null;
  // Elements inside of an array, such as InformationKey: their text is no data.
  let inside = 0;
  try {
    readXml(text, {
      open(name, attributes) {
        if (current) inside++;
        else if (name === 'VTKFile') found.file ??= attributes;
        else if (name === 'ImageData') found.image ??= attributes;
        else if (name === 'Piece') found.pieces.push(attributes);
        else if (name === 'AppendedData') found.appended ??= attributes;
        else if (name === 'PointData' || name === 'CellData') {
          section = name === 'PointData' ? 'points' : 'cells';
          const scalars = attributes.get('Scalars');
          if (scalars) found.scalars.push(scalars);
        } else if (name === 'DataArray' && section) {
          current = {
            attributes,
            name: attributes.get('Name') ?? '',
            components: Number(attributes.get('NumberOfComponents') ?? 1),
            at: section,
            data: '',
          };
          found.arrays.push(current);
        }
        if (found.arrays.length + found.pieces.length > maxElements)
          throw corruptFile(what, `has more than ${maxElements.toLocaleString('en')} arrays; the file is damaged`);
      },
      close(name) {
        if (inside > 0) inside--;
        else if (name === 'DataArray') current = null;
        else if (name === 'PointData' || name === 'CellData') section = null;
      },
      text(part) {
        if (current && inside === 0) current.data += part;
      },
    });
  } catch (cause) {
    if (!(cause instanceof SyntaxError)) throw cause;
    throw corruptFile(what, `is no XML that can be read: ${cause.message.slice(0, 200)}. Write it again`);
  }
  const { file, image, pieces, arrays, scalars, appended } = found;
  if (!file || !image || pieces.length === 0)
    throw corruptFile(what, 'lacks <VTKFile>, <ImageData> or <Piece>; the file is damaged');
  if (pieces.length > 1)
    throw unsupportedFile(
      what,
      `has ${pieces.length} pieces; expected one. Open it in ParaView, and save the data again as one .vti file`,
    );
  const start = isCut ? bytes.indexOf(0x5f, tagEnd) + 1 : 0;
  return {
    file,
    image,
    piece: pieces[0],
    arrays,
    scalars,
    appended:
      appended && start > 0 ? { bytes: bytes.subarray(start), encoding: appended.get('encoding') ?? 'base64' } : null,
  };
}

/** The first place of a text of ASCII in bytes; -1 if there is none. */
function findText(bytes: Uint8Array, text: string, from: number): number {
  for (let at = bytes.indexOf(text.charCodeAt(0), from); at >= 0; at = bytes.indexOf(text.charCodeAt(0), at + 1)) {
    let length = 1;
    while (length < text.length && bytes[at + length] === text.charCodeAt(length)) length++;
    if (length === text.length) return at;
  }
  return -1;
}
