import type { Color } from '../../optics/transfer/transfer-function.ts';

/** What a table says of one label. */
export interface LabelRow {
  /** A whole number. */
  readonly id: number;
  /** '' where the table has none. */
  readonly name: string;
  /** sRGB, 0..1; null where the table has none. */
  readonly color: Color | null;
  /** 0..1 */
  readonly opacity: number;
  readonly hidden: boolean;
}

/** A table of names and colours. */
export interface LabelTable {
  /** Whose table it is: 'BIDS', for instance. */
  readonly format: string;
  /** By id; of several with one id the first. */
  readonly rows: ReadonlyMap<number, LabelRow>;
  /** What could not be used, in words, with the line or the number of the entry. */
  readonly problems: readonly string[];
}

/** Rows of a table at most. */
export const mostRows = 65_536;

/** Problems that are told one by one. */
const mostProblems = 20;

/** Longest name, and what is shown of a text that can't be read. */
const longest = { name: 200, shown: 60 };

/** A part of a stranger's text, for a message. */
export function quote(text: string): string {
  const shown = clean(text, longest.shown);
  return `"${shown}"${text.trim().length > shown.length ? '…' : ''}`;
}

/** Collects the rows of a table, and what is wrong with it. */
export class TableRows {
  readonly rows = new Map<number, LabelRow>();
  readonly problems: string[] = [];
  #more = 0;

  /** @param where - of the row, in words: 'line 3' */
  add(where: string, row: LabelRow): void {
    if (!Number.isSafeInteger(row.id)) return this.refuse(where, `the id ${row.id}`, 'a whole number');
    if (this.rows.has(row.id)) return this.tell(`${where}: label ${row.id} is there already, and the first one holds`);
    if (this.rows.size >= mostRows) return this.tell(`${where}: expected at most ${mostRows.toLocaleString('en')} labels; this one is left out`);
    this.rows.set(row.id, { ...row, name: clean(row.name, longest.name) });
  }

  refuse(where: string, got: string, expected: string): void {
    this.tell(`${where} got ${got}; expected ${expected}. It is left out`);
  }

  tell(problem: string): void {
    if (this.problems.length < mostProblems) this.problems.push(problem);
    else this.#more++;
  }

  finish(format: string): LabelTable {
    const more = this.#more > 0 ? [`and ${this.#more} more of that kind`] : [];
    return { format, rows: this.rows, problems: [...this.problems, ...more] };
  }
}

/** A name in one line, without characters that are no text. */
function clean(text: string, most: number): string {
  return Array.from(text.slice(0, 4 * most).replace(/[\p{Cc}\p{Zl}\p{Zp}\s]+/gu, ' ').trim()).slice(0, most).join('');
}

/** Lines with their numbers, but for empty ones and, where they begin so, comments. */
export function* linesOf(text: string, comment: string | null): Generator<{ readonly where: string; readonly line: string }> {
  let number = 0;
  for (const line of text.split(/\r\n|\n|\r/)) {
    number++;
    if (line.trim() !== '' && !(comment !== null && line.trimStart().startsWith(comment))) yield { where: `line ${number}`, line };
  }
}

/** A colour of three numbers from 0 to 255; null where they are none. */
export function colorOf(channels: readonly number[]): Color | null {
  if (channels.length !== 3 || !channels.every((channel) => channel >= 0 && channel <= 255)) return null;
  return channels.map((channel) => channel / 255) as unknown as Color;
}
