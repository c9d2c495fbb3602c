// Answers of several parts. Source: RFC 2046, 5.1; RFC 2387
import { VolumeViewError } from '../core/errors.ts';

export interface Part {
  /** With its parameters. */
  readonly contentType: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** Maximum bytes of the lines before a part. */
const maxHeader = 4096;

/**
 * The parts of an answer; an answer of another type is one part.
 * @param what - for messages
 * @throws {VolumeViewError} `source/unavailable` where it is cut short
 */
export function splitParts(bytes: Uint8Array<ArrayBuffer>, contentType: string, what: string): Part[] {
  if (!/^\s*multipart\//i.test(contentType)) return [{ contentType, bytes }];
  const [, quoted, plain] = /;\s*boundary=(?:"([^"]+)"|([^;\s]+))/i.exec(contentType) ?? [];
  const mark = new TextEncoder().encode(`--${quoted ?? plain ?? ''}`);
  const parts: Part[] = [];
  let at = find(bytes, mark, 0);
  while (at >= 0) {
    const start = at + mark.length;
    if (bytes[start] === 0x2d && bytes[start + 1] === 0x2d) return parts;
    const body = find(bytes, headerEnd, start - 2, start + maxHeader) + headerEnd.length;
    const next = body < start ? -1 : find(bytes, mark, body);
    if (next < 0) break;
    const lines = new TextDecoder('latin1').decode(bytes.subarray(start, body));
    // The line end before a mark belongs to it.
    parts.push({
      contentType: /^content-type:\s*(.*)$/im.exec(lines)?.[1].trim() ?? '',
      bytes: bytes.subarray(body, Math.max(body, next - 2)),
    });
    at = next;
  }
  throw new VolumeViewError('source/unavailable', `${what} is cut short: the end of its last part is missing`);
}

const headerEnd = Uint8Array.of(13, 10, 13, 10);

/** The first place of a mark, from a place on; -1 where there is none before `end`. */
function find(bytes: Uint8Array, mark: Uint8Array, from: number, end = bytes.length): number {
  const last = Math.min(end, bytes.length) - mark.length;
  for (let at = bytes.indexOf(mark[0], from); at >= 0 && at <= last; at = bytes.indexOf(mark[0], at + 1)) {
    let length = 1;
    while (length < mark.length && bytes[at + length] === mark[length]) length++;
    if (length === mark.length) return at;
  }
  return -1;
}
