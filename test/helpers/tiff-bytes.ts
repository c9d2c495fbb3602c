// Makes TIFF files. Source: TIFF 6.0; BigTIFF of libtiff. tifffile 2026.3.3 reads what it makes (test/unit/formats/tiff/tiff-damage.test.ts).

/** Type, then values; a text is ASCII. */
export type TiffEntry = readonly [type: number, ...values: (number | string)[]];

export interface TiffPageBytes {
  /** By their tag. Those of the one strip, 273 and 279, are added where they are absent. */
  readonly entries: Readonly<Record<number, TiffEntry>>;
  readonly strip?: Uint8Array;
  /** Where the next page is said to lie, in place of where it does: the index of a page, or an address. */
  readonly next?: { readonly page: number } | { readonly address: number };
}

export interface TiffForm {
  readonly isBig?: boolean;
  readonly littleEndian?: boolean;
}

const sizes: Readonly<Record<number, number>> = { 1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 7: 1, 11: 4, 12: 8, 13: 4, 16: 8 };

/** Gray pages of this size, of 8 bits. */
export function grayPage(
  columns: number,
  rows: number,
  strip: Uint8Array = new Uint8Array(columns * rows),
  more: TiffPageBytes['entries'] = {},
): TiffPageBytes {
  return {
    entries: { 256: [4, columns], 257: [4, rows], 258: [3, 8], 259: [3, 1], 262: [3, 1], 277: [3, 1], ...more },
    strip,
  };
}

/** The first strip lies right after the header. */
export const firstStrip = 8;

export function tiffBytes(
  pages: readonly TiffPageBytes[],
  { isBig = false, littleEndian = true }: TiffForm = {},
): Uint8Array<ArrayBuffer> {
  const bytes: number[] = [];
  const put = (value: number, size: number): void => {
    bytes.push(...digits(value, size, littleEndian));
  };
  const patch = (at: number, value: number): void => {
    const size = isBig ? 8 : 4;
    for (let i = 0; i < size; i++) bytes[at + (littleEndian ? i : size - 1 - i)] = Math.floor(value / 256 ** i) % 256;
  };
  const address = isBig ? 8 : 4;
  bytes.push(...(littleEndian ? [0x49, 0x49] : [0x4d, 0x4d]));
  put(isBig ? 43 : 42, 2);
  if (isBig) [8, 0].forEach((value) => put(value, 2));
  const links = [bytes.length];
  put(0, address);
  const starts: number[] = [];
  for (const { entries, strip = new Uint8Array() } of pages) {
    const at = bytes.length;
    for (const byte of strip) bytes.push(byte);
    if (bytes.length % 2) bytes.push(0);
    const all = { 273: [4, at], 279: [4, strip.length], ...entries } as Record<number, TiffEntry>;
    const tags = Object.keys(all).map(Number);
    tags.sort((a, b) => a - b);
    // Values that do not fit into their entry lie before the directory.
    const places = new Map<number, number>();
    for (const tag of tags) {
      const values = encode(all[tag], littleEndian);
      if (values.length <= address) continue;
      places.set(tag, bytes.length);
      bytes.push(...values);
      if (bytes.length % 2) bytes.push(0);
    }
    starts.push(bytes.length);
    put(tags.length, isBig ? 8 : 2);
    for (const tag of tags) {
      const [type, ...values] = all[tag];
      put(tag, 2);
      put(type, 2);
      put(type === 2 ? encode(all[tag], littleEndian).length : values.length / (type === 5 ? 2 : 1), address);
      const own = encode(all[tag], littleEndian);
      if (own.length > address) put(places.get(tag)!, address);
      else bytes.push(...own, ...Array.from({ length: address - own.length }, () => 0));
    }
    links.push(bytes.length);
    put(0, address);
  }
  links.forEach((at, i) => {
    const next = i > 0 ? pages[i - 1].next : undefined;
    patch(at, next ? ('page' in next ? starts[next.page] : next.address) : (starts[i] ?? 0));
  });
  return Uint8Array.from(bytes);
}

function encode([type, ...values]: TiffEntry, littleEndian: boolean): number[] {
  if (type === 2) return [...new TextEncoder().encode(String(values[0])), 0];
  const size = type === 5 ? 4 : (sizes[type] ?? 4);
  return values.flatMap((value) => {
    if (type === 11 || type === 12) {
      const view = new DataView(new ArrayBuffer(size));
      if (type === 11) view.setFloat32(0, Number(value), littleEndian);
      else view.setFloat64(0, Number(value), littleEndian);
      return [...new Uint8Array(view.buffer)];
    }
    return digits(Number(value), size, littleEndian);
  });
}

const digits = (value: number, size: number, littleEndian: boolean): number[] =>
  Array.from({ length: size }, (_, i) => Math.floor(value / 256 ** (littleEndian ? i : size - 1 - i)) % 256);
