// A table from stored numbers to values (Modality LUT), which some scanners write in place of a slope and an intercept.
// Source: DICOM PS3.3, C.11.1
import { corruptFile } from '../base/file-problem.ts';
import type { DataSet } from './data-set.ts';
import type { Picture } from './picture.ts';
import { sequences, tags } from './tags.ts';

export interface ValueTable {
  /** The stored number of the first value. Smaller numbers have the first value, and those behind the table its last one. */
  readonly first: number;
  readonly values: Uint16Array;
  /** The largest of the values: a table of 16 bits may have those of 10 bits. */
  readonly largest: number;
  /** What the values are: 'HU', 'OD' (thousandths of an optical density), or 'US' for no unit. */
  readonly type: string;
}

/**
 * @returns null where the file has no table, or one that leads back to the X-rays on the detector and is not for display
 * @throws {VolumeViewError} `format/corrupt` where the table is cut short
 */
export function readValueTable({ set, isSigned, what }: Picture): ValueTable | null {
  const table = set.items(sequences.modalityTable)[0] as DataSet | undefined;
  if (!table || /^(LOG|DISP)$/.test(set.text(tags.pixelIntensity).toUpperCase())) return null;
  // The file may give the three as numbers with a sign, or without one, whatever they are.
  const [count, start, bits] = table.numbers(tags.tableDescriptor).map((number) => number & 0xffff);
  const entries = count || 2 ** 16;
  const bytes = table.bytesOf(tags.tableData);
  if (!(bits >= 8 && bits <= 16 && bytes.length >= entries * (bits > 8 ? 2 : 1)))
    throw corruptFile(
      what,
      `gives its values by a table, which is cut short: got ${bytes.length.toLocaleString('en')} bytes for ${entries.toLocaleString('en')} values. Copy the file again`,
    );
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const little = table.littleEndian;
  // Values of 8 bits may stand in words of 16.
  const read =
    bytes.length >= 2 * entries
      ? (i: number) => view.getUint16(2 * i, little)
      : (i: number) => bytes[little ? i : i ^ 1];
  const values = Uint16Array.from({ length: entries }, (_, i) => read(i));
  return {
    first: isSigned && start >= 2 ** 15 ? start - 2 ** 16 : start,
    values,
    largest: values.reduce((largest, value) => Math.max(largest, value), 0),
    type: table.text(tags.modalityTableType).toUpperCase(),
  };
}

/** What a stored number stands for before slope and intercept. */
export function lookUp(table: ValueTable | null, number: number): number {
  if (!table) return number;
  const { first, values } = table;
  return values[Math.max(0, Math.min(values.length - 1, number - first))];
}
