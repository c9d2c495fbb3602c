/** A file of an archive as a test describes it. What is undefined is written as it should be. */
export interface ZipPart {
  readonly path: string;
  /** As it lies in the archive. */
  readonly packed: Uint8Array;
  readonly method?: number;
  readonly flags?: number;
  readonly crc?: number;
  /** Unpacked, as the list says. */
  readonly size?: number;
  /** Where the list says that it begins. */
  readonly offset?: number;
}

/** What the record at the end says. */
export interface ZipEnd {
  readonly count?: number;
  readonly listBytes?: number;
  readonly listOffset?: number;
  readonly disk?: number;
}

/** An archive, byte by byte, that may say what is not true. Source: PKWARE's APPNOTE.TXT 6.3.10, 4.3 */
export function zipBytes(parts: readonly ZipPart[], end: ZipEnd = {}): Uint8Array<ArrayBuffer> {
  const written: number[] = [];
  const starts = parts.map((part) => {
    const start = written.length;
    append(written, 0x04034b50, 4, 20, 2, ...shared(part), part.path.length, 2, 0, 2);
    written.push(...Array.from(part.path, (c) => c.charCodeAt(0)), ...part.packed);
    return start;
  });
  const listStart = written.length;
  for (const [i, part] of parts.entries()) {
    append(
      written,
      0x02014b50,
      4,
      20,
      2,
      20,
      2,
      ...shared(part),
      part.path.length,
      2,
      0,
      2,
      0,
      2,
      0,
      2,
      0,
      2,
      0,
      4,
      part.offset ?? starts[i],
      4,
    );
    written.push(...Array.from(part.path, (c) => c.charCodeAt(0)));
  }
  const { count = parts.length, listBytes = written.length - listStart, listOffset = listStart, disk = 0 } = end;
  append(written, 0x06054b50, 4, disk, 2, 0, 2, count, 2, count, 2, listBytes, 4, listOffset, 4, 0, 2);
  return Uint8Array.from(written);
}

/** The fields that the header before a file and the list have in common, each with its bytes. */
function shared({ packed, method = 0, flags = 0, crc = 0, size = packed.length }: ZipPart): number[] {
  return [flags, 2, method, 2, 0, 2, 0x21, 2, crc, 4, packed.length, 4, size, 4];
}

/** Pairs of a number and its bytes, the lowest byte first. */
function append(written: number[], ...pairs: readonly number[]): void {
  for (let i = 0; i < pairs.length; i += 2) {
    for (let byte = 0; byte < pairs[i + 1]; byte++) written.push(Math.floor(pairs[i] / 2 ** (8 * byte)) % 256);
  }
}
