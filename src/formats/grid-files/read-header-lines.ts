import { corruptFile } from './file-problem.ts';

/** More than a header of thousands of file names takes; what is longer is no header. */
const maxHeaderBytes = 2 ** 21;

export interface HeaderLine {
  /** Without its end. */
  readonly text: string;
  /** Where the next line begins, bytes from the file's start. */
  readonly next: number;
}

/**
 * The lines at the beginning of a file, for as long as they are asked for.
 * @param what - for messages, such as 'the NRRD header'
 * @throws {VolumeViewError} `format/corrupt` where a header does not end
 */
export function* readHeaderLines(what: string, bytes: Uint8Array): Generator<HeaderLine> {
  const decoder = new TextDecoder();
  for (let at = 0; at < bytes.length; ) {
    if (at > maxHeaderBytes) throw corruptFile(what, `does not end within ${maxHeaderBytes.toLocaleString('en')} bytes; the file is damaged`);
    const within = bytes.subarray(at, at + maxHeaderBytes).indexOf(0x0a);
    const end = within < 0 ? Math.min(bytes.length, at + maxHeaderBytes) : at + within;
    const next = within < 0 ? end : end + 1;
    yield { text: decoder.decode(bytes.subarray(at, end)).replace(/\r$/, ''), next };
    at = next;
  }
}
