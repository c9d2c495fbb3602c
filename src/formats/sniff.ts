import { VolumeViewError } from '../errors.ts';
import type { DecodeInput } from './decoded-volume.ts';
import { isGzip } from './gunzip.ts';
import { detectNifti } from './nifti-header.ts';

export type FileKind = 'nifti' | 'nifti-gz' | 'png' | 'jpeg' | 'webp' | 'manifest';

/**
 * What a file is: its bytes say so first, then its name.
 * @throws {VolumeViewError} `format/unknown`, in words that fit what came instead
 */
export function sniffFile({ bytes, url, contentType }: DecodeInput): FileKind {
  if (isGzip(bytes)) return 'nifti-gz';
  if (detectNifti(bytes)) return 'nifti';
  if (startsWith(bytes, '\x89PNG\r\n\x1a\n')) return 'png';
  if (startsWith(bytes, '\xff\xd8\xff')) return 'jpeg';
  if (startsWith(bytes, 'RIFF') && startsWith(bytes.subarray(8), 'WEBP')) return 'webp';
  const text = decodeStart(bytes);
  if (text.startsWith('{')) return 'manifest';
  const name = nameOf(url);
  if (text.startsWith('<')) throw unknown(`the server answered ${name} with a web page or XML instead of data; check the URL`);
  if (bytes.length === 0) throw unknown(`${name} is empty; check the file`);
  // A file that the name calls one of ours and the bytes do not is a damaged or cut one, which its reader explains.
  if (/\.nii$/i.test(name)) throw damaged(name, 'a NIfTI header');
  if (/\.gz$/i.test(name)) throw damaged(name, 'a gzip header');
  if (/\.(png|jpe?g|webp)$/i.test(name)) throw damaged(name, 'the signature of such an image');
  if (/\.json$/i.test(name)) return 'manifest';
  const type = contentType ? ` (sent as ${contentType})` : '';
  throw unknown(`${name}${type} is of no known type; expected NIfTI (.nii, .nii.gz), a mosaic (.png, .jpg, .webp) or a manifest (.json)`);
}

/** The last part of a URL's path, for messages; of a data: URL only its type. */
export function nameOf(url: string): string {
  if (url.startsWith('data:')) return url.slice(0, Math.min(40, url.indexOf(',') + 1 || 40));
  const path = url.replace(/[?#].*$/, '');
  return path.slice(path.lastIndexOf('/') + 1) || path;
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
