import { cellsOf, colorOf, columnsOf, quote, TableRows } from './label-table.ts';
import type { LabelTable } from './label-table.ts';

const isNone = (cell: string): boolean => cell === '' || cell.toLowerCase() === 'n/a';

/** Whether a text begins with the columns of a BIDS table. */
export function isBidsTable(text: string): boolean {
  const columns = columnsOf(text, '\t');
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
  for (const { where, cell } of cellsOf(text, '\t')) {
    const index = cell('index');
    if (!/^[+-]?\d+(\.0+)?$/.test(index)) {
      rows.refuse(where, `the index ${quote(index)}`, 'a whole number');
      continue;
    }
    const written = cell('color');
    const color = isNone(written) ? null : readHex(written);
    if (!isNone(written) && !color)
      rows.report(`${where} got the color ${quote(written)}; expected one like "#ff8800". Another one is chosen`);
    const name = [cell('name'), cell('abbreviation')].find((one) => !isNone(one)) ?? '';
    rows.add(where, { id: Number(index), name, color, opacity: 1, hidden: false });
  }
  return rows.finish('BIDS');
}

function readHex(text: string): ReturnType<typeof colorOf> {
  const [, hex] = /^#?([\da-f]{6}|[\da-f]{3})$/i.exec(text) ?? [];
  if (hex === undefined) return null;
  const wide = hex.length === 3 ? hex.replace(/./g, '$&$&') : hex;
  return colorOf([0, 2, 4].map((at) => parseInt(wide.slice(at, at + 2), 16)));
}
