import { big, concat, latin1 } from '../bytes.ts';
import { damage } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

/**
 * Videos that a manifest names: WebM and MP4 with sizes, counts, places and times that lie, elements that are in each other, twice, missing or
 * without an end, other codecs, and frames of another size. Source: RFC 8794 and 9559; ISO/IEC 14496-12
 */
export const video: Grammar = (random) => {
  const [columns, rows] = [random.int(1, 3), random.int(1, 3)];
  const size = { width: columns * random.int(2, 8), height: rows * random.int(2, 8) };
  const count = random.isHostile() ? random.pick([300, 3000, 11_000]) : random.int(1, 8);
  const frames = Array.from({ length: count }, (_, i) => packFrame(random, size, i === 0 || random.chance(0.2)));
  const isWebm = random.chance(0.5);
  const file = isWebm ? writeWebm(random, size, frames) : writeMp4(random, size, frames);
  const name = random.or(isWebm ? 'scans.webm' : 'scans.mp4', 'scans', 'scans.avi');
  const common = {
    mosaic: `${random.size(columns)}x${random.size(rows)}`,
    slope: random.number(0.5),
    intercept: random.number(-32),
    ...(random.chance(0.3) ? { noDataBelow: random.or(12, -1, 300, 1e9) } : {}),
    ...(random.chance(0.2)
      ? {
          elevations: Array.from({ length: columns * rows }, (_, i) => random.number(0.5 + i)),
          range: [random.number(250), random.number(500)],
        }
      : {}),
    ...(random.chance(0.2) ? { lossy: { rms: random.number(0.5), p99: random.number(2), max: random.number(9) } } : {}),
  };
  const scans = Array.from({ length: Math.min(2000, random.size(count)) }, () => ({}));
  const manifest = {
    video: random.or(name, '', '../x', 'other.webm'),
    ...common,
    ...(random.chance(0.3) ? { scans } : {}),
  };
  return {
    times: true,
    files: [
      { name: 'scans.json', bytes: latin1(JSON.stringify(manifest)) },
      { name, bytes: damage(random, file) },
    ],
  };
};

interface Size {
  readonly width: number;
  readonly height: number;
}

interface Frame {
  readonly bytes: Uint8Array;
  readonly isKey: boolean;
}

/** The start of a frame of VP9, with its size where it can be decoded by itself. Source: VP9 bitstream specification 0.6, 6.2 */
function packFrame(random: Random, { width, height }: Size, isKey: boolean): Frame {
  const rest = random.bytes(random.int(0, 12));
  if (!isKey) return { bytes: concat([Uint8Array.of(0x86), rest]), isKey };
  const [w, h] = [width, height].map((n) => (random.size(n) - 1) & 0xffff);
  // Four bits of colours come first, so that nothing lies at the start of a byte.
  const bits = [2, w >> 12, (w >> 8) & 15, (w >> 4) & 15, w & 15, h >> 12, (h >> 8) & 15, (h >> 4) & 15, h & 15, 0];
  const packed = Array.from({ length: 5 }, (_, i) => (bits[2 * i] << 4) | bits[2 * i + 1]);
  return { bytes: concat([Uint8Array.of(0x82, 0x49, 0x83, 0x42, ...packed), rest]), isKey };
}

/** An element of EBML. Its length may be unknown, wrong, or written in more bytes than it needs. */
function element(random: Random, id: number, body: Uint8Array): Uint8Array {
  const name = big();
  for (let shift = 24; shift >= 0; shift -= 8) if (id >= 2 ** shift) name.u8((id >>> shift) & 0xff);
  return concat([name.finish(), writeLength(random, random.size(body.length)), body]);
}

function writeLength(random: Random, length: number): Uint8Array {
  if (random.isWild())
    return Uint8Array.of(...random.pick([[0xff], [0x01, 255, 255, 255, 255, 255, 255, 255], [0], [0x40]]));
  const bytes = random.or(8, 1, 2, 4);
  const out = new Uint8Array(bytes);
  for (let i = bytes - 1, rest = length; i >= 0; i--, rest = Math.floor(rest / 256)) out[i] = rest % 256;
  out[0] |= 1 << (8 - bytes);
  return out;
}

const number = (random: Random, id: number, value: number): Uint8Array =>
  element(random, id, big().u64(random.size(value)).finish());
