import type { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { startsWith } from '../base/starts-with.ts';
import { DeflateError, Inflater } from '../codecs/inflate.ts';
import { preambleBytes } from './is-dicom.ts';
import { readElements, readFileMeta } from './read-elements.ts';
import type { Elements } from './read-elements.ts';
import { tags } from './tags.ts';
import { readSyntax } from './transfer-syntax.ts';
import type { TransferSyntax } from './transfer-syntax.ts';
import { joinPieces } from '../base/join-pieces.ts';

/** What is read of a file. */
export interface DicomFile extends Elements {
  readonly syntax: TransferSyntax;
  /** Its bytes, as far as they were read. */
  readonly file: Uint8Array<ArrayBuffer>;
}

/**
 * Finds the elements of a DICOM file: with the preamble of PS3.10 or, as old programs write them, without.
 * @param what - for messages: 'file 12 of 300'
 * @param missing - bytes of the file after these
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export function readDicomFile(bytes: Uint8Array<ArrayBuffer>, budget: Budget, what: string, missing = 0): DicomFile {
  const hasPreamble = startsWith(bytes.subarray(preambleBytes, preambleBytes + 4), 'DICM');
  const { set: meta, end } = readFileMeta(bytes, hasPreamble ? preambleBytes + 4 : 0, budget, what);
  const uid = meta.text(tags.transferSyntax);
  const syntax = readSyntax(uid);
  if (syntax.packing === 'unknown')
    throw unsupportedFile(
      what,
      'is written in a way that is not in the DICOM standard (its transfer syntax is unknown); convert it: gdcmconv --raw in.dcm out.dcm',
    );
  const littleEndian = !syntax.isBigEndian;
  const body = syntax.isDeflated ? inflate(bytes, end, budget, what) : bytes;
  const start = syntax.isDeflated ? 0 : end;
  // Whether representations are explicit is seen at the first element: some files say the other one.
  const isExplicit = /^[A-Z]{2}$/.test(String.fromCharCode(...body.subarray(start + 4, start + 6)));
  return { ...readElements(body, start, { isExplicit, littleEndian, budget, what, missing }), syntax, file: bytes };
}

/** The data set of a deflated file: a stream without a header (PS3.5, A.5). */
function inflate(bytes: Uint8Array<ArrayBuffer>, start: number, budget: Budget, what: string): Uint8Array<ArrayBuffer> {
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  try {
    for (const piece of new Inflater().unpack(bytes, start)) {
      budget.take(2 * piece.length, what); // The pieces, and all of them together.
      pieces.push(piece);
      size += piece.length;
    }
  } catch (cause) {
    if (cause instanceof DeflateError)
      throw corruptFile(what, `has packed data that ${cause.isCut ? 'end early' : 'are damaged'}; copy the file again`);
    throw cause;
  }
  const all = joinPieces(pieces);
  budget.giveBack(size);
  return all;
}
