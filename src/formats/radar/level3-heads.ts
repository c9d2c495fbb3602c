// The heads of products of NEXRAD Level III: which radar and which scan they are of.
import type { DecodeInput } from '../base/decoded-volume.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import { keptBytes } from '../base/format.ts';
import type { ReadContext } from '../base/format.ts';
import { readAhead } from '../base/read-ahead.ts';
import { gunzip, isGzip } from '../codecs/gunzip.ts';
import { isoTime } from './cf-time.ts';
import { findLevel3, readLevel3Message } from './level3-message.ts';
import type { Level3Message } from './level3-message.ts';
import { level3Products, listProducts } from './level3-products.ts';

/** A product as its head describes it. */
export interface Product {
  readonly message: Level3Message;
  readonly moment: string;
  readonly url: string;
  /** The whole file where it can't be read later. */
  readonly bytes: Uint8Array<ArrayBuffer> | null;
}

/** The products of one scan. */
export interface Scan {
  readonly time: string | null;
  readonly products: readonly Product[];
}

export const codeOf = ({ message }: Product): number => message.code;

/** The heads of all products, and how many other files there are. */
export interface Heads {
  readonly products: readonly Product[];
  readonly others: number;
}

export async function readHeads(
  input: DecodeInput,
  urls: readonly string[],
  { folder, fetchFiles, further }: ReadContext,
): Promise<Heads> {
  const products: Product[] = [];
  let others = 0;
  const take = async ({ bytes }: DecodeInput, url: string, isWhole: boolean): Promise<void> => {
    const plain = isGzip(bytes) ? await firstPiece(bytes) : bytes;
    const message = findLevel3(plain) < 0 ? null : readLevel3Message(plain);
    const product = message && level3Products.get(message.code);
    if (product) products.push({ message, moment: product.name, url, bytes: isWhole ? bytes : null });
    else others++;
  };
  if (folder) {
    let at = 0;
    for await (const start of readAhead(urls, (url) => folder.readStart(url, keptBytes))) {
      if (start.status === 'rejected') throw start.reason;
      await take(start.value, urls[at++], false);
    }
  } else {
    await take(input, input.url, true);
    let at = 0;
    for await (const file of fetchFiles(further)) await take(file, further[at++], true);
  }
  return { products, others };
}

/** The first bytes of a packed file; none if it is damaged. */
async function firstPiece(packed: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  try {
    for await (const piece of gunzip(packed)) return piece;
  } catch {
    // Only its start may be here, and it may be damaged.
  }
  return new Uint8Array();
}

/** Where a radar is. */
const placeOf = ({ message: { latitude, longitude } }: Product): string => `${latitude} ${longitude}`;

/**
 * The products of the radar that most files are from.
 * @returns and what of the others is said, in words
 * @throws {VolumeViewError} `format/unsupported` where there is none
 */
export function chooseRadar({ products: all, others }: Heads): {
  readonly products: Product[];
  readonly left: string[];
} {
  if (all.length === 0)
    throw unsupportedFile(
      `the ${others} files of NEXRAD Level III`,
      `hold no product that is a sweep of one elevation; expected products ${listProducts()}. NOAA's Weather and Climate Toolkit shows other products, and converts them`,
    );
  const left = others > 0 ? [`${count(others, 'file')} without a sweep of one elevation that is known here`] : [];
  const place = mostOf(all.map(placeOf));
  const products = all.filter((product) => placeOf(product) === place);
  if (products.length < all.length) left.push(`${count(all.length - products.length, 'file')} of another radar`);
  return { products, left };
}

/** Products whose scan of the volume began at the same time, in the order of time. */
export function groupScans(products: readonly Product[]): Scan[] {
  const byTime = new Map<number, Product[]>();
  for (const product of products) {
    const { time } = product.message;
    const scan = byTime.get(time);
    if (scan) scan.push(product);
    else byTime.set(time, [product]);
  }
  const scans = [...byTime];
  scans.sort(([a], [b]) => a - b);
  return scans.map(([time, products]) => ({ time: isoTime(time) ?? null, products }));
}

/** What occurs most often; among equals the first. */
export function mostOf<T>(all: readonly T[]): T | undefined {
  const counts = new Map<T, number>();
  for (const one of all) counts.set(one, (counts.get(one) ?? 0) + 1);
  return [...counts].reduce<[T | undefined, number]>((best, one) => (one[1] > best[1] ? one : best), [undefined, 0])[0];
}

/** For messages: '1 file', '2 files'. */
export const count = (n: number, noun: string): string => `${n} ${noun}${n === 1 ? '' : 's'}`;
