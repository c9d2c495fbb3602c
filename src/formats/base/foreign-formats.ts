import type { FileStart } from './format.ts';
import { startsWith } from './starts-with.ts';

// Well-known files that are not read here. The message says what such a file is, and how to convert it to a file that
// is read.

interface ForeignFormat {
  /** With its article. */
  readonly name: string;
  /** What its author can do: the end of a sentence that begins 'convert it …'. */
  readonly advice: string;
  matches(start: FileStart, bytes: Uint8Array): boolean;
}

const begins =
  (...signatures: readonly string[]): ForeignFormat['matches'] =>
  (_, bytes) =>
    signatures.some((one) => startsWith(bytes, one));
const asPng = 'to PNG, one file for each slice, and list them in src with the attribute stack';

/** Sources: each format's own description, in the manuals of its tools. */
const foreign: readonly ForeignFormat[] = [
  {
    name: 'a VTK file',
    advice: 'to MetaImage (.mha) or NRRD, with ParaView or 3D Slicer',
    matches: ({ text }) => text.startsWith('# vtk DataFile') || /^(<\?xml[^>]{0,100}>\s*)?<VTKFile/.test(text),
  },
  {
    name: 'a Philips PAR/REC header',
    advice: 'to NIfTI: dcm2niix -z y file.par',
    matches: ({ text }) => text.startsWith('# === DATA DESCRIPTION FILE'),
  },
  {
    name: 'a GIF, BMP, JPEG 2000 or AVIF image',
    advice: asPng,
    matches: (_, bytes) =>
      startsWith(bytes, 'GIF8') ||
      startsWith(bytes, '\0\0\0\x0cjP  ') ||
      /^....ftypavi[fs]/s.test(latin(bytes, 12)) ||
      (startsWith(bytes, 'BM') &&
        bytes[6] === 0 &&
        bytes[7] === 0 &&
        bytes[8] === 0 &&
        bytes[9] === 0 &&
        bytes.length > 54),
  },
  {
    name: 'a GRIB file',
    advice: 'to another format: model fields on maps are not read; of radars, ODIM_H5 and CfRadial are',
    matches: begins('GRIB'),
  },
  { name: 'a BUFR file', advice: 'to ODIM_H5, with the OPERA software of EUMETNET', matches: begins('BUFR') },
  { name: 'an HDF4 file', advice: 'to HDF5: h4toh5 file.hdf file.h5', matches: begins('\x0e\x03\x13\x01') },
  {
    name: 'an IRIS (Sigmet) radar file',
    advice: 'to CfRadial, with Py-ART or xradar',
    // A structure of the kind 27, product_hdr, in which one of the kind 26 comes first. Source: IRIS Programmer's Manual, structure_header
    matches: (_, bytes) => startsWith(bytes, '\x1b\0') && startsWith(bytes.subarray(12), '\x1a\0'),
  },
  {
    name: 'a DORADE radar file',
    advice: 'to CfRadial, with RadxConvert of LROSE',
    matches: begins('SSWB', 'COMM\0\0', 'COMM\xf4\x01', 'VOLD'),
  },
  {
    name: 'a Universal Format (UF) radar file',
    advice: 'to CfRadial, with Py-ART: pyart.io.read_uf and write_cfradial',
    matches: begins('UF', '\0\0\x0f\xa0UF'),
  },
  {
    name: 'a file packed by compress (.Z)',
    advice: 'into the file that it holds: gzip -d file.Z',
    matches: begins('\x1f\x9d'),
  },
  { name: 'a file packed by xz', advice: 'into the file that it holds: xz -d file.xz', matches: begins('\xfd7zXZ\0') },
  { name: 'a zip archive', advice: 'into the files that it holds: unpack it', matches: begins('PK\x03\x04') },
];

/** Names a file of an unsupported format and says what to do with it; null if the format is unknown. */
export function findForeign(start: FileStart): Pick<ForeignFormat, 'name' | 'advice'> | null {
  const bytes = start.unpacked ?? start.bytes;
  return foreign.find((format) => format.matches(start, bytes)) ?? null;
}

function latin(bytes: Uint8Array, length: number): string {
  return String.fromCharCode(...bytes.subarray(0, length));
}
