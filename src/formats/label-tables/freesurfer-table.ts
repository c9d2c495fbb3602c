import { colorOf, linesOf, quote, TableRows } from './label-table.ts';
import type { LabelTable } from './label-table.ts';

/** A row: its numbers follow the name. */
interface Row {
  readonly id: number;
  readonly name: string;
  /** Red, green, blue and alpha, 0..255. */
  readonly numbers: readonly number[];
}

const isWhole = (word: string): boolean => /^[+-]?\d{1,10}$/.test(word);

/**
 * Id, name, red, green, blue, then alpha, and in some tables the tissue type. FreeSurfer's names have no blanks; other
 * programs' names may.
 */
function readRow(line: string): Row | null {
  const words = line.slice(0, 2000).trim().split(/\s+/);
  const first = words.findIndex((_, i) => i >= 2 && words.length - i <= 5 && words.slice(i).every(isWhole));
  if (first < 0 || words.length - first < 3 || !isWhole(words[0])) return null;
  const [red, green, blue, alpha = 0] = words.slice(first).map(Number);
  const numbers = [red, green, blue, alpha];
  return numbers.every((number) => number >= 0 && number <= 255)
    ? { id: Number(words[0]), name: words.slice(1, first).join(' '), numbers }
    : null;
}

export function isFreeSurferTable(text: string): boolean {
  for (const { line } of linesOf(text.slice(0, 65_536), '#')) return readRow(line) !== null;
  return false;
}

/**
 * Reads a FreeSurfer colour table: `No. Label-Name R G B A`. A is transparency: 0 is opaque, 255 is invisible. Some
 * programs (3D Slicer, MRtrix) write 255 for opaque in the same table: if all labels have 255, it means opaque.
 * Source: FreeSurfer, `FreeSurferColorLUT.txt`, and `CTABreadASCII` of its utils/colortab.cpp: alpha = 255 - t
 */
export function readFreeSurferTable(text: string): LabelTable {
  const rows = new TableRows();
  const found: (Row & { readonly where: string })[] = [];
  for (const { where, line } of linesOf(text, '#')) {
    const row = readRow(line);
    if (row) found.push({ where, ...row });
    else rows.refuse(where, quote(line), 'an id, a name, and red, green, blue and alpha from 0 to 255');
  }
  const things = found.filter(({ id }) => id !== 0);
  const isOpacity = things.length > 0 && things.every(({ numbers }) => numbers[3] === 255);
  for (const { where, id, name, numbers } of found) {
    const opacity = (isOpacity ? numbers[3] : 255 - numbers[3]) / 255;
    rows.add(where, { id, name, color: colorOf(numbers.slice(0, 3)), opacity, hidden: false });
  }
  return rows.finish('FreeSurfer');
}
