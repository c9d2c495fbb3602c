import { VolumeViewError } from '../../core/errors.ts';
import type { DecodeInput } from '../base/decoded-volume.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import type { ReadContext } from '../base/format.ts';
import { nameOf } from '../base/name-of.ts';

/**
 * Fetches the other file of a pair, such as brain.img of brain.hdr: its name differs only in the ending. Each of the two
 * may be packed with gzip, which adds `.gz`.
 * @param what - for messages, such as 'an Analyze volume'
 * @param own - possible endings of the file that is there, without the dot
 * @param other - the ending of the other file
 * @throws {VolumeViewError} `source/not-found`, `format/unsupported`, and what fetching throws
 */
export async function fetchPartner(
  what: string,
  { url }: DecodeInput,
  [own, other]: readonly [own: string, other: string],
  { fetchFile, further }: Pick<ReadContext, 'fetchFile' | 'further'>,
): Promise<DecodeInput> {
  if (further.length === 1) return fetchFile(further[0]);
  if (further.length > 1)
    throw unsupportedFile(what, `has two files, and the stack has ${further.length + 1}; expected its two`);
  const [address, rest] = cutPath(url);
  const ending = new RegExp(`\\.(${own})(\\.gz)?$`, 'i').exec(address);
  if (!/^https?:/.test(url) || !ending)
    throw unsupportedFile(
      what,
      `has two files, and from ${nameOf(url)} the name of the other one is not known; expected names that end in .${own} and .${other}, or both files in a stack`,
    );
  const named = ending[1] === ending[1].toUpperCase() ? other.toUpperCase() : other;
  const stem = `${address.slice(0, ending.index)}.${named}`;
  const [first, second] = ending[2] ? [`${stem}.gz`, stem] : [stem, `${stem}.gz`];
  try {
    return await fetchFile(first + rest);
  } catch (cause) {
    if (!isMissing(cause)) throw cause;
  }
  try {
    return await fetchFile(second + rest);
  } catch (cause) {
    if (!isMissing(cause)) throw cause;
    throw new VolumeViewError(
      'source/not-found',
      `${readName(url)} is one of the two files of ${what}, and the other is missing: neither ${readName(first)} nor ${readName(second)} was found. Put both into one folder, or choose both`,
      { cause },
    );
  }
}

/** A name without the percent signs of URLs: AFNI's names have a "+". */
function readName(url: string): string {
  try {
    return decodeURIComponent(nameOf(url));
  } catch {
    return nameOf(url);
  }
}

/** The URL up to the end of its path, and what follows. */
function cutPath(url: string): [string, string] {
  const at = url.search(/[?#]/);
  return at < 0 ? [url, ''] : [url.slice(0, at), url.slice(at)];
}

const isMissing = (cause: unknown): boolean => cause instanceof VolumeViewError && cause.code === 'source/not-found';
