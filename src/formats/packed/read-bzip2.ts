import { maxFileSamplesBytes } from '../base/count-sample-bytes.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader } from '../base/format.ts';
import { nameOf } from '../base/name-of.ts';
import { bunzip2, isBzip2 } from '../codecs/bunzip2.ts';
import { Bunzip2Room } from '../codecs/bunzip2-room.ts';

/** Reads the file that is packed in another one. The address of the packed file stays that of the other files that it may name. */
export const readBzip2: FormatReader = async (input, settings, context) => {
  const room = new Bunzip2Room(context.budget);
  const bytes = bunzip2(input.bytes, maxFileSamplesBytes, room);
  room.release();
  context.budget.take(bytes.length, `the file in ${nameOf(input.url)}`);
  if (isBzip2(bytes))
    throw unsupportedFile(nameOf(input.url), 'is packed with bzip2 more than once; unpack it: bzip2 -d file.bz2');
  const url = input.url.replace(/\.bz2(?=$|[?#])/i, '');
  return context.decode({ bytes, url, contentType: '' }, undefined, settings);
};
