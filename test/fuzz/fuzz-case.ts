import type { DecodeSettings } from '../../src/formats/base/decoded-volume.ts';
import type { Random } from './random.ts';

export interface FuzzFile {
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** Files, the first of which is loaded, and what the attributes say of it. */
export interface FilesCase {
  readonly files: readonly FuzzFile[];
  /** Whether all files are one volume's. */
  readonly stack?: true;
  /** Whether their names are the paths of a folder that is read as a whole. */
  readonly isTree?: true;
  /** Whether such a folder is read brick by brick. */
  readonly isBricks?: true;
  /** Of such a folder: whether the one file is an archive with it, and what its address asks for. */
  readonly isPacked?: boolean;
  readonly choice?: { readonly channel?: string; readonly channels?: string };
  /** Whether the files are those of a folder that a reader chose. */
  readonly folder?: true;
  /** Whether each of several times is shown, one after the other. */
  readonly times?: true;
  /** Set where the files are a list on a server. */
  readonly server?: ServerCase;
  /** Set where the files are what a DICOMweb server has: the list of a series, then frames and tables by their paths below it. */
  readonly web?: WebCase;
  readonly settings?: DecodeSettings;
}

/** How a server sends files. */
export interface ServerCase {
  readonly sendsParts: boolean;
  /** Whether the answer with a part does not say how long the file is. */
  readonly hidesSizes: boolean;
  /** Added to the length that it says. */
  readonly liesBy: number;
  /** The place of the file that is not there, and of the one that ends early. */
  readonly lacks: number | null;
  readonly cuts: number | null;
}

/** How a DICOMweb server answers. */
export interface WebCase {
  /** Content types of the list, of an answer with frames, of each of its parts. */
  readonly listType: string;
  readonly type: string;
  readonly partType: string;
  /** Between parts, whatever the content type says. */
  readonly boundary: string;
  /** Before the bytes of a part, instead of its content type alone. */
  readonly header: string | null;
  /** What ends a line, and what is before the first part. */
  readonly lineEnd: string;
  readonly preamble: string;
  /** Parts that come too often, or do not come. */
  readonly moreParts: number;
  /** Which answers end early, and where: as a share of their bytes. */
  readonly cuts: { readonly every: number; readonly at: number } | null;
  /** Which answers break off there, as where a network fails. */
  readonly breaks: { readonly every: number; readonly at: number } | null;
  /** Which answers are an error. */
  readonly status: { readonly every: number; readonly code: number } | null;
  /** Bytes that come at once. */
  readonly pieceBytes: number;
  /** Added to the length that it says; null where it says none. */
  readonly liesBy: number | null;
  /** Whether it refuses to send what it has as it has it. */
  readonly isPlain: boolean;
}

/** A text for what reads an attribute: `before`, `pump` n times, `after`. */
export interface TextCase {
  readonly attribute: string;
  readonly before: string;
  readonly pump: string;
  readonly after: string;
}

export type FuzzCase = FilesCase | TextCase;

/** Makes a case: mostly sound, with some things wrong. */
export type Grammar = (random: Random) => FuzzCase;

export const oneFile = (name: string, bytes: Uint8Array<ArrayBuffer>, settings?: DecodeSettings): FilesCase => ({
  files: [{ name, bytes }],
  settings,
});

/** Damage that knows no structure: cut, noise, or something after the end. Most cases have none. */
export function damage(random: Random, bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  if (random.isSound || !random.chance(0.15) || bytes.length === 0) return bytes;
  const way = random.int(0, 2);
  if (way === 0) return bytes.slice(0, random.int(0, bytes.length));
  if (way === 1) {
    const longer = new Uint8Array(bytes.length + random.int(1, 300));
    longer.set(bytes);
    return longer;
  }
  const noisy = bytes.slice();
  for (let n = random.int(0, 4); n >= 0; n--)
    noisy[random.int(0, bytes.length - 1)] = random.pick([0, 1, 0x7f, 0x80, 0xff, random.int(0, 255)]);
  return noisy;
}
