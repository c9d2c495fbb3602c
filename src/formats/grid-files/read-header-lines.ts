import { corruptFile } from '../base/file-problem.ts';

/** More than a header with thousands of file names takes; anything longer is not a header. */
const maxHeaderBytes = 2 ** 21;

export interface HeaderLine {
  /** Without the line's end. */
  readonly text: string;
  /** Where the next line begins, bytes from the file's start. */
  readonly next: number;
}

/**
 * Yields the lines at the beginning of a file, as long as the caller asks for more.
 * @param what - for messages, such as 'the NRRD header'
 * @throws {VolumeViewError} `format/corrupt` if a header does not end
 */
export function* readHeaderLines(what: string, bytes: Uint8Array): Generator<HeaderLine> {
  const decoder = new TextDecoder();
  for (let at = 0; at < bytes.length;) {
    if (at > maxHeaderBytes)
      throw corruptFile(what, `does not end within ${maxHeaderBytes.toLocaleString('en')} bytes; the file is damaged`);
    const within = bytes.subarray(at, at + maxHeaderBytes).indexOf(0x0a);
    const end = within < 0 ? Math.min(bytes.length, at + maxHeaderBytes) : at + within;
    const next = within < 0 ? end : end + 1;
    yield { text: decoder.decode(bytes.subarray(at, end)).replace(/\r$/, ''), next };
    at = next;
  }
}

/**
 * Cuts a line at the first of some signs. It uses no regular expression: those take long for lines of blanks.
 * @param signs - single characters
 * @returns the text before and after the sign, without blanks around; null if there is no sign
 */
export function cutLine(text: string, signs: string): { name: string; sign: string; value: string } | null {
  const places = Array.from(signs, (sign) => text.indexOf(sign)).filter((at) => at >= 0);
  if (places.length === 0) return null;
  const at = Math.min(...places);
  return { name: text.slice(0, at).trim(), sign: text[at], value: text.slice(at + 1).trim() };
}

/** Maximum length of a field's value: enough for matrices, lists of sizes and paths. */
const maxValueLength = 4096;

/** @throws {VolumeViewError} `format/corrupt` */
export function checkValue(what: string, name: string, value: string): string {
  if (value.length <= maxValueLength) return value;
  throw corruptFile(
    what,
    `got ${value.length.toLocaleString('en')} characters as ${name.slice(0, 40)}; expected at most ${maxValueLength.toLocaleString('en')}`,
  );
}
