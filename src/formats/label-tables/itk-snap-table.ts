import { colorOf, linesOf, quote, TableRows } from './label-table.ts';
import type { LabelTable } from './label-table.ts';

/** IDX, R, G, B, A, VIS, MSH, and the name in quotes. */
const row =
  /^\s*([+-]?\d+)\s+(\d{1,3})\s+(\d{1,3})\s+(\d{1,3})\s+(\d{0,8}\.?\d{1,18}(?:e-?\d{1,2})?)\s+([01])\s+([01])\s+"([^"]*)"\s*$/i;

const longestLine = 1000;

const matchRow = (line: string): RegExpExecArray | null => (line.length > longestLine ? null : row.exec(line));

export function isItkSnapTable(text: string): boolean {
  for (const { line } of linesOf(text.slice(0, 65_536), '#')) return matchRow(line) !== null;
  return false;
}

/**
 * Reads a label description file of ITK-SNAP: `IDX R G B A VIS MSH "LABEL"`, with colours from 0 to 255, A from 0 to 1
 * where 1 is opaque, and whether the label is visible. The visibility of its mesh (MSH) is ignored.
 * Source: the comment that ITK-SNAP writes at the beginning of these files, and `ColorLabelTable::LoadFromFile`
 */
export function readItkSnapTable(text: string): LabelTable {
  const rows = new TableRows();
  for (const { where, line } of linesOf(text, '#')) {
    const match = matchRow(line);
    const color = match && colorOf(match.slice(2, 5).map(Number));
    const opacity = Number(match?.[5]);
    if (!match || !color || !(opacity <= 1))
      rows.refuse(
        where,
        quote(line),
        'an id, red, green and blue from 0 to 255, alpha from 0 to 1, two flags, and a name in quotes',
      );
    else rows.add(where, { id: Number(match[1]), name: match[8], color, opacity, hidden: match[6] === '0' });
  }
  return rows.finish('ITK-SNAP');
}
