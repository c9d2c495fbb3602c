import { maxFileSamplesBytes } from '../base/count-sample-bytes.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import type { FormatReader } from '../base/format.ts';
import { nameOf } from '../base/name-of.ts';
import { isZstd, unzstd } from '../codecs/unzstd.ts';

/** Reads the file that is packed in another one. The address of the packed file stays that of the other files that it may name. */
export const readZstd: FormatReader = async (input, settings, context) => {
  const bytes = unzstd(input.bytes, maxFileSamplesBytes, context.budget);
  context.budget.take(bytes.length, `the file in ${nameOf(input.url)}`);
  if (isZstd(bytes))
    throw unsupportedFile(nameOf(input.url), 'is packed with Zstandard more than once; unpack it: zstd -d file.zst');
  const url = input.url.replace(/\.zst(?=$|[?#])/i, '');
  return context.decode({ bytes, url, contentType: '' }, undefined, settings);
};
