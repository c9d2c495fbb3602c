import { big, concat, little } from '../bytes.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';
import type { DecodeSettings } from '../../../src/formats/base/decoded-volume.ts';

const settingsOf = (random: Random): DecodeSettings => ({
  mosaic: { columns: random.size(2), rows: random.size(2) },
  ...(random.chance(0.1) ? { channels: 'high-low' as const } : {}),
});

/** Segments of a JPEG up to its scan: sizes that lie, frames of every kind, twice, or after the scan. Source: ITU-T T.81, B.2 */
export const jpeg: Grammar = (random) => {
  const segment = (marker: number, data: Uint8Array): Uint8Array =>
    big()
      .u8(0xff, marker)
      .u16(random.size(data.length + 2) & 0xffff)
      .put(data)
      .finish();
  const side = (): number => random.size(random.pick([16, 64, 512])) & 0xffff;
  const frame = (): Uint8Array => {
    const count = random.or(3, 1, 0, 255);
    return segment(
      random.or(0xc0, 0xc1, 0xc2, 0xc3, 0xc9, 0xcf),
      big()
        .u8(random.or(8, 12))
        .u16(side(), side())
        .u8(count)
        .put(random.bytes(3 * Math.min(count, 4)))
        .finish(),
    );
  };
  const parts = random.shuffle([
    segment(0xe0, big().text('JFIF\0').u8(1, 1, 0).u16(1, 1).u8(0, 0).finish()),
    ...(random.chance(0.3)
      ? [segment(0xe1, big().text('Exif\0\0').put(random.bytes(40)).finish()), segment(0xfe, random.bytes(12))]
      : []),
    segment(0xdb, random.bytes(65)),
    frame(),
    segment(0xc4, random.bytes(30)),
    segment(0xda, random.bytes(10)),
    random.bytes(random.int(0, 400)),
    big().u8(0xff, 0xd9).finish(),
  ]);
  if (random.isWild()) parts.splice(random.int(0, parts.length), 0, frame());
  if (random.isWild()) parts.splice(random.int(0, parts.length), 0, new Uint8Array(random.int(1, 9)).fill(0xff));
  return oneFile(
    random.or('image.jpg', 'image'),
    damage(random, concat([big().u8(0xff, 0xd8).finish(), ...parts])),
    settingsOf(random),
  );
};

/** Chunks of a WebP: lossy, lossless, extended, animated; sizes that lie or contradict each other. Source: WebP container specification */
export const webp: Grammar = (random) => {
  const chunk = (name: string, data: Uint8Array): Uint8Array =>
    little().text(name).u32(random.size(data.length)).put(data).pad(2).finish();
  const u24 = (value: number): number[] => [value & 0xff, (value >> 8) & 0xff, (value >> 16) & 0xff];
  const side = (): number => random.size(random.pick([16, 64, 512]));
  const noise = random.bytes(random.int(0, 300));
  const lossy = (): Uint8Array =>
    chunk(
      'VP8 ',
      little()
        .u8(0x10, 0, 0, random.or(0x9d, 0), 0x01, 0x2a)
        .u16(side() & 0xffff, side() & 0xffff)
        .put(noise)
        .finish(),
    );
  const lossless = (): Uint8Array =>
    chunk(
      'VP8L',
      little()
        .u8(random.or(0x2f, 0))
        .u32((((side() - 1) & 0x3fff) | (((side() - 1) & 0x3fff) << 14)) >>> 0)
        .put(noise)
        .finish(),
    );
  const extended = chunk(
    'VP8X',
    little()
      .u8(random.or(0x10, 0x02, 0xff), 0, 0, 0, ...u24(side() - 1), ...u24(side() - 1))
      .finish(),
  );
  const animated = [
    chunk('ANIM', little().u32(0).u16(0).finish()),
    chunk(
      'ANMF',
      little()
        .u8(...u24(0), ...u24(0), ...u24(side() - 1), ...u24(side() - 1), ...u24(100), 0)
        .put(lossless())
        .finish(),
    ),
  ];
  const body = random.pick([
    [lossy()],
    [lossless()],
    [extended, lossless()],
    [extended, chunk('ALPH', noise), lossy()],
    [extended, ...animated],
    [extended, chunk('ICCP', noise), lossy()],
  ]);
  const chunks = concat(random.shuffle(body));
  const file = little()
    .text('RIFF')
    .u32(random.size(4 + chunks.length))
    .text('WEBP')
    .put(chunks)
    .finish();
  return oneFile(random.or('image.webp', 'image'), damage(random, file), settingsOf(random));
};
