// Files as addresses: `data:` URLs, for a page that has all inside.
import type { LessonFile } from './lesson.ts';

/** The types that a browser asks for; it reads the bytes of all other files. */
const types: Readonly<Record<string, string>> = {
  png: 'image/png',
  jpg: 'image/jpeg',
  jpeg: 'image/jpeg',
  gif: 'image/gif',
  webp: 'image/webp',
  avif: 'image/avif',
  svg: 'image/svg+xml',
  json: 'application/json',
};

/** The URL of a file's bytes, without its name. */
export function dataUrlOf({ path, bytes }: LessonFile): string {
  const ending = path.slice(path.lastIndexOf('.') + 1).toLowerCase();
  return `data:${types[ending] ?? 'application/octet-stream'};base64,${encodeBase64(bytes)}`;
}

/** Bytes that become one piece of text: a whole number of threes, so that only the end is filled up. */
const pieceBytes = 3 * 2 ** 13;

/** Browsers and Node have this in common. */
export function encodeBase64(bytes: Uint8Array): string {
  const pieces: string[] = [];
  for (let start = 0; start < bytes.length; start += pieceBytes)
    pieces.push(btoa(String.fromCharCode(...bytes.subarray(start, start + pieceBytes))));
  return pieces.join('');
}
