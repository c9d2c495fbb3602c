import { deflateSync } from 'node:zlib';
import { big, concat, crc32 } from '../bytes.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

interface Chunk {
  readonly name: string;
  readonly data: Uint8Array;
}

export const pngSignature = '\x89PNG\r\n\x1a\n';

/** A chunk with the checksum that belongs to it, or another one. */
export function packChunk({ name, data }: Chunk, wrong = 0): Uint8Array<ArrayBuffer> {
  const body = big().text(name).put(data).finish();
  return big()
    .u32(data.length)
    .put(body)
    .u32(crc32(body) + wrong)
    .finish();
}

/** PNG: chunks in another order, twice, or not at all, with right checksums; sizes that lie; streams that swell. Source: W3C, PNG 3 */
export const png: Grammar = (random) => {
  const color = random.pick([0, 0, 2, 3, 4, 6]);
  const depth = random.or(
    color === 0 || color === 3 ? random.pick([8, 8, 16, 4, 2, 1].slice(color === 3 ? 3 : 0)) : random.pick([8, 16]),
    0,
    1,
    32,
    255,
  );
  const [width, height] = [random.int(1, 24), random.int(1, 24)];
  const header = writeHeader(random, { width, height, depth, color });
  const packed = packRows(random, { width, height, depth, color });
  const cut = random.int(0, packed.length);
  const palette: Chunk = { name: 'PLTE', data: random.bytes(random.size(3 * 2 ** Math.min(8, depth)) % 4096) };
  const chunks = random.shuffle<Chunk>([
    { name: 'IHDR', data: header },
    ...(color === 3 ? [palette] : []),
    ...listOthers(random),
    { name: 'IDAT', data: packed.subarray(0, cut) },
    { name: 'IDAT', data: packed.subarray(cut) },
    { name: 'IEND', data: new Uint8Array() },
  ]);
  // A second header says something else.
  if (random.isWild())
    chunks.splice(random.int(1, chunks.length), 0, {
      name: 'IHDR',
      data: writeHeader(random, { width: random.size(4096), height: random.size(4096), depth, color }),
    });
  const file = concat([big().text(pngSignature).finish(), ...chunks.map((chunk) => packChunk(chunk, random.or(0, 1)))]);
  const tiles = [1, 2, 3, 4].filter((n) => width % n === 0);
  return oneFile(random.or('image.png', 'image'), damage(random, file), {
    mosaic: { columns: random.size(random.pick(tiles)), rows: random.size(1) },
    ...(random.chance(0.1) ? { channels: 'high-low' as const } : {}),
    ...(random.chance(0.2)
      ? { spherical: true, elevations: [random.number(0.5)], range: [random.number(250), random.number(500)] as const }
      : {}),
    ...(random.isWild()
      ? { slices: random.size(1), spacing: [random.number(1), random.number(1), random.number(1)] as const }
      : {}),
  });
};

interface Picture {
  readonly width: number;
  readonly height: number;
  readonly depth: number;
  readonly color: number;
}

function writeHeader(random: Random, { width, height, depth, color }: Picture): Uint8Array {
  return big()
    .u32(random.size(width), random.size(height))
    .u8(depth, random.or(color, 1, 5, 7), random.or(0, 1), random.or(0, 1), random.or(0, 1, 2))
    .finish();
}

/** Rows of noise, or of nothing: those swell. */
function packRows(random: Random, { width, height, depth, color }: Picture): Uint8Array {
  const channels = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 }[color] ?? 1;
  const rowBytes = 1 + Math.ceil((width * channels * Math.min(depth, 16)) / 8);
  const rows = random.chance(0.3) ? new Uint8Array(rowBytes * height) : random.bytes(rowBytes * height);
  for (let row = 0; row < height; row++) rows[row * rowBytes] = random.or(0, 1, 2, 3, 4, 5, 255);
  const extra = random.isWild() ? random.pick([1, 1000, 1e6, 2e7]) : 0;
  return deflateSync(extra > 0 ? concat([rows, new Uint8Array(extra)]) : rows);
}

function listOthers(random: Random): Chunk[] {
  const swell = (): Uint8Array => deflateSync(new Uint8Array(random.isWild() ? random.pick([1e6, 3e7]) : 100));
  const others: Chunk[] = [
    { name: 'iCCP', data: big().text('profile').u8(0, 0).put(swell()).finish() },
    { name: 'zTXt', data: big().text('Comment').u8(0, 0).put(swell()).finish() },
    { name: 'iTXt', data: big().text('Comment').u8(0, 1, 0, 0, 0).put(swell()).finish() },
    { name: 'tEXt', data: big().text('Comment\0words').finish() },
    { name: 'tRNS', data: random.bytes(random.int(0, 6)) },
    { name: 'pHYs', data: big().u32(random.size(1), random.size(1)).u8(1).finish() },
    { name: 'acTL', data: big().u32(random.size(2), random.size(0)).finish() },
    {
      name: 'fcTL',
      data: big()
        .u32(0, random.size(4), random.size(4), random.size(0), random.size(0))
        .u16(1, 1)
        .u8(random.or(0, 3), random.or(0, 2))
        .finish(),
    },
    {
      name: 'fdAT',
      data: big()
        .u32(1)
        .put(deflateSync(random.bytes(16)))
        .finish(),
    },
    { name: random.or('vpAg', 'IDAT', 'aaaa', '\0\0\0\0'), data: random.bytes(4) },
  ];
  return random.chance(0.5) ? [] : others.filter(() => random.chance(0.2));
}