const text = (random: Random, id: number, value: string): Uint8Array => element(random, id, latin1(value));

function writeWebm(random: Random, { width, height }: Size, frames: readonly Frame[]): Uint8Array<ArrayBuffer> {
  const of = (id: number, ...parts: readonly Uint8Array[]): Uint8Array =>
    element(random, id, concat(random.shuffle(parts)));
  const head = of(
    0x1a45dfa3,
    number(random, 0x4286, 1),
    number(random, 0x42f7, 1),
    number(random, 0x42f2, 4),
    number(random, 0x42f3, 8),
    text(random, 0x4282, random.or('webm', 'matroska', 'x')),
    number(random, 0x4287, 4),
    number(random, 0x4285, 2),
  );
  const codec = random.or('V_VP9', 'V_AV1', 'V_VP8', 'V_MPEG4/ISO/AVC', 'A_OPUS', 'V_MJPEG', '');
  const track = of(
    0xae,
    number(random, 0xd7, 1),
    number(random, 0x73c5, 1),
    number(random, 0x83, random.or(1, 2, 17)),
    text(random, 0x86, codec),
    ...(random.isWild() ? [element(random, 0x63a2, random.bytes(random.int(0, 40)))] : []),
    of(
      0xe0,
      number(random, 0xb0, width),
      number(random, 0xba, height),
      of(0x55b0, number(random, 0x55b1, 1), number(random, 0x55b9, random.or(2, 0, 1))),
    ),
  );
  const clusters: Uint8Array[] = [];
  const perCluster = random.pick([1, 4, 1000]);
  for (let first = 0; first < frames.length; first += perCluster) {
    const blocks = frames.slice(first, first + perCluster).map(({ bytes, isKey }, i) => {
      // Track, time since the cluster, flags: some frames come in groups, and some are laced.
      const flags = (isKey ? 0x80 : 0) | random.or(0, 0x02, 0x04, 0x06, 0x08);
      const block = concat([
        Uint8Array.of(random.or(0x81, 0x82, 0)),
        big()
          .u16(random.size(i) & 0xffff)
          .u8(flags)
          .finish(),
        bytes,
      ]);
      if (!random.isWild()) return element(random, 0xa3, block);
      return of(0xa0, element(random, 0xa1, block), number(random, 0x9b, 1));
    });
    clusters.push(of(0x1f43b675, number(random, 0xe7, first), ...blocks));
  }
  const parts = [
    of(0x1549a966, number(random, 0x2ad7b1, 1_000_000)),
    of(0x1654ae6b, ...(random.isHostile() ? Array.from({ length: 200 }, () => track) : [track])),
    ...clusters,
    // Places of other elements, which may lead to themselves.
    ...(random.chance(0.3) || random.isWild()
      ? [
          of(
            0x114d9b74,
            of(0x4dbb, element(random, 0x53ab, Uint8Array.of(0x11, 0x4d, 0x9b, 0x74)), number(random, 0x53ac, 0)),
          ),
        ]
      : []),
    ...(random.chance(0.3)
      ? [of(0x1c53bb6b, of(0xbb, number(random, 0xb3, 0), of(0xb7, number(random, 0xf7, 1), number(random, 0xf1, 50))))]
      : []),
    ...(random.isWild() ? [element(random, 0xec, new Uint8Array(random.int(0, 400)))] : []),
  ];
  const inner = random.isWild() ? [element(random, 0x18538067, concat(parts))] : random.shuffle(parts);
  const file = concat([head, element(random, 0x18538067, concat(inner))]);
  // A segment in a segment in a segment.
  return new Uint8Array(random.isHostile() ? nest(random, file, 200) : file);
}

function nest(random: Random, bytes: Uint8Array, times: number): Uint8Array {
  let all = bytes;
  for (let i = 0; i < times; i++) all = element(random, 0x18538067, all);
  return all;
}

/** A box of MP4. */
function box(random: Random, name: string, ...parts: readonly Uint8Array[]): Uint8Array {
  const body = concat(parts);
  if (random.isWild())
    return concat([
      big()
        .u32(1)
        .text(name)
        .u64(random.size(body.length + 16))
        .finish(),
      body,
    ]);
  return concat([
    big()
      .u32(random.size(body.length + 8))
      .text(name)
      .finish(),
    body,
  ]);
}

