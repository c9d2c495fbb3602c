import { gzipSync } from 'node:zlib';
import { ByteWriter, concat } from '../bytes.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

/** Bytes of a sample by NIfTI's code. */
const types: readonly (readonly [code: number, bytes: number])[] = [
  [2, 1],
  [4, 2],
  [8, 4],
  [16, 4],
  [64, 8],
  [256, 1],
  [512, 2],
  [768, 4],
  [1024, 8],
  [1280, 8],
  [32, 8],
  [1792, 16],
  [1536, 16],
  [2048, 32],
];

/** NIfTI-1 and -2, in both byte orders, packed or not: sizes, offsets, types and geometry that lie. Sources: nifti1.h, nifti2.h */
export const nifti: Grammar = (random) => {
  const version = random.pick([1, 2]);
  const out = new ByteWriter(random.chance(0.7));
  const [code, bytes] = random.pick(types);
  const size = [random.int(1, 9), random.int(1, 9), random.int(1, 9), random.or(1, 2, 5)];
  const field = { size, code: random.or(code, 0, 1, 128, 2304, 9999), bytes };
  (version === 1 ? writeVersion1 : writeVersion2)(random, out, field);
  const samples = random.isWild()
    ? new Uint8Array(bytes * size.reduce((product, n) => product * n, 1))
    : random.bytes(bytes * size.reduce((product, n) => product * n, 1));
  const whole = damage(random, concat([out.finish(), samples]));
  const packed = random.chance(0.4);
  const file = packed
    ? new Uint8Array(gzipSync(random.isWild() ? concat([whole, new Uint8Array(random.pick([1e5, 2e7]))]) : whole))
    : whole;
  const members = packed && random.isWild() ? concat([file, file]) : file;
  return oneFile(
    packed ? random.or('a.nii.gz', 'a.gz', 'a') : random.or('a.nii', 'a'),
    packed ? damage(random, members) : members,
    random.isWild() ? { spacing: [random.number(1), random.number(1), random.number(1)] } : {},
  );
};

interface Field {
  readonly size: readonly number[];
  readonly code: number;
  readonly bytes: number;
}

const magic = (random: Random, version: number): string =>
  random.or(version === 1 ? 'n+1\0' : 'n+2\0\r\n\x1a\n', version === 1 ? 'ni1\0' : 'ni2\0\r\n\x1a\n', '\0\0\0\0');

function writeVersion1(random: Random, out: ByteWriter, { size, code, bytes }: Field): void {
  const short = (sound: number): number => random.size(sound) & 0xffff;
  out.u32(random.or(348, 540)).zeros(36);
  out
    .u16(random.or(4, 0, 3, 7, 8, 65535), ...size.map(short), 1, 1, 1)
    .zeros(14)
    .u16(code, short(8 * bytes), 0);
  out
    .f32(random.or(1, -1, 0), ...size.slice(0, 3).map(() => random.number(1.5)), 1, 1, 1, 1)
    .f32(random.isWild() ? random.size(352) : 352)
    .f32(random.number(1), random.number(0));
  out
    .u16(0)
    .u8(0, random.or(2, 1, 3, 255))
    .f32(random.number(100), random.number(0))
    .zeros(252 - out.length);
  out.u16(random.or(1, 0, 2), random.or(1, 0, 4)).f32(...Array.from({ length: 6 }, () => random.number(0)));
  out
    .f32(...affine(random))
    .zeros(16)
    .text(magic(random, 1).slice(0, 4))
    .u8(random.or(0, 1, 255), 0, 0, 0);
}

function writeVersion2(random: Random, out: ByteWriter, { size, code, bytes }: Field): void {
  out
    .u32(random.or(540, 348))
    .text(magic(random, 2).padEnd(8, '\0'))
    .u16(code, random.size(8 * bytes) & 0xffff);
  out.u64(random.or(4, 0, 3, 7, 8, 2 ** 63), ...size.map((n) => random.size(n)), 1, 1, 1).zeros(104 - out.length);
  out
    .f64(random.or(1, -1, 0), ...size.slice(0, 3).map(() => random.number(1.5)), 1, 1, 1, 1)
    .u64(random.size(544))
    .f64(random.number(1), random.number(0), random.number(100), random.number(0))
    .zeros(344 - out.length);
  out.u32(random.or(1, 0, 2), random.or(1, 0, 4)).f64(...Array.from({ length: 6 }, () => random.number(0)));
  out
    .f64(...affine(random))
    .zeros(500 - out.length)
    .u32(random.or(2, 1, 3, 2 ** 31))
    .zeros(544 - out.length);
}

const affine = (random: Random): number[] =>
  [1.5, 0, 0, -5, 0, 1.5, 0, -5, 0, 0, 2, -5].map((entry) => random.number(entry));
