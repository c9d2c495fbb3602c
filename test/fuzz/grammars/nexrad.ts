import { gzipSync } from 'node:zlib';
import { big, concat } from '../bytes.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';
import { bzip2, bzip2OfRuns } from './bzip2-writer.ts';

/** NEXRAD Level II: messages whose lengths and pointers lie, records that are empty, repeated or bombs. Source: ICD 2620002, 2620010 */
export const nexrad: Grammar = (random) => {
  const head = big()
    .text(random.or('AR2V0006.', 'ARCHIVE2.', 'AR2V9999.'))
    .text('736')
    .u32(random.size(18262))
    .u32(0)
    .text('KABC')
    .finish();
  const cuts = random.int(1, 3);
  const isOld = random.chance(0.3);
  const frames = [writePattern(random, cuts)];
  for (let cut = 1; cut <= cuts; cut++) {
    const radials = random.isHostile() ? random.pick([40, 150]) : random.int(1, 12);
    for (let i = 0; i < radials; i++)
      frames.push(
        (isOld ? writeMessage1 : writeMessage31)(random, {
          cut,
          i,
          radials,
          isLast: cut === cuts && i === radials - 1,
        }),
      );
  }
  const messages = random.shuffle(frames);
  // What packs them is slow.
  const isPacked = random.chance(0.5) && messages.reduce((sum, { length }) => sum + length, 0) < 16_000;
  const bytes = concat([head, ...(isPacked ? packRecords(random, messages) : messages)]);
  const whole = damage(random, bytes);
  return oneFile(
    random.or('KABC_V06', 'KABC.gz', 'scan'),
    random.chance(0.15) ? new Uint8Array(gzipSync(whole)) : whole,
  );
};

/** Records of messages; some hold nothing, come again and again, or hold far more than a radar's. */
function packRecords(random: Random, messages: readonly Uint8Array[]): Uint8Array[] {
  const split = random.int(1, messages.length);
  const sound = [messages.slice(0, split), messages.slice(split)]
    .filter((list) => list.length > 0)
    .map((list) => bzip2(concat(list), { level: random.or(9, 1), wrong: random.or(0, 1) }));
  const records = random.shuffle(sound);
  if (random.isWild())
    records.push(...Array.from({ length: random.pick([1, 100, 1000]) }, () => bzip2(new Uint8Array())));
  if (random.isWild()) records.push(bzip2OfRuns(random.int(1, 3), random.pick([10, 1000, 20_000])));
  return records.map((record, i) =>
    big()
      .u32(random.size(i === records.length - 1 ? 2 ** 32 - record.length : record.length))
      .put(record)
      .finish(),
  );
}

/** A message in front of it: 12 bytes of the line, and a header; all but radials of type 31 fill a frame. */
function frame(random: Random, type: number, body: Uint8Array): Uint8Array {
  const out = big()
    .zeros(12)
    .u16(random.size(Math.ceil((16 + body.length) / 2)) & 0xffff)
    .u8(0, random.or(type, 1, 31, 29, 5, 0))
    .u16(0, 18262)
    .u32(0)
    .u16(random.or(1, 0, 65535), random.or(1, 2))
    .put(body)
    .pad(2);
  return type === 31 ? out.finish() : out.zeros(Math.max(0, 2432 - out.length)).finish();
}

function writePattern(random: Random, cuts: number): Uint8Array {
  const out = big()
    .u16(0, 0, 0, random.size(cuts) & 0xffff)
    .zeros(14);
  for (let cut = 0; cut < cuts; cut++) out.u16(random.size(91 * (cut + 1)) & 0xffff).zeros(44);
  return frame(random, 5, out.finish());
}

interface Place {
  readonly cut: number;
  readonly i: number;
  readonly radials: number;
  readonly isLast: boolean;
}

function statusOf({ cut, i, isLast }: Place): number {
  if (isLast) return 4;
  return i > 0 ? 1 : cut === 1 ? 3 : 0;
}

function writeMessage1(random: Random, place: Place): Uint8Array {
  const gates = random.int(1, 40);
  const angle = (degrees: number): number => Math.round((degrees / 180) * 32768) & 0xffff;
  const out = big()
    .u32(random.size(1000))
    .u16(
      random.size(18262) & 0xffff,
      0,
      random.size(angle((360 * place.i) / place.radials)) & 0xffff,
      place.i,
      random.or(statusOf(place), 0, 3, 5, 99),
    );
  out
    .u16(angle(0.5 * place.cut), random.size(place.cut) & 0xffff)
    .u16(
      random.size(0) & 0xffff,
      0,
      random.size(1000) & 0xffff,
      random.size(250) & 0xffff,
      random.size(gates) & 0xffff,
      random.size(gates) & 0xffff,
    );
  out
    .zeros(6)
    .u16(
      random.size(100) & 0xffff,
      random.size(100 + gates) & 0xffff,
      random.size(100 + 2 * gates) & 0xffff,
      random.or(2, 4),
    )
    .zeros(16)
    .u16(random.size(2500) & 0xffff)
    .zeros(38);
  return frame(random, 1, out.put(random.bytes(3 * gates)).finish());
}

function writeMessage31(random: Random, place: Place): Uint8Array {
  const gates = place.i === 0 && random.isHostile() ? 60_000 : random.int(1, 60);
  const names = random.shuffle(['DREF', 'DVEL'].slice(0, random.int(1, 2)));
  const bits = random.or(8, 16, 1, 0);
  const moment = (name: string): Uint8Array =>
    big()
      .text(name)
      .u32(0)
      .u16(random.size(gates) & 0xffff, random.size(2125) & 0xffff, random.size(250) & 0xffff, 0, 0)
      .u8(0, bits)
      .f32(random.number(2), random.number(66))
      .put(random.bytes((gates * Math.max(8, bits)) / 8))
      .finish();
  const volume = big()
    .text('RVOL')
    .u16(44)
    .u8(1, 0)
    .f32(random.number(35), random.number(-97))
    .u16(random.size(300) & 0xffff, 20)
    .zeros(24)
    .finish();
  const radial = big()
    .text('RRAD')
    .u16(20, 0)
    .zeros(8)
    .u16(random.size(2500) & 0xffff, 0)
    .finish();
  const blocks = [volume, radial, ...names.map(moment)];
  const pointers: number[] = [];
  blocks.reduce((at, block) => (pointers.push(at), at + block.length), 32 + 4 * blocks.length);
  const count = random.isWild() ? random.pick([0, 1, 32, 33, 65535]) : blocks.length;
  const head = big()
    .text('KABC')
    .u32(random.size(1000))
    .u16(random.size(18262) & 0xffff, place.i)
    .f32(random.number((360 * place.i) / place.radials))
    .u8(random.or(0, 1), 0)
    .u16(0)
    .u8(1, random.or(statusOf(place), 0, 3, 5, 99), random.or(place.cut, 0, 255), 0)
    .f32(random.number(0.5 * place.cut))
    .u8(0, 0)
    .u16(count);
  return frame(
    random,
    31,
    head
      .u32(...pointers.map((at) => random.size(at)))
      .put(concat(blocks))
      .finish(),
  );
}
