import { colorOf, linesOf, quote, splitCells, TableRows } from './label-table.ts';
import type { LabelTable } from './label-table.ts';

const isNone = (cell: string | undefined): boolean =>
  cell === undefined || cell.trim() === '' || cell.trim().toLowerCase() === 'n/a';

/** Whether a text begins with the columns of a BIDS table. */
export function isBidsTable(text: string): boolean {
  const columns = columnsOf(text.slice(0, 4096).split(/\r\n|\n|\r/, 1)[0]);
  return columns.includes('index') && columns.includes('name');
}

/**
 * Reads a BIDS table: columns `index`, `name`, `abbreviation`, `color` and `mapping` in any order, separated by tabs;
 * `n/a` means no value. Cells may be in quotes, as those with tabs are, which pandas writes so.
 * Source: Brain Imaging Data Structure 1.10, Imaging data derivative, "Custom labels" (`*_dseg.tsv`), and its common
 * principles for tabular files
 */
export function readBidsTable(text: string): LabelTable {
  const rows = new TableRows();
  let columns: string[] | null = null;
  for (const { where, line } of linesOf(text, null)) {
    if (!columns) {
      columns = columnsOf(line);
      continue;
    }
    const cells = splitCells(line, '\t');
    const cell = (name: string): string | undefined => cells[columns!.indexOf(name)];
    const index = cell('index')?.trim() ?? '';
    if (!/^[+-]?\d+(\.0+)?$/.test(index)) {
      rows.refuse(where, `the index ${quote(index)}`, 'a whole number');
      continue;
    }
    const written = isNone(cell('color')) ? null : cell('color')!.trim();
    const color = written === null ? null : readHex(written);
    if (written !== null && !color)
      rows.report(`${where} got the color ${quote(written)}; expected one like "#ff8800". Another one is chosen`);
    const name = [cell('name'), cell('abbreviation')].find((one) => !isNone(one)) ?? '';
    rows.add(where, { id: Number(index), name, color, opacity: 1, hidden: false });
  }
  return rows.finish('BIDS');
}

function columnsOf(line: string): string[] {
  return splitCells(line, '\t').map((column) => column.trim().toLowerCase());
}

function readHex(text: string): ReturnType<typeof colorOf> {
  const [, hex] = /^#?([\da-f]{6}|[\da-f]{3})$/i.exec(text) ?? [];
  if (hex === undefined) return null;
  const wide = hex.length === 3 ? hex.replace(/./g, '$&$&') : hex;
  return colorOf([0, 2, 4].map((at) => parseInt(wide.slice(at, at + 2), 16)));
}
