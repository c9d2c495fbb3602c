import { concat, little } from '../bytes.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

/** Zstandard: headers, kinds and sizes of blocks that lie, and blocks whose codes are noise. Source: RFC 8878 */
export const zstd: Grammar = (random) => {
  const frames = Array.from({ length: random.or(1, 0, 2, 400) }, () => frame(random));
  return oneFile(random.or('a.npy.zst', 'a'), damage(random, concat(frames)));
};

/** An array of NumPy, in blocks. */
function frame(random: Random): Uint8Array<ArrayBuffer> {
  const text = "{'descr': '|u1', 'fortran_order': False, 'shape': (4, 5, 6), }\n";
  const content = little().text('\x93NUMPY').u8(1, 0).u16(text.length).text(text).zeros(120).finish();
  const out = little();
  const isSingle = random.chance(0.6);
  const hasChecksum = random.isWild();
  out.u32(0xfd2fb528).u8((isSingle ? 0xa0 : 0x80) | (hasChecksum ? 4 : 0) | random.or(0, 1, 8));
  if (!isSingle) out.u8(random.or(0x40, 0, 0xff, 0x88));
  const cut = random.int(0, content.length);
  const parts = [content.subarray(0, cut), content.subarray(cut)];
  out.u32(random.size(content.length) % 2 ** 32);
  const head = (kind: number, size: number, isLast: boolean): void => {
    const value = ((size & 0x1fffff) << 3) | (kind << 1) | (isLast ? 1 : 0);
    out.u8(value & 0xff, (value >> 8) & 0xff, value >> 16);
  };
  parts.forEach((part, i) => {
    if (random.isWild()) {
      const block = noisyBlock(random);
      head(2, random.size(block.length), false);
      out.put(block);
    }
    if (random.isHostile())
      for (let n = random.or(1, 1000, 20_000); n > 0; n--) {
        head(1, 2 ** 17, false);
        out.u8(0);
      }
    head(random.or(0, 1, 2, 3), random.size(part.length), i === 1);
    out.put(part);
  });
  if (hasChecksum) out.u32(random.u32());
  if (random.isWild()) out.u32(0x184d2a50, random.size(3)).text('abc');
  return out.finish();
}

/** Literals as they are, then sequences of given or noisy codes. */
function noisyBlock(random: Random): Uint8Array<ArrayBuffer> {
  const out = little();
  const count = random.int(0, 31);
  const kind = random.pick([0, 0, 1, 2, 3]);
  out.u8((count << 3) | kind).put(random.bytes(kind === 1 ? 1 : count));
  if (random.chance(0.5)) out.u8(random.int(0, 127));
  else out.u8(255).u16(random.int(0, 0xffff));
  out.u8(random.pick([0, 0x54, 0xa8, 0xfc, random.int(0, 255)]));
  if (random.chance(0.5)) out.u8(random.int(0, 35), random.int(0, 31), random.int(0, 52));
  return out
    .put(random.bytes(random.or(40, 0, 5000)))
    .u8(random.or(0xff, 1, 0))
    .finish();
}
