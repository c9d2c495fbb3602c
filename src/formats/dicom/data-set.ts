import type { Tag } from './tags.ts';

/** Where the value of an element lies in the bytes of its data set. */
export interface Element {
  /** Value representation; '' where the file does not say it. */
  readonly vr: string;
  readonly start: number;
  readonly end: number;
}

type NumberReader = readonly [bytes: number, read: (view: DataView, at: number, littleEndian: boolean) => number];

const binary: Readonly<Record<string, NumberReader>> = {
  US: [2, (view, at, little) => view.getUint16(at, little)],
  SS: [2, (view, at, little) => view.getInt16(at, little)],
  UL: [4, (view, at, little) => view.getUint32(at, little)],
  SL: [4, (view, at, little) => view.getInt32(at, little)],
  FL: [4, (view, at, little) => view.getFloat32(at, little)],
  FD: [8, (view, at, little) => view.getFloat64(at, little)],
  // A tag: its group and its number.
  AT: [4, (view, at, little) => view.getUint16(at, little) * 0x10000 + view.getUint16(at + 2, little)],
};

const isText = (vr: string): boolean => /^(AE|AS|CS|DA|DS|DT|IS|LO|LT|PN|SH|ST|TM|UC|UI|UR|UT)$/.test(vr);

/** Maximum number of values of one element that are read: those that we read have fewer, except for a dose of many frames. */
const maxValues = 2 ** 16;

/** The elements of a file, or of an item of a sequence. */
export class DataSet {
  readonly #elements = new Map<number, Element>();
  readonly #items = new Map<number, readonly DataSet[]>();

  constructor(
    readonly bytes: Uint8Array<ArrayBuffer>,
    readonly littleEndian: boolean,
  ) {}

  set(id: number, element: Element): void {
    this.#elements.set(id, element);
  }

  setItems(id: number, items: readonly DataSet[]): void {
    this.#items.set(id, items);
  }

  has({ id }: Tag): boolean {
    return this.#elements.has(id);
  }

  /** The items of a sequence; none if it is missing. */
  items({ id }: Tag): readonly DataSet[] {
    return this.#items.get(id) ?? [];
  }

  /** The bytes of a value; none if it is missing. */
  bytesOf({ id }: Tag): Uint8Array<ArrayBuffer> {
    const element = this.#elements.get(id);
    return element ? this.bytes.subarray(element.start, element.end) : new Uint8Array();
  }

  /** A text without the spaces around it; '' if it is missing. */
  text(tag: Tag): string {
    return new TextDecoder('latin1').decode(this.bytesOf(tag).subarray(0, maxValues)).replace(/^[\s\0]+|[\s\0]+$/g, '');
  }

  texts(tag: Tag): string[] {
    return this.text(tag)
      .split('\\')
      .map((one) => one.trim());
  }

  /** The numbers of an element, NaN for those that are none; [] if it is missing. @param limit - no more than so many are read */
  numbers(tag: Tag, limit = maxValues): number[] {
    const element = this.#elements.get(tag.id);
    if (!element || element.end === element.start) return [];
    const vr = element.vr in binary || isText(element.vr) ? element.vr : tag.vr;
    if (!(vr in binary)) {
      const max = limit * 17; // Digits of a number, and what divides it from the next one.
      const text = new TextDecoder('latin1').decode(
        this.bytes.subarray(element.start, Math.min(element.end, element.start + max)),
      );
      return text
        .split('\\', limit)
        .map((one) => one.replace(/[\s\0]+/g, ''))
        .map((one) => (one === '' ? NaN : Number(one)));
    }
    const [size, read] = binary[vr];
    const view = new DataView(this.bytes.buffer, this.bytes.byteOffset + element.start, element.end - element.start);
    const count = Math.min(limit, Math.floor(view.byteLength / size));
    return Array.from({ length: count }, (_, i) => read(view, i * size, this.littleEndian));
  }

  /** The first number of an element; undefined if it is missing, or no finite number. */
  number(tag: Tag): number | undefined {
    const [first] = this.numbers(tag);
    return Number.isFinite(first) ? first : undefined;
  }
}
