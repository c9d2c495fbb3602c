import { deflateSync } from 'node:zlib';
import { tiffBytes } from '../../helpers/tiff-bytes.ts';
import type { TiffEntry, TiffPageBytes } from '../../helpers/tiff-bytes.ts';
import { damage } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

/** TIFF, OME-TIFF and ImageJ: sizes, lists of pieces, descriptions and links of pages that lie. Source: TIFF 6.0 */
export const tiff: Grammar = (random) => {
  const [format, bits] = random.pick([
    [1, 8],
    [1, 1],
    [1, 4],
    [1, 16],
    [2, 16],
    [3, 32],
    [3, 16],
    [1, 64],
    [6, 64],
  ] as const);
  const [columns, rows] = [random.int(1, 20), random.int(1, 20)];
  const samples = random.or(1, 2, 3);
  const count = random.int(1, 6);
  const bytes = rows * Math.ceil((columns * samples * bits) / 8);
  const compression = random.or(1, 5, 8, 32773, 7, 50000, 34887);
  const isTiled = random.chance(0.3);
  const description = random.pick([null, null, ome, imageJ])?.(random, count) ?? null;
  const page = (i: number): TiffPageBytes => {
    const strip = pack(random, random.bytes(isTiled ? 16 * 16 * samples * (bits / 8) * 4 : bytes), compression);
    const entries: Record<number, TiffEntry> = {
      256: [4, random.size(columns)],
      257: [4, random.size(rows)],
      258: [3, ...Array.from({ length: samples }, () => random.or<number>(bits, 12, 0))],
      259: [3, compression],
      262: [3, random.or(1, 0, 2, 3, 6, 9)],
      277: [3, random.or(samples, 0, 9999)],
      278: [random.or(4, 3, 99, 12), random.or(rows, 1, 0, 2 ** 32 - 1)],
      284: [3, random.or(1, 2)],
      317: [3, random.or(1, 2, 3)],
      339: [3, random.or<number>(format, 4, 9)],
    };
    if (random.chance(0.2)) entries[320] = [3, ...Array.from({ length: random.or(768, 3) }, (_, n) => n)];
    if (random.isWild()) entries[254] = [4, random.int(0, 4)];
    if (random.isWild()) entries[279] = [4, random.size(strip.length)];
    if (random.isHostile()) entries[273] = [4, ...Array.from({ length: random.or(1, 3, 500) }, () => random.size(8))];
    if (i === 0 && description !== null) entries[270] = [2, description];
    if (isTiled) {
      const pieces = Math.ceil(columns / 16) * Math.ceil(rows / 16);
      entries[322] = [4, random.size(16)];
      entries[323] = [4, random.size(16)];
      entries[324] = [4, ...Array.from({ length: pieces }, () => random.size(8))];
      entries[325] = [4, ...Array.from({ length: pieces }, () => random.size(strip.length >> 2))];
    }
    const next = random.isHostile()
      ? random.pick([{ page: random.int(0, i) }, { address: random.size(8) }])
      : undefined;
    return { entries, strip, ...(next ? { next } : {}) };
  };
  const file = (): Uint8Array<ArrayBuffer> =>
    damage(
      random,
      tiffBytes(
        Array.from({ length: count }, (_, i) => page(i)),
        { isBig: random.chance(0.3), littleEndian: random.chance(0.6) },
      ),
    );
  const files = Array.from({ length: random.or(1, 2, 3) }, (_, i) => ({
    name: random.or(`${i}.tif`, `${i}`),
    bytes: file(),
  }));
  return { files, ...(files.length > 1 ? { stack: true as const } : {}) };
};

function pack(random: Random, bytes: Uint8Array<ArrayBuffer>, compression: number): Uint8Array {
  if (compression === 8)
    return new Uint8Array(deflateSync(random.isWild() ? new Uint8Array(random.pick([1e5, 2e7])) : bytes));
  if (compression !== 5) return bytes;
  // LZW that clears its table before each byte: codes of 9 bits.
  const codes = [...bytes.subarray(0, 400)].flatMap((byte) => [256, byte]);
  const bits = [...codes, random.or(257, 300, 256)].map((code) => code.toString(2).padStart(9, '0')).join('');
  return Uint8Array.from({ length: Math.ceil(bits.length / 8) }, (_, i) =>
    Number.parseInt(bits.slice(8 * i, 8 * i + 8).padEnd(8, '0'), 2),
  );
}

function ome(random: Random, count: number): string {
  const sizes = random.shuffle([count, 1, 1]).map((n) => random.size(n));
  const data = Array.from(
    { length: random.or(1, 0, count) },
    () =>
      `<TiffData IFD="${random.size(0)}" FirstZ="${random.size(0)}" FirstC="${random.size(0)}" FirstT="${random.size(0)}" PlaneCount="${random.size(count)}">${random.or('', '<UUID FileName="a">urn:uuid:b</UUID>')}</TiffData>`,
  ).join('');
  return (
    `${random.or('<?xml version="1.0"?>', '', '<!-- x -->')}<OME UUID="urn:uuid:a"><Image><Pixels DimensionOrder="${random.or('XYZCT', 'XYCTZ', 'XY', 'ZCT')}" ` +
    `SizeX="3" SizeY="2" SizeZ="${sizes[0]}" SizeC="${sizes[1]}" SizeT="${sizes[2]}" PhysicalSizeX="${random.number(0.5)}" PhysicalSizeY="${random.number(0.5)}" ` +
    `PhysicalSizeZ="${random.number(2)}" PhysicalSizeXUnit="${random.or('µm', 'pixel', 'nm')}" TimeIncrement="${random.number(1)}">` +
    `${'<Channel SamplesPerPixel="1"/>'.repeat(random.or(1, 0, 3))}${data}</Pixels></Image></OME>${random.or('', '<a>'.repeat(200))}`
  );
}

function imageJ(random: Random, count: number): string {
  return [
    'ImageJ=1.54f',
    `images=${random.size(count)}`,
    `slices=${random.size(count)}`,
    ...(random.isWild() ? [`channels=${random.size(1)}`, `frames=${random.size(1)}`] : []),
    `unit=${random.or('micron', '\\u00B5m', 'pixel')}`,
    `spacing=${random.number(1)}`,
    `min=${random.number(0)}`,
    `max=${random.number(9)}`,
  ].join('\n');
}
