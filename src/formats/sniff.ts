import { VolumeViewError } from '../errors.ts';
import type { DecodeInput } from './decoded-volume.ts';
import { gunzip, isGzip } from './gunzip.ts';
import { findHdf5 } from './hdf-signature.ts';
import { detectNifti } from './nifti-header.ts';

/** Radar files; HDF5 may hold ODIM_H5 or CfRadial. */
export type RadarKind = 'hdf5' | 'netcdf3' | 'nexrad';

export type FileKind = 'nifti' | 'nifti-gz' | 'png' | 'jpeg' | 'webp' | 'manifest' | RadarKind;

/**
 * What a file is: its bytes say so first, then its name.
 * @throws {VolumeViewError} `format/unknown`, in words that fit what came instead
 */
export async function sniffFile({ bytes, url, contentType }: DecodeInput): Promise<FileKind> {
  if (isGzip(bytes)) return isNexrad(await firstPiece(bytes)) ? 'nexrad' : 'nifti-gz';
  if (detectNifti(bytes)) return 'nifti';
  if (startsWith(bytes, '\x89PNG\r\n\x1a\n')) return 'png';
  if (startsWith(bytes, '\xff\xd8\xff')) return 'jpeg';
  if (startsWith(bytes, 'RIFF') && startsWith(bytes.subarray(8), 'WEBP')) return 'webp';
  if (findHdf5(bytes) >= 0) return 'hdf5';
  if (['\x01', '\x02', '\x05'].some((version) => startsWith(bytes, `CDF${version}`))) return 'netcdf3';
  if (isNexrad(bytes)) return 'nexrad';
  const text = decodeStart(bytes);
  if (text.startsWith('{')) return 'manifest';
  const name = nameOf(url);
  if (text.startsWith('<')) throw unknown(`the server answered ${name} with a web page or XML instead of data; check the URL`);
  if (bytes.length === 0) throw unknown(`${name} is empty; check the file`);
  // A file that the name calls one of ours and the bytes do not is a damaged or cut one, which its reader explains.
  if (/\.nii$/i.test(name)) throw damaged(name, 'a NIfTI header');
  if (/\.gz$/i.test(name)) throw damaged(name, 'a gzip header');
  if (/\.(png|jpe?g|webp)$/i.test(name)) throw damaged(name, 'the signature of such an image');
  if (/\.(h5|hdf5?|nc4?)$/i.test(name)) throw damaged(name, 'the signature of HDF5 or NetCDF');
  if (/\.json$/i.test(name)) return 'manifest';
  const type = contentType ? ` (sent as ${contentType})` : '';
  throw unknown(`${name}${type} is of no known type; expected NIfTI (.nii, .nii.gz), a mosaic (.png, .jpg, .webp), a radar scan (ODIM_H5, CfRadial, NEXRAD Level II) or a manifest (.json)`);
}

/** The last part of a URL's path, for messages; of a data: URL only its type, of a blob: URL the fragment, where it has one. */
export function nameOf(url: string): string {
  if (url.startsWith('data:')) return url.slice(0, Math.min(40, url.indexOf(',') + 1 || 40));
  if (url.startsWith('blob:') && url.includes('#')) return decodeFragment(url);
  const path = url.replace(/[?#].*$/, '');
  return path.slice(path.lastIndexOf('/') + 1) || path;
}

function decodeFragment(url: string): string {
  const fragment = url.slice(url.indexOf('#') + 1);
  try {
    return decodeURIComponent(fragment);
  } catch {
    return fragment;
  }
}

/** The volume header of an Archive II file; older ones say ARCHIVE2. */
function isNexrad(bytes: Uint8Array): boolean {
  return startsWith(bytes, 'AR2V') || startsWith(bytes, 'ARCHIVE2.');
}

/** The beginning of what a gzip file holds; nothing where it is damaged, which its reader explains. */
async function firstPiece(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  try {
    for await (const piece of gunzip(bytes.subarray(0, 1 << 16))) return piece;
  } catch {
    // The stream was cut short on purpose, and may also be damaged.
  }
  return new Uint8Array();
}

function unknown(message: string): VolumeViewError {
  return new VolumeViewError('format/unknown', message);
}

function damaged(name: string, expected: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `${name} does not begin with ${expected}; the file is damaged, cut short or misnamed`);
}

function startsWith(bytes: Uint8Array, signature: string): boolean {
  return bytes.length >= signature.length && Array.from(signature).every((c, i) => bytes[i] === c.charCodeAt(0));
}

/** The first characters, without byte order mark and white space. */
function decodeStart(bytes: Uint8Array): string {
  return new TextDecoder().decode(bytes.subarray(0, 512)).trimStart();
}