/** A box with version and flags. */
const full = (random: Random, name: string, ...parts: readonly Uint8Array[]): Uint8Array =>
  box(
    random,
    name,
    big()
      .u32(random.or(0, 0x01000000, 0x00ffffff))
      .finish(),
    ...parts,
  );

const matrix = big().u32(0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000).finish();

function writeMp4(random: Random, { width, height }: Size, frames: readonly Frame[]): Uint8Array<ArrayBuffer> {
  const u32 = (...values: number[]): Uint8Array =>
    big()
      .u32(...values.map((one) => random.size(one) % 2 ** 32))
      .finish();
  const entries = (values: readonly (readonly number[])[]): Uint8Array =>
    concat([u32(values.length), ...values.map((one) => u32(...one))]);
  const start = box(random, 'ftyp', latin1('isom'), u32(512), latin1('isomiso2mp41'));
  const data = concat(frames.map(({ bytes }) => bytes));
  const first = start.length + 8;
  const offsets: number[] = [];
  frames.reduce((at, { bytes }) => (offsets.push(at), at + bytes.length), first);
  const codec = random.or('vp09', 'av01', 'avc1', 'mp4v', 'hvc1');
  const entry = box(
    random,
    codec,
    new Uint8Array(6),
    big()
      .u16(1)
      .zeros(16)
      .u16(random.size(width) & 0xffff, random.size(height) & 0xffff)
      .u32(0x480000, 0x480000, 0)
      .u16(1)
      .zeros(32)
      .u16(24, 0xffff)
      .finish(),
    full(random, 'vpcC', big().u8(0, 10, 0x82, 1, 1, 1, 0, 0).finish()),
  );
  const isOneChunk = random.chance(0.5);
  const table = random.shuffle([
    full(random, 'stsd', u32(1), entry),
    full(random, 'stts', entries([[frames.length, 1]])),
    full(random, 'stsc', entries([[1, isOneChunk ? frames.length : 1, 1]])),
    full(random, 'stsz', u32(0, frames.length), u32(...frames.map(({ bytes }) => bytes.length))),
    random.isWild()
      ? full(random, 'co64', u32(1), big().u64(random.size(first)).finish())
      : full(random, 'stco', entries((isOneChunk ? offsets.slice(0, 1) : offsets).map((one) => [one]))),
    full(random, 'stss', entries(frames.flatMap(({ isKey }, i) => (isKey ? [[i + 1]] : [])))),
    ...(random.chance(0.2) ? [full(random, 'ctts', entries([[frames.length, 0]]))] : []),
  ]);
  const media = box(
    random,
    'mdia',
    full(random, 'mdhd', u32(0, 0, 10, frames.length), big().u16(0x55c4, 0).finish()),
    full(random, 'hdlr', u32(0), latin1(random.or('vide', 'soun', 'xxxx')), new Uint8Array(12), latin1('x\0')),
    box(
      random,
      'minf',
      full(random, 'vmhd', new Uint8Array(8)),
      box(random, 'dinf', full(random, 'dref', u32(1), full(random, 'url '))),
      box(random, 'stbl', ...table),
    ),
  );
  const head = full(
    random,
    'tkhd',
    u32(0, 0, 1, 0, frames.length, 0, 0, 0, 0),
    matrix,
    u32(width * 2 ** 16, height * 2 ** 16),
  );
  const track = box(random, 'trak', ...random.shuffle([head, media]));
  const movie = box(
    random,
    'moov',
    full(random, 'mvhd', u32(0, 0, 10, frames.length, 0x10000, 0x01000000, 0, 0), matrix, new Uint8Array(24), u32(2)),
    ...(random.isHostile() ? Array.from({ length: 100 }, () => track) : [track]),
    ...(random.isWild() ? [box(random, 'mvex', full(random, 'trex', u32(1, 1, 1, 0, 0)))] : []),
  );
  const fragment = box(
    random,
    'moof',
    full(random, 'mfhd', u32(1)),
    box(random, 'traf', full(random, 'tfhd', u32(1)), full(random, 'trun', u32(frames.length))),
  );
  return concat([start, ...random.shuffle([box(random, 'mdat', data), movie, ...(random.isWild() ? [fragment] : [])])]);
}
