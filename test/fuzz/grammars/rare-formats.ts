import { gzipSync } from 'node:zlib';
import { big, concat, little } from '../bytes.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import type { FilesCase, Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

/** A file that may be packed with gzip, and then may swell. */
function mayPack(random: Random, whole: Uint8Array<ArrayBuffer>, [plain, packed]: readonly [string, string]): FilesCase {
  const bytes = damage(random, whole);
  if (!random.chance(0.4)) return oneFile(random.or(plain, 'a'), bytes);
  const swollen = random.isWild() ? concat([bytes, new Uint8Array(random.pick([1e5, 2e7]))]) : bytes;
  return oneFile(random.or(packed, 'a.gz', 'a'), damage(random, new Uint8Array(gzipSync(swollen))));
}

const product = (sizes: readonly number[]): number => sizes.reduce((all, n) => all * n, 1);

/** MGH and MGZ: sizes, types and places that lie. Source: FreeSurfer wiki, FsTutorial/MghFormat */
export const mgh: Grammar = (random) => {
  const [code, bytes] = random.pick([
    [0, 1],
    [1, 4],
    [3, 4],
    [4, 2],
    [10, 2],
  ] as const);
  const size = [random.int(1, 9), random.int(1, 9), random.int(1, 9), random.or(1, 2, 5)];
  const out = big().u32(random.or(1, 0x201, 2), ...size.map((n) => random.size(n)), random.or<number>(code, 2, 5, 9, 99));
  out.u32(random.size(0)).u16(random.or(1, 0, 0xffff));
  out.f32(...[1, 1.5, 2, -1, 0, 0, 0, 0, -1, 0, 1, 0, 5, 6, 7].map((entry) => random.number(entry)));
  out.zeros(284 - out.length).put(random.bytes(bytes * product(size)));
  return mayPack(random, concat([out.finish(), random.chance(0.3) ? random.bytes(20) : new Uint8Array()]), [
    'a.mgh',
    'a.mgz',
  ]);
};

/** Analyze and NIfTI pairs: a header that lies, samples in another file or not there. Sources: nifti1.h, Mayo's dbh.h */
export const analyze: Grammar = (random) => {
  const [code, bytes] = random.pick([
    [2, 1],
    [4, 2],
    [8, 4],
    [16, 4],
    [32, 8],
    [64, 8],
    [132, 2],
  ] as const);
  const size = [random.int(1, 9), random.int(1, 9), random.int(1, 9), random.or(1, 2, 5)];
  const short = (sound: number): number => random.size(sound) & 0xffff;
  const out = random.chance(0.7) ? little() : big();
  out.u32(random.or(348, 540)).zeros(36).u16(random.or(4, 0, 3, 8), ...size.map(short), 1, 1, 1).zeros(14);
  out.u16(random.or<number>(code, 0, 1, 128, 9999), short(8 * bytes), 0);
  out.f32(random.or(1, 0), ...[1, 1.5, 2, 1, 1, 1, 1].map((entry) => random.number(entry)));
  out.f32(random.isWild() ? random.size(0) : 0, random.number(random.pick([0, 1])), random.number(0)).zeros(4);
  out.f32(random.number(random.pick([0, 100])), random.number(0)).zeros(8).u32(random.size(1000), random.size(0));
  out.zeros(252 - out.length).u8(random.or(0, 1, 5, 200));
  for (let axis = 0; axis < 3; axis++) out.u16(short(random.pick([0, 2])));
  out.zeros(344 - out.length).text(random.pick(['\0\0\0\0', '\0\0\0\0', 'ni1\0']));
  const header = { name: random.or('a.hdr', 'a'), bytes: damage(random, out.finish()) };
  const samples = { name: random.or('a.img', 'a.img.gz', 'b.img'), bytes: damage(random, random.bytes(bytes * product(size))) };
  const files = random.chance(0.5) ? [header, samples] : [samples, header];
  return { files, ...(random.isWild() ? { stack: true as const } : {}) };
};
