// Products of NEXRAD Level III, byte by byte. Source: Interface Control Document for the RPG to Class 1 User, 2620001, figures 3-3, 3-6, 3-10 and 3-11c

export interface BuiltProduct {
  readonly code: number;
  /** The number of each gate, [radials][gates]; below 16 in packets of runs. */
  readonly numbers: readonly (readonly number[])[];
  /** Halfwords 31 to 46: sixteen numbers, or two floats. */
  readonly levels: readonly number[] | { readonly scale: number; readonly offset: number };
  /** Tenths of a degree. */
  readonly elevation?: number;
  /** When the scan of the volume began, seconds after midnight; 2:05:33 if undefined. */
  readonly seconds?: number;
  /** Of the radar, thousandths of a degree. */
  readonly latitude?: number;
  /** Start of the first radial, and from each one to the next, tenths of a degree. */
  readonly from?: number;
  readonly step?: number;
  /** Packet AF1F, runs of one of sixteen levels; else packet 16. */
  readonly isRuns?: boolean;
  /** What is written over before all is joined. */
  readonly wrong?: { readonly packet?: number; readonly radials?: number; readonly bytes?: number };
  /** The lines of a bulletin before it. */
  readonly lines?: string;
  /** Packs the symbols. */
  readonly pack?: (bytes: Uint8Array) => Uint8Array;
}

/** A radial of runs: how often, and which level. */
function packRuns(numbers: readonly number[]): number[] {
  const bytes: number[] = [];
  for (const number of numbers) {
    const last = bytes.length - 1;
    if (last >= 0 && (bytes[last] & 15) === number && bytes[last] < 0xf0) bytes[last] += 16;
    else bytes.push(16 + number);
  }
  return bytes.length % 2 ? [...bytes, 0] : bytes;
}

function writeSymbols({ numbers, from = 0, step = 10, isRuns = false, wrong = {} }: BuiltProduct): Uint8Array {
  const radials = numbers.map((row) => (isRuns ? packRuns(row) : row.length % 2 ? [...row, 0] : row));
  const length = 30 + radials.reduce((sum, row) => sum + 6 + row.length, 0);
  const bytes = new Uint8Array(length);
  const view = new DataView(bytes.buffer);
  const halfwords = (at: number, ...words: number[]): void =>
    words.forEach((word, i) => view.setUint16(at + 2 * i, word));
  halfwords(0, 0xffff, 1);
  view.setUint32(4, length);
  halfwords(8, 1, 0xffff);
  view.setUint32(12, length - 16);
  halfwords(
    16,
    wrong.packet ?? (isRuns ? 0xaf1f : 16),
    0,
    numbers[0].length,
    256,
    280,
    999,
    wrong.radials ?? radials.length,
  );
  let at = 30;
  radials.forEach((row, radial) => {
    halfwords(at, wrong.bytes ?? (isRuns ? row.length / 2 : row.length), (from + radial * step) % 3600, step);
    bytes.set(row, at + 6);
    at += 6 + row.length;
  });
  return bytes;
}

export function buildLevel3(product: BuiltProduct): Uint8Array<ArrayBuffer> {
  const {
    code,
    levels,
    elevation = 5,
    seconds = 7533,
    latitude = 33172,
    lines = 'SDUS54 KBMX 020205\r\r\nN0QBMX\r\r\n',
    pack,
  } = product;
  const symbols = writeSymbols(product);
  const packed = pack?.(symbols) ?? symbols;
  const head = new DataView(new ArrayBuffer(120));
  head.setInt16(0, code);
  head.setInt16(2, 16438);
  head.setInt32(8, 120 + packed.length);
  head.setInt16(16, 3);
  head.setInt16(18, -1);
  head.setInt32(20, latitude);
  head.setInt32(24, -86770);
  head.setInt16(28, 759);
  head.setInt16(30, code);
  head.setInt16(32, 2);
  head.setInt16(34, 12);
  // 2 January 2015, 02:05:33.
  head.setInt16(40, 16438);
  head.setInt32(42, seconds);
  head.setInt16(58, elevation);
  if ('scale' in levels) {
    head.setFloat32(60, levels.scale);
    head.setFloat32(64, levels.offset);
  } else levels.forEach((level, i) => head.setUint16(60 + 2 * i, level & 0xffff));
  head.setInt32(108, 60);
  if (pack) {
    head.setInt16(100, 1);
    head.setInt32(102, symbols.length);
  }
  const text = new TextEncoder().encode(lines);
  const bytes = new Uint8Array(text.length + 120 + packed.length);
  bytes.set(text);
  bytes.set(new Uint8Array(head.buffer), text.length);
  bytes.set(packed, text.length + 120);
  return bytes;
}

/** Six gates for each of four radials, over all numbers that mean something. */
const bytesOf = (numbers: readonly number[]): number[][] =>
  [0, 1, 2, 3].map((radial) => [0, 1, 2, 3, 4].map((gate) => numbers[(radial * 5 + gate) % numbers.length]));

const digital = bytesOf([0, 1, 2, 3, 66, 100, 200, 255, 128, 129]);
const runs = bytesOf([0, 1, 1, 1, 5, 8, 9, 14, 15, 7, 7]);
/** As products 19 and 27 have them: "no data", dBZ; and knots, the last one "range folded". */
const dbz = [0x8002, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 75];
const knots = [0x8002, 320, 306, 292, 282, 276, 266, 257, 0, 522, 532, 538, 548, 562, 576, 0x8003];

/** One product of each kind, by the name of its file. */
export const builtProducts: Readonly<Record<string, BuiltProduct>> = {
  reflectivity94: { code: 94, numbers: digital, levels: [-320, 5, 254], elevation: 34, from: 3555 },
  velocity99: { code: 99, numbers: digital, levels: [-635, 5, 254], lines: '' },
  reflectivity153: { code: 153, numbers: digital, levels: [-320, 5, 254], step: 5 },
  velocity154: { code: 154, numbers: digital, levels: [-635, 5, 254], step: 5 },
  width155: { code: 155, numbers: digital, levels: [-635, 5, 254], step: 5 },
  ratio159: { code: 159, numbers: digital, levels: { scale: 16, offset: 128 } },
  correlation161: { code: 161, numbers: digital, levels: { scale: 300, offset: -60.5 } },
  phase163: { code: 163, numbers: digital, levels: { scale: 20, offset: 43 } },
  classes165: { code: 165, numbers: bytesOf([0, 10, 20, 30, 60, 100, 140]), levels: [0] },
  reflectivity19: { code: 19, numbers: runs, levels: dbz, isRuns: true },
  velocity27: { code: 27, numbers: runs, levels: knots, isRuns: true },
  airport182: { code: 182, numbers: digital, levels: [-635, 5, 254], elevation: 3 },
};
