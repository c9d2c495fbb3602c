import { deflateSync } from 'node:zlib';
import { big, concat, little } from '../bytes.ts';
import { oneFile } from '../fuzz-case.ts';
import type { FilesCase, FuzzCase } from '../fuzz-case.ts';
import { packChunk, pngSignature } from '../grammars/png.ts';

type Chunks = readonly (readonly [name: string, data: Uint8Array])[];

function pngOf(chunks: Chunks, settings: FilesCase['settings'] = { mosaic: { columns: 1, rows: 1 } }): FilesCase {
  return oneFile(
    'image.png',
    concat([
      big().text(pngSignature).finish(),
      ...[...chunks, ['IEND', new Uint8Array()] as const].map(([name, data]) => packChunk({ name, data })),
    ]),
    settings,
  );
}

const header = (width: number, height: number, depth = 8, color = 0): readonly [string, Uint8Array] => [
  'IHDR',
  big().u32(width, height).u8(depth, color, 0, 0, 0).finish(),
];

/** A zlib stream of zeros, which swells about a thousand times. */
const zeros = (megabytes: number): Uint8Array => deflateSync(new Uint8Array(megabytes * 2 ** 20), { level: 9 });

export const imageCases: Readonly<Record<string, () => FuzzCase>> = {
  'png: one pixel, whose data unpack to 150 MB': () => pngOf([header(1, 1), ['IDAT', zeros(150)]]),
  'png: a colour profile that unpacks to 150 MB': () =>
    pngOf([
      header(1, 1),
      ['iCCP', big().text('profile').u8(0, 0).put(zeros(150)).finish()],
      ['IDAT', deflateSync(new Uint8Array(2))],
    ]),
  'png: a second header asks for 16,384 x 16,384 pixels': () =>
    pngOf([header(1, 1), header(16384, 16384), ['IDAT', deflateSync(new Uint8Array(2))]]),
  'png: 16,384 x 16,384 pixels of 16 bits that are not there': () =>
    pngOf([header(16384, 8192, 16, 6), ['IDAT', deflateSync(new Uint8Array(2))]]),
  'png: a frame of an animation asks for 30,000 x 30,000 pixels': () =>
    pngOf([
      header(1, 1),
      ['acTL', big().u32(1, 0).finish()],
      ['fcTL', big().u32(0, 30_000, 30_000, 0, 0).u16(1, 1).u8(0, 0).finish()],
      ['IDAT', deflateSync(new Uint8Array(2))],
      [
        'fdAT',
        big()
          .u32(1)
          .put(deflateSync(new Uint8Array(2)))
          .finish(),
      ],
    ]),
  'jpeg: a header of 65,500 x 65,500 pixels': () =>
    oneFile(
      'image.jpg',
      big()
        .u8(0xff, 0xd8, 0xff, 0xc0)
        .u16(11)
        .u8(8)
        .u16(65_500, 65_500)
        .u8(1, 1, 0x11, 0, 0xff, 0xda)
        .u16(8)
        .u8(1, 1, 0, 0, 63, 0, 0xff, 0xd9)
        .finish(),
      { mosaic: { columns: 1, rows: 1 } },
    ),
  'webp: a header of 16,384 x 16,384 pixels': () =>
    oneFile(
      'image.webp',
      little().text('RIFF').u32(22).text('WEBPVP8L').u32(10).u8(0x2f).u32(0x0fffffff).zeros(5).finish(),
      { mosaic: { columns: 1, rows: 1 } },
    ),
};
