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

/** Numbers after a name: red, green, blue, then alpha, and in some tables the tissue type. */
const [fewest, usual, most] = [3, 4, 5];

/** The words of a line, and how many of the last ones are numbers. */
interface Words {
  readonly words: readonly string[];
  readonly numbers: number;
}

function splitLine(line: string): Words {
  const words = line.slice(0, 2000).trim().split(/\s+/);
  let numbers = 0;
  while (numbers < Math.min(most, words.length - 2) && isWhole(words[words.length - 1 - numbers])) numbers++;
  return { words, numbers };
}

/**
 * How many numbers follow the names of a table. FreeSurfer's names have no blanks; other programs' names may, and may end in a number: "area
 * 17". In a table with tissue types most rows have one alpha.
 */
function countNumbers(text: string): number {
  const alphas = new Map<string, number>();
  let [all, withFewest, withMost, alike] = [0, 0, 0, 0];
  for (const { line } of linesOf(text, '#')) {
    const { words, numbers } = splitLine(line);
    if (numbers < fewest) continue;
    all++;
    if (numbers === fewest) withFewest++;
    if (numbers !== most) continue;
    withMost++;
    const alpha = words[words.length - 2];
    const same = (alphas.get(alpha) ?? 0) + 1;
    alphas.set(alpha, same);
    alike = Math.max(alike, same);
  }
  if (2 * withMost > all && 2 * alike > withMost) return most;
  return 2 * withFewest > all ? fewest : usual;
}

function readRow({ words, numbers: found }: Words, expected: number): Row | null {
  const first = words.length - Math.min(found, expected);
  if (found < fewest || !isWhole(words[0])) return null;
  const [red, green, blue, alpha = 0] = words.slice(first).map(Number);
  const numbers = [red, green, blue, alpha];
  return numbers.every((number) => number >= 0 && number <= 255)
    ? { id: Number(words[0]), name: words.slice(1, first).join(' '), numbers }
    : null;
}

export function isFreeSurferTable(text: string): boolean {
  for (const { line } of linesOf(text.slice(0, 65_536), '#')) {
    const words = splitLine(line);
    return readRow(words, words.numbers) !== null;
  }
  return false;
}

/**
 * Reads a FreeSurfer colour table: `No. Label-Name R G B A`. A is transparency: 0 is opaque, 255 is invisible. Some
 * programs (3D Slicer, MRtrix) write 255 for opaque in the same table: it means so where 3D Slicer says that it wrote it, and where most labels
 * have 255, as nobody hides most of them.
 * Source: FreeSurfer, `FreeSurferColorLUT.txt`, and `CTABreadASCII` of its utils/colortab.cpp: alpha = 255 - t; 3D Slicer, developer guide,
 * "Color table text file format"
 */
export function readFreeSurferTable(text: string): LabelTable {
  const rows = new TableRows();
  const found: (Row & { readonly where: string })[] = [];
  const expected = countNumbers(text);
  for (const { where, line } of linesOf(text, '#')) {
    const row = readRow(splitLine(line), expected);
    if (row) found.push({ where, ...row });
    else rows.refuse(where, quote(line), 'an id, a name, and red, green, blue and alpha from 0 to 255');
  }
  const things = found.filter(({ id }) => id !== 0);
  const isOpacity =
    /^\s*# Color table file\b/.test(text) ||
    2 * things.filter(({ numbers }) => numbers[3] === 255).length > things.length;
  for (const { where, id, name, numbers } of found) {
    const opacity = (isOpacity ? numbers[3] : 255 - numbers[3]) / 255;
    rows.add(where, { id, name, color: colorOf(numbers.slice(0, 3)), opacity, hidden: false });
  }
  return rows.finish('FreeSurfer');
}
