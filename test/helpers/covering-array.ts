import { remember } from './remember.ts';

/** The chosen level of each factor. */
export type Row<T> = Readonly<Record<string, T>>;

/** List all legal rows; a row has one level of each factor. */
export function listRows<T>(
  factors: Readonly<Record<string, readonly T[]>>,
  isLegal: (row: Row<T>) => boolean,
): Row<T>[] {
  const names = Object.keys(factors);
  const rows: Row<T>[] = [];
  // There may be millions of rows; only the legal ones, which are few, are stored.
  const row: Record<string, T> = {};
  const choose = (at: number): void => {
    if (at === names.length) {
      if (isLegal(row)) rows.push({ ...row });
      return;
    }
    for (const level of factors[names[at]]) {
      row[names[at]] = level;
      choose(at + 1);
    }
  };
  choose(0);
  return rows;
}

/** The pairs of levels of two factors in a row, each as a text that names it. */
export function listPairs<T>(row: Row<T>, name: (level: T) => string): string[] {
  const levels = Object.entries(row).map(([factor, level]) => `${factor}: ${name(level)}`);
  return levels.flatMap((a, i) => levels.slice(i + 1).map((b) => `${a}, ${b}`));
}

/**
 * A covering array of strength two: a small number of rows (not proven minimal) such that each pair of levels that occurs in any row is
 * in one of them. The next row is always the one with the largest number of pairs that are left.
 * Source: the greedy construction, Cohen, Dalal, Fredman, Patton, *The AETG system*, 1997, over all rows
 */
export function coverPairs<T>(rows: readonly Row<T>[], name: (level: T) => string): Row<T>[] {
  const pairs = numberPairs(rows, remember(name));
  const rowsWith = new Map<number, number[]>();
  for (const [row, some] of pairs.entries()) {
    for (const pair of some) {
      const known = rowsWith.get(pair);
      if (known) known.push(row);
      else rowsWith.set(pair, [row]);
    }
  }
  /** For each row, the number of pairs that no chosen row has. */
  const news = pairs.map((some) => some.length);
  const chosen: Row<T>[] = [];
  while (rowsWith.size > 0) {
    const best = news.reduce((max, count, row) => (count > news[max] ? row : max), 0);
    chosen.push(rows[best]);
    for (const pair of pairs[best]) {
      for (const row of rowsWith.get(pair) ?? []) news[row]--;
      rowsWith.delete(pair);
    }
  }
  return chosen;
}

/** The pairs of `listPairs` for each row, as numbers: this takes a hundredth of the time. */
function numberPairs<T>(rows: readonly Row<T>[], name: (level: T) => string): number[][] {
  const numbers = new Map<string, number>();
  const numbered = rows.map((row) =>
    Object.entries(row).map(([factor, level]) => {
      const text = `${factor}: ${name(level)}`;
      if (!numbers.has(text)) numbers.set(text, numbers.size);
      return numbers.get(text)!;
    }),
  );
  return numbered.map((levels) => levels.flatMap((a, i) => levels.slice(i + 1).map((b) => a * numbers.size + b)));
}
