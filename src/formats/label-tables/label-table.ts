import type { Color } from '../../optics/transfer/transfer-function.ts';

/** One row of a table: one label. */
export interface LabelRow {
  /** A whole number. */
  readonly id: number;
  /** '' if the table has none. */
  readonly name: string;
  /** sRGB, 0..1; null if the table has none. */
  readonly color: Color | null;
  /** 0..1 */
  readonly opacity: number;
  readonly hidden: boolean;
}

/** A table of names and colours. */
export interface LabelTable {
  /** The table's format, for example 'BIDS'. */
  readonly format: string;
  /** By id. If several rows have one id, the first counts. */
  readonly rows: ReadonlyMap<number, LabelRow>;
  /** What could not be used, in words, with the line or the number of the entry. */
  readonly problems: readonly string[];
}

/** Maximum number of rows of a table. */
export const maxRows = 65_536;

/** Maximum number of problems that are listed one by one. */
const maxProblems = 20;

/** Maximum length of a name, and of the part of an unreadable text that is shown. */
const longest = { name: 200, shown: 60 };

/** The beginning of a stranger's text, for a message. */
export function quote(text: string): string {
  const shown = clean(text, longest.shown);
  return `"${shown}"${text.trim().length > shown.length ? '…' : ''}`;
}

/** Collects the rows of a table and its problems. */
export class TableRows {
  readonly rows = new Map<number, LabelRow>();
  readonly problems: string[] = [];
  #more = 0;

  /** @param where - of the row, in words: 'line 3' */
  add(where: string, row: LabelRow): void {
    if (!Number.isSafeInteger(row.id)) return this.refuse(where, `the id ${row.id}`, 'a whole number');
    if (this.rows.has(row.id))
      return this.report(`${where}: label ${row.id} is there already, and the first one holds`);
    if (this.rows.size >= maxRows)
      return this.report(`${where}: expected at most ${maxRows.toLocaleString('en')} labels; this one is left out`);
    this.rows.set(row.id, { ...row, name: clean(row.name, longest.name) });
  }

  refuse(where: string, got: string, expected: string): void {
    this.report(`${where} got ${got}; expected ${expected}. It is left out`);
  }

  report(problem: string): void {
    if (this.problems.length < maxProblems) this.problems.push(problem);
    else this.#more++;
  }

  finish(format: string): LabelTable {
    const more = this.#more > 0 ? [`and ${this.#more} more of that kind`] : [];
    return { format, rows: this.rows, problems: [...this.problems, ...more] };
  }
}

/** A name in one line, without control characters. */
function clean(text: string, maxLength: number): string {
  return Array.from(
    text
      .slice(0, 4 * maxLength)
      .replace(/[\p{Cc}\p{Zl}\p{Zp}\s]+/gu, ' ')
      .trim(),
  )
    .slice(0, maxLength)
    .join('');
}

/** Lines with their numbers, without empty lines and lines that begin with the comment sign. */
export function* linesOf(
  text: string,
  comment: string | null,
): Generator<{ readonly where: string; readonly line: string }> {
  let number = 0;
  for (const line of text.split(/\r\n|\n|\r/)) {
    number++;
    if (line.trim() !== '' && !(comment !== null && line.trimStart().startsWith(comment)))
      yield { where: `line ${number}`, line };
  }
}

type Separator = '\t' | ',';

/** The names of the columns that a text begins with, in small letters. */
export function columnsOf(text: string, separator: Separator): readonly string[] {
  const [line] = text.slice(0, 4096).split(/\r\n|\n|\r/, 1);
  return splitCells(line, separator).map((column) => column.trim().toLowerCase());
}

/** The rows below a line with the names of columns. A cell that a row or the table lacks is ''. */
export function* cellsOf(
  text: string,
  separator: Separator,
): Generator<{ readonly where: string; readonly cell: (column: string) => string }> {
  let columns: readonly string[] | null = null;
  for (const { where, line } of linesOf(text, null)) {
    if (!columns) {
      columns = columnsOf(line, separator);
      continue;
    }
    const [names, cells] = [columns, splitCells(line, separator)];
    yield { where, cell: (column) => cells[names.indexOf(column)]?.trim() ?? '' };
  }
}

/** Longer lines are none of names. */
const longestLine = 10_000;

/** A quote in quotes is written twice. A quote that does not begin a cell is a sign as others are. */
function splitCells(line: string, separator: Separator): string[] {
  if (!line.includes('"') || line.length > longestLine) return line.split(separator);
  return Array.from(
    line.matchAll(new RegExp(`(?:"((?:[^"]|"")*)"|([^${separator}]*))(?:${separator}|$)`, 'g')),
    ([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain,
  );
}

/** A colour of three numbers from 0 to 255; null if they are not in that range. */
export function colorOf(channels: readonly number[]): Color | null {
  if (channels.length !== 3 || !channels.every((channel) => channel >= 0 && channel <= 255)) return null;
  return channels.map((channel) => channel / 255) as unknown as Color;
}
